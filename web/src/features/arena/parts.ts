/** The parts of the arena that are fetched later: the stage, and what it shows besides the robots. */
import { useEffect } from "react";
import { create } from "zustand";

import { moreWords } from "../../i18n/words";
import { reportError, useDocument } from "../../session/document";
import { useRun } from "../../session/run";
import { useStage } from "../../session/stage";
import type * as Stage from "./stage";

export const useParts = create<{ stage: typeof Stage | null }>(() => ({ stage: null }));

let fetching: Promise<typeof Stage> | null = null;

function fetchStage(): Promise<typeof Stage> {
  fetching ??= Promise.all([import("./stage"), moreWords()]).then(
    ([stage]) => {
      useParts.setState({ stage });
      return stage;
    },
    (cause: unknown) => {
      fetching = null;
      throw cause;
    },
  );
  return fetching;
}

/** Makes the arena large and the program small, and back; a sheet that is open keeps the page as it is. */
export function toggleStage(): void {
  if (useDocument.getState().overlay === null) void fetchStage().then((stage) => stage.toggle(), reportError);
}

/** Opens the menu of what the arena shows, at a place of the window. */
export function openShown(x: number, y: number): void {
  void fetchStage().then((stage) => stage.openShown(x, y), reportError);
}

/** The parts, once they are there: they are fetched when the arena is large, and when something runs. */
export function useStageParts(): typeof Stage | null {
  const wanted = useRun((run) => run.status !== "idle");
  const large = useStage((stage) => stage.large);
  useEffect(() => {
    if (wanted || large) void fetchStage().catch(reportError);
  }, [wanted, large]);
  return useParts((parts) => parts.stage);
}
