/**
 * Keeps the report fresh: every change of the mission is checked by the server at once, while the page draws it.
 *
 * One question is asked at a time; while it is under way the newest change waits. Of answers only the newest counts: one that
 * was overtaken is dropped. A change whose report came with it (a typed text) is not asked about again. While the server
 * cannot be reached the last report stands, one banner says so, and the next change asks again.
 */
import { create } from "zustand";

import { api } from "../api/client";
import { type Language, languageInUse } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { Mission, Report } from "../model/types";
import { acceptReport, forgetReport, isChecked } from "./report";
import { dismissBanner, reportError, useDocument } from "./document";

/** A question that takes longer than this is called off when there is a newer one. */
const PATIENCE_MS = 3000;

interface Checking {
  /** What the report that stands is said in. */
  language: Language;
  ask: () => void;
}

const NOTHING = () => undefined;
const useChecking = create<Checking>(() => ({ language: languageInUse(), ask: NOTHING }));

interface Checker<Answer> {
  check: (mission: Mission, path: string, signal: AbortSignal) => Promise<Answer>;
  accept: (answer: Answer, mission: Mission) => void;
  fail: (cause: unknown) => void;
  /** Whether the report on that mission is known already. */
  known?: (mission: Mission) => boolean;
}

/** One at a time and newest-wins; the returned function asks for a check. */
export function makeChecker<Answer = Report>({
  check,
  accept,
  fail,
  known,
}: Checker<Answer>): (mission: Mission, path: string) => void {
  let wanted: { mission: Mission; path: string } | null = null;
  let under: { controller: AbortController; begun_ms: number } | null = null;

  const next = () => {
    if (under !== null && performance.now() - under.begun_ms > PATIENCE_MS) under.controller.abort();
    if (under !== null || wanted === null) return;
    const { mission, path } = wanted;
    wanted = null;
    if (known?.(mission) === true) return;
    const controller = new AbortController();
    under = { controller, begun_ms: performance.now() };
    const answered = (tell: () => void) => {
      under = null;
      if (wanted === null) tell();
      else next();
    };
    check(mission, path, controller.signal).then(
      (answer) => answered(() => accept(answer, mission)),
      (cause: unknown) => answered(() => fail(cause)),
    );
  };
  return (mission, path) => {
    wanted = { mission, path };
    next();
  };
}

/** Checks once more, though nothing changed: the request before may have failed. */
export function checkAgain(): void {
  useChecking.getState().ask();
}

/** Starts checking; the returned function ends it. */
export function keepChecking(): () => void {
  let complained = false;
  const request = makeChecker({
    check: api.check,
    known: isChecked,
    accept: (report, mission) => {
      acceptReport(report, mission);
      if (complained && useDocument.getState().banner?.kind === "error") dismissBanner();
      complained = false;
    },
    fail: (cause) => {
      complained = true;
      reportError(cause, () => request(useStudio.getState().mission, useStudio.getState().file.path));
    },
  });
  let timer: ReturnType<typeof setTimeout> | undefined;
  const now = () => {
    timer = undefined;
    const { mission, file } = useStudio.getState();
    if (useDocument.getState().ready && mission.programs.length > 0) request(mission, file.path);
  };
  const again = () => {
    // Of a mission that was just opened its picture is waited for, not what the server says of it.
    if (useStudio.getState().report === null) timer ??= setTimeout(now, 0);
    else now();
  };
  const language = languageInUse();
  if (useChecking.getState().language !== language) forgetReport();
  useChecking.setState({ language, ask: now });
  again();
  const offMission = useStudio.subscribe((state, before) => {
    // Robots, constructors or the world are other ones: what was said of the mission may be wrong now.
    const place = state.world !== before.world && state.mission.own_world == null;
    const others = state.files !== before.files || place;
    if (others) forgetReport();
    if (others || state.mission !== before.mission) again();
  });
  const offReady = useDocument.subscribe((state, before) => {
    if (state.ready && !before.ready) again();
  });
  return () => {
    useChecking.setState({ ask: NOTHING });
    clearTimeout(timer);
    offMission();
    offReady();
  };
}
