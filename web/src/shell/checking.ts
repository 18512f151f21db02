/**
 * Keeps the report fresh: every change of the mission is checked by the server a moment later.
 *
 * Of answers only the newest counts: a question that was overtaken is called off and its answer dropped. While the server
 * cannot be reached the last report stands, one banner says so, and the next change asks again.
 */
import { api } from "../api/client";
import type { Mission, Report } from "../api/types";
import { useStudio } from "../model/studio";
import { complain, dismissBanner, useDocument } from "./document";

const QUIET_MS = 60;

interface Checker<Answer> {
  check: (mission: Mission, path: string, signal: AbortSignal) => Promise<Answer>;
  accept: (answer: Answer) => void;
  fail: (cause: unknown) => void;
}

/** Debounced and newest-wins; the returned function asks for a check. */
export function makeChecker<Answer = Report>({
  check,
  accept,
  fail,
}: Checker<Answer>): (mission: Mission, path: string) => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let under: AbortController | null = null;
  return (mission, path) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      under?.abort();
      const mine = new AbortController();
      under = mine;
      check(mission, path, mine.signal).then(
        (answer) => {
          if (under === mine) accept(answer);
        },
        (cause: unknown) => {
          if (under === mine && !mine.signal.aborted) fail(cause);
        },
      );
    }, QUIET_MS);
  };
}

/** Starts checking; the returned function ends it. */
export function keepChecking(): () => void {
  let complained = false;
  const request = makeChecker({
    check: api.check,
    accept: (report) => {
      useStudio.getState().setReport(report);
      if (complained) dismissBanner();
      complained = false;
    },
    fail: (cause) => {
      complained = true;
      complain(cause, () => request(useStudio.getState().mission, useStudio.getState().file.path));
    },
  });
  const again = () => {
    const { mission, file } = useStudio.getState();
    if (useDocument.getState().ready && mission.programs.length > 0) request(mission, file.path);
  };
  again();
  const offMission = useStudio.subscribe((state, before) => {
    if (state.mission !== before.mission) again();
  });
  const offReady = useDocument.subscribe((state, before) => {
    if (state.ready && !before.ready) again();
  });
  return () => {
    offMission();
    offReady();
  };
}
