/** Which mission the report is about: one answer of the server brings it, whether the graph was edited or the text. */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import type { Mission, Report } from "../model/types";

const useChecked = create<{ mission: Mission | null }>(() => ({ mission: null }));

/** Takes a report that is about that mission. */
export function acceptReport(report: Report, mission: Mission): void {
  useChecked.setState({ mission });
  useStudio.getState().setReport(report);
}

let coming = false;

/** Makes a change of the mission whose report came along with it. */
export function changeChecked(report: Report, change: () => void): void {
  coming = true;
  try {
    change();
  } finally {
    coming = false;
  }
  acceptReport(report, useStudio.getState().mission);
}

/** The report may be wrong about its mission, since something around it changed. */
export function forgetReport(): void {
  useChecked.setState({ mission: null });
}

/** Whether the report is about that very mission, or is about to be. */
export function isChecked(mission: Mission): boolean {
  return coming || (useStudio.getState().report !== null && useChecked.getState().mission === mission);
}

/** Whether the report lags behind what the person has done. */
export function useBehind(): boolean {
  const checked = useChecked((state) => state.mission);
  return useStudio((state) => state.report === null || state.mission !== checked);
}
