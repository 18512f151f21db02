/** What a mission says about trying it out: failures on schedule, the radio, robots that break down. */
import { t } from "../../i18n/words";
import { becomes, type Command } from "../command";
import type { Breakdown, Mission, Radio, ScheduledFailure } from "../types";

// An empty list is left out; everything else stays the same objects, by which it is seen what changed.

function withFailures(mission: Mission, failures: ScheduledFailure[]): Mission {
  const { failures: _, ...rest } = mission;
  return failures.length === 0 ? rest : { ...rest, failures };
}

/** Other failures on schedule, in the order of time; null when they are the same. */
export function setFailures(mission: Mission, failures: readonly ScheduledFailure[]): Command | null {
  const list = [...failures].sort((a, b) => a.at_s - b.at_s);
  if (JSON.stringify(list) === JSON.stringify(mission.failures ?? [])) return null;
  return becomes(t("command.failures"), withFailures(mission, list));
}

/** Another radio, or none; null when it is the same. */
export function setRadio(mission: Mission, radio: Radio | null): Command | null {
  const { radio: old = null, ...rest } = mission;
  if (JSON.stringify(old) === JSON.stringify(radio)) return null;
  return becomes(t("command.radio"), radio === null ? rest : { ...rest, radio });
}

/** What becomes of robots that fail on a road; null when it is the same. */
export function setBreakdown(mission: Mission, breakdown: Breakdown): Command | null {
  const { breakdown: old = null, ...rest } = mission;
  const made = breakdown.rule === "stay" ? null : breakdown.rule === "tow" ? breakdown : { ...breakdown, after_s: 0 };
  if (JSON.stringify(old) === JSON.stringify(made)) return null;
  return becomes(t("command.breakdown"), made === null ? rest : { ...rest, breakdown: made });
}
