/** What a mission says about trying it out: failures on schedule, the radio, robots that break down. */
import { t } from "../../i18n/words";
import { type Command, commandTo, withOptional } from "../command";
import type { Breakdown, Mission, Radio, ScheduledFailure } from "../types";

/** Other failures on schedule, in the order of time; null when they are the same. */
export function setFailures(mission: Mission, failures: readonly ScheduledFailure[]): Command | null {
  const list = [...failures].sort((a, b) => a.at_s - b.at_s);
  if (JSON.stringify(list) === JSON.stringify(mission.failures ?? [])) return null;
  return commandTo(t("command.failures"), withOptional(mission, { failures: list }));
}

/** Another radio, or none; null when it is the same. */
export function setRadio(mission: Mission, radio: Radio | null): Command | null {
  if (JSON.stringify(mission.radio ?? null) === JSON.stringify(radio)) return null;
  return commandTo(t("command.radio"), withOptional(mission, { radio }));
}

/** What becomes of robots that fail on a road; null when it is the same. */
export function setBreakdown(mission: Mission, breakdown: Breakdown): Command | null {
  const made = breakdown.rule === "stay" ? null : breakdown.rule === "tow" ? breakdown : { ...breakdown, after_s: 0 };
  if (JSON.stringify(mission.breakdown ?? null) === JSON.stringify(made)) return null;
  return commandTo(t("command.breakdown"), withOptional(mission, { breakdown: made }));
}
