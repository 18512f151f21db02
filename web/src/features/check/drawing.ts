/**
 * The check while one draws: when an edit was followed by a quiet moment and the mission has no errors, the server looks
 * through it in the background. What it finds stands with the other problems until the next edit, which also ends a look
 * that is under way. What cannot be checked, or not in time, says nothing.
 */
import type { DrawingCheckMessage, WorkRefusedMessage } from "../../api/generated";
import { beginWork, type Work } from "../../api/work";
import { useStudio } from "../../model/studio";
import type { Mission, Report } from "../../model/types";
import { isChecked } from "../../session/report";
import { showsProblem } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import { endAll } from "../../ui/effects";
import { useCheck } from "./check-session";

/** Nobody draws for so long before it is asked for. */
const QUIET_MS = 1500;

/** Begins to look through the mission, which was edited, and again after each edit; the returned function ends it. */
export function checkWhileDrawing(): () => void {
  let work: Work | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  /** The report to which the findings were added: it is not asked about again. */
  let added: Report | null = null;
  let opened: Mission | null = null;

  const leaveOff = () => {
    clearTimeout(timer);
    work?.hangUp();
    work = null;
  };
  const ask = () => {
    const { mission, file, report } = useStudio.getState();
    if (report === null || !isChecked(mission) || useCheck.getState().busy) return;
    const asked = { mission, path: file.path, seed: useRun.getState().seed };
    work = beginWork<DrawingCheckMessage | WorkRefusedMessage>("api/drawing-check", asked, {
      onMessage: (message) => {
        work = null;
        const now = useStudio.getState();
        if (message.type === "found" && message.findings.length > 0 && now.report === report) {
          for (const { problem, shown } of message.findings) if (shown !== null) showsProblem(problem, asked, shown);
          added = { ...report, problems: [...report.problems, ...message.findings.map(({ problem }) => problem)] };
          now.setReport(added);
        }
        return true;
      },
      onLost: () => undefined,
    });
  };
  const consider = () => {
    leaveOff();
    const { report, mission } = useStudio.getState();
    const runs = report?.problems.every(({ severity }) => severity !== "error") === true && mission.agents.length > 0;
    if (runs && mission !== opened) timer = setTimeout(ask, QUIET_MS);
  };
  consider();
  const off = useStudio.subscribe((state, before) => {
    if (state.change !== before.change && state.change.kind === "open") opened = state.mission;
    if (state.mission !== before.mission) leaveOff();
    if (state.report !== before.report && state.report !== added) consider();
  });
  return endAll(off, leaveOff);
}
