/** What is chosen for the next study, besides what varies. */
import { create } from "zustand";

import type { ExperimentAsk, ExperimentChoices } from "../../api/generated";
import { plainDigits, readNumber } from "../../i18n/numbers";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import type { VariedAxis } from "../../session/varied-axes";

interface Setup {
  seeds: string;
  measures: readonly string[];
  /** A measure in the words of the user, such as `time all carry (…)`; "" for none. */
  own: string;
  seconds: string;
}

export const LONGEST_S = 36_000;

export const useSetup = create<Setup>(() => ({
  seeds: "1-20",
  measures: ["seconds", "done"],
  own: "",
  seconds: "600",
}));

export function changeSetup(change: Partial<Setup>): void {
  useSetup.setState(change);
}

export function toggleMeasure(name: string): void {
  useSetup.setState(({ measures }) => ({
    measures: measures.includes(name) ? measures.filter((one) => one !== name) : [...measures, name],
  }));
}

/** The seconds that were typed; null for none that a run can have. */
export function secondsOf({ seconds }: Pick<Setup, "seconds">): number | null {
  const found = readNumber(seconds);
  return found !== null && found > 0 && found <= LONGEST_S ? found : null;
}

/** The values of an axis: those that were typed, or those that the server proposes. */
export function valuesOf({ address, values }: VariedAxis, choices: ExperimentChoices | null): string {
  const typed = plainDigits(values).trim();
  return typed === "" ? (choices?.addresses.find((one) => one.address === address)?.example ?? "") : typed;
}

/** What is asked of the server; null while something is missing that only the user knows. */
export function askedOf(
  setup: Setup,
  axes: readonly VariedAxis[],
  choices: ExperimentChoices | null,
): ExperimentAsk | null {
  const { mission, file } = useStudio.getState();
  const offered = choices?.measures ?? [];
  // Measures of another mission stay chosen, and are not asked of this one.
  const measures = [
    ...setup.measures.filter((one) => offered.includes(one)),
    ...(setup.own.trim() ? [setup.own.trim()] : []),
  ];
  const seconds = secondsOf(setup);
  if (measures.length === 0 || seconds === null || choices === null) return null;
  return {
    mission,
    path: file.path,
    axes: axes.map((axis) => ({ address: axis.address, values: valuesOf(axis, choices) || "?" })),
    seeds: plainDigits(setup.seeds).trim() || "?",
    measures,
    seconds,
    fail_rate: useRun.getState().failRate,
  };
}
