/** Edits of the program in view by pointer and keys: each makes a command and gives it to the document. */
import { t } from "../i18n/words";
import type { Command } from "../model/command";
import { deleteParts } from "../model/commands/deleteParts";
import { insertPart } from "../model/commands/insertPart";
import { copyParts, moveParts } from "../model/commands/moveParts";
import { shiftParts } from "../model/commands/shiftParts";
import { stretchOf, unwrapPart, wrapParts, wraps } from "../model/commands/wrapParts";
import { waitingFor } from "../model/parts";
import { placeFor } from "../model/placeFor";
import { execute, useStudio } from "../model/studio";
import { findSpot, inChain, type Place } from "../model/tree";
import { currentDrawing, type Drawing } from "./drawing";
import { sayOnCanvas, useView } from "./view";

/** Does the command that `make` finds for the program in view; says whether there was one. */
export function edit(make: (drawing: Drawing) => Command | null): boolean {
  const drawing = currentDrawing();
  return execute(drawing === null ? null : make(drawing));
}

/** Puts a part where the selection says. */
export function addPart(element: string): boolean {
  const { selection } = useStudio.getState();
  return edit(({ program, parts, structure, layout }) => {
    const arc = layout.arcs.find((one) => one.id === useView.getState().arc) ?? null;
    const around = { vertex: selection.at(-1) ?? null, arc };
    const shape = parts.shape(element);
    const place = placeFor(structure, around, shape, waitingFor(parts, shape) !== undefined);
    return place === null ? null : insertPart(program, parts, place, element);
  });
}

export function addPartAt(place: Place, element: string): boolean {
  return edit(({ program, parts }) => {
    const { selection } = useStudio.getState();
    if (place.kind === "vertex" && wraps(parts.shape(element))) return wrapParts(program, parts, selection, element);
    return insertPart(program, parts, place, element);
  });
}

export function movePartsTo(place: Place, ids: string[], copy: boolean): boolean {
  return edit(({ program, parts }) => (copy ? copyParts : moveParts)(program, parts, ids, place));
}

export function deleteVertices(ids: string[]): boolean {
  return ids.length > 0 && edit(({ program, parts }) => deleteParts(program, parts, ids));
}

export function deleteSelection(): boolean {
  return deleteVertices(useStudio.getState().selection);
}

/** Moves the selected parts past their neighbour. */
export function shiftSelection(by: 1 | -1): boolean {
  const { selection } = useStudio.getState();
  return selection.length > 0 && edit(({ program, parts }) => shiftParts(program, parts, selection, by));
}

/** Copies of the selected vertices, right after the last of them. */
export function duplicateSelection(): boolean {
  const { selection } = useStudio.getState();
  return edit(({ program, parts, structure }) => {
    const last = selection.at(-1);
    const spot = last === undefined ? undefined : findSpot(structure, last);
    if (spot === undefined) return null;
    const place: Place = { kind: "arc", source: inChain(spot).block.vertex.id, out: "next" };
    return copyParts(program, parts, selection, place);
  });
}

/** Whether the selected vertices stand in one chain, so that something can go around them. */
export function wrappable(): boolean {
  const drawing = currentDrawing();
  return drawing !== null && stretchOf(drawing.structure, useStudio.getState().selection) !== null;
}

/** Asks what should go around the selection. */
export function openWrapping(): boolean {
  const { selection } = useStudio.getState();
  if (selection.length === 0) return false;
  if (!wrappable()) sayOnCanvas(t("wrap.cannot"));
  else useView.getState().setAdding({ vertex: selection.at(-1) ?? null, slot: null, wrap: true });
  return true;
}

export function wrapSelection(element: string): boolean {
  return edit(({ program, parts }) => wrapParts(program, parts, useStudio.getState().selection, element));
}

/** What the selected constructor holds takes its place. */
export function unwrapSelection(): boolean {
  const { selection } = useStudio.getState();
  const [id] = selection;
  return selection.length === 1 && id !== undefined && edit(({ program, parts }) => unwrapPart(program, parts, id));
}
