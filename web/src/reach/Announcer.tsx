/** Says each change of the document: what was done, undone or done again. The run's state is said by the toolbar. */
import { useEffect, useState } from "react";

import type { StudioState } from "../model/studio";
import { useStudio } from "../model/studio";
import { t } from "../words/words";

/** What happened, in words; "" for what need not be said. */
export function changeWords({ change, redoLabel, undoLabel }: StudioState): string {
  if (change.kind === "do") return change.label;
  if (change.kind === "undo") return t("reach.undone", { what: redoLabel });
  if (change.kind === "redo") return t("reach.redone", { what: undoLabel });
  return "";
}

export function Announcer() {
  const [said, setSaid] = useState({ words: "", times: 0 });
  useEffect(
    () =>
      useStudio.subscribe((state, before) => {
        const words = state.change === before.change ? "" : changeWords(state);
        if (words !== "") setSaid(({ times }) => ({ words, times: times + 1 }));
      }),
    [],
  );
  // The same words twice are news twice: a space at their end makes them another text.
  return (
    <p className="only-spoken" aria-live="polite" data-testid="announcer">
      {said.words}
      {said.times % 2 === 1 ? "\u00a0" : ""}
    </p>
  );
}
