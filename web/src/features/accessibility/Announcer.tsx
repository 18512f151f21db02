/**
 * Says each change of the document (done, undone, done again), what is selected, and while a team runs, who fails, takes
 * over and changes groups. The toolbar says the run's state.
 */
import { useEffect, useState } from "react";

import { t } from "../../i18n/words";
import { type StudioState, useStudio } from "../../model/studio";
import { currentDrawing, nodeOf } from "../../session/drawing";
import { changesOf } from "../../session/members";
import { type RunState, useRun } from "../../session/run";
import { spoken, spokenArc } from "../../session/spoken";
import { useView } from "../../session/view";
import { endAll } from "../../ui/effects";

/** What happened, in words; "" for what need not be said. */
export function changeWords({ change, redoLabel, undoLabel }: StudioState): string {
  if (change.kind === "do") return change.label;
  if (change.kind === "undo") return t("reach.undone", { what: redoLabel });
  if (change.kind === "redo") return t("reach.redone", { what: undoLabel });
  return "";
}

/** Of what comes at once, so many changes are said: the last. */
const SAID = 3;

/** What has changed in the team of a run since it stood as before; "" where another moment was gone to. */
export function teamWords(
  { events, team }: Pick<RunState, "events" | "team">,
  { events: before }: Pick<RunState, "events">,
): string {
  const last = before.at(-1);
  const known = last === undefined ? 0 : events.lastIndexOf(last) + 1;
  if (team === null || events === before || (last !== undefined && known === 0)) return "";
  const words = changesOf(events.slice(known)).map(({ agent, text }) => `${agent} ${text.replaceAll("`", "")}`);
  return words.slice(-SAID).join("; ");
}

export function Announcer() {
  const [said, setSaid] = useState({ words: "", times: 0 });
  useEffect(() => {
    const say = (words: string) => {
      if (words !== "") setSaid(({ times }) => ({ words, times: times + 1 }));
    };
    const offChanges = useStudio.subscribe((state, before) => {
      if (state.change !== before.change) say(changeWords(state));
      else if (state.selection !== before.selection) say(selectionWords(state.selection));
    });
    const offArcs = useView.subscribe(({ arc }, before) => {
      if (arc !== before.arc) say(arcWords(arc));
    });
    const offRun = useRun.subscribe((run, before) => {
      if (run.events !== before.events) say(teamWords(run, before));
    });
    return endAll(offRun, offChanges, offArcs);
  }, []);
  // The same words twice are news twice: a space at their end makes them another text.
  return (
    <p className="only-spoken" aria-live="polite" data-testid="announcer">
      {said.words}
      {said.times % 2 === 1 ? "\u00a0" : ""}
    </p>
  );
}

/**
 * What is selected, in words, where the focus does not tell: an arc, several parts, or a part that was selected from
 * elsewhere (a problem, the text, find). One part selected on the graph is said by the graph's active descendant.
 */
function arcWords(id: string | null): string {
  const arc = currentDrawing()?.layout.arcs.find((one) => one.id === id);
  return arc === undefined ? "" : spokenArc(arc);
}

/** "" for what need not be said. */
function selectionWords(selection: readonly string[]): string {
  const last = selection.at(-1);
  const drawing = currentDrawing();
  if (last === undefined || drawing === null) return "";
  if (selection.length > 1) return t("inspector.many", { count: selection.length });
  if (document.activeElement?.closest(".canvas, [role=tree]") != null) return "";
  const node = nodeOf(drawing, last);
  return node === undefined ? "" : t("reach.selected", { what: spoken(node) });
}
