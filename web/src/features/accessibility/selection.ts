/**
 * What is selected, in words, where the focus does not tell: an arc, several parts, or a part that was selected from
 * elsewhere (a problem, the text, find). One part selected on the graph is said by the graph's active descendant.
 */
import { t } from "../../i18n/words";
import { currentDrawing, nodeOf } from "../../session/drawing";
import { spoken, spokenArc } from "../../session/spoken";

export function arcWords(id: string | null): string {
  const arc = currentDrawing()?.layout.arcs.find((one) => one.id === id);
  return arc === undefined ? "" : spokenArc(arc);
}

/** "" for what need not be said. */
export function selectionWords(selection: readonly string[]): string {
  const last = selection.at(-1);
  const drawing = currentDrawing();
  if (last === undefined || drawing === null) return "";
  if (selection.length > 1) return t("inspector.many", { count: selection.length });
  if (document.activeElement?.closest(".canvas, [role=tree]") != null) return "";
  const node = nodeOf(drawing, last);
  return node === undefined ? "" : t("reach.selected", { what: spoken(node) });
}
