/**
 * What a vertex shows: its name, a box for each value, a chip for each condition. Layout measures it, the canvas draws it.
 */
import { t } from "../i18n/words";
import { choiceOf } from "./meaning";
import { textWidth } from "./measure";
import { objectTitle, type Shape, shortTitle } from "./parts";
import type { Block } from "./structure";
import { text } from "./texts";
import type { Choice } from "./types";
import { fieldWords, type Piece, piecesOf } from "./words";

export interface Box {
  slot: string;
  label: string;
  value: string;
  /** What is chosen, where it has a picture. */
  picture: Choice | null;
  /** The value vertex that is plugged in instead of something typed. */
  plugged: string | null;
}

export interface Chip {
  slot: string;
  accepts: "condition" | "action";
  icon: string;
  pieces: Piece[];
  /** The vertex that fills the slot, or null while it is empty, and its element. */
  filler: string | null;
  element: string;
}

export interface Face {
  /** The robot object's name, muted, before the method's. */
  object: string;
  name: string;
  boxes: Box[];
  chips: Chip[];
}

const PAD = 8;
const TILE = 28;
const TIP = 16;
const NAME_GAP = 10;
/** A longer condition ends in dots; its words are in the tooltip. */
export const MOST_CHIP = 360;

export function faceOf(block: Block): Face {
  const { shape } = block;
  return {
    object: objectTitle(shape),
    name: shortTitle(shape),
    boxes: shape.fields.map((field) => box(block, field)),
    chips: chips(block),
  };
}

function box(block: Block, field: Shape["fields"][number]): Box {
  // A constructor's only number says itself what it counts: "10 ×".
  const plain = block.shape.kind === "constructor" && block.shape.fields.length === 1 && field.unit !== "";
  const filler = block.plugs.find((plug) => plug.slot === field.name)?.block ?? null;
  const chosen = choiceOf(field, Number(block.vertex.settings[field.name]));
  const pictured = filler === null && chosen !== undefined && (chosen.icon || chosen.lights || chosen.colour) !== "";
  // What says itself what it counts or is needs no name: "10 ×", "90°", "heart".
  const speaks = block.shape.fields.length === 1 && (field.meaning?.field ?? "") !== "";
  return {
    slot: field.name,
    label: plain || speaks ? "" : text(field.label, field.name),
    value: fieldWords(block, field.name),
    picture: pictured ? chosen : null,
    plugged: filler?.vertex.id ?? null,
  };
}

function chips(block: Block): Chip[] {
  return block.plugs.flatMap(({ slot, block: filler }): Chip[] => {
    const plug = block.shape.plugs.find((one) => one.name === slot);
    const typed = block.shape.fields.some((field) => field.name === slot);
    if (typed || plug?.accepts === "value") return [];
    return [chip(block, slot, plug?.accepts ?? "condition", filler)];
  });
}

function chip(block: Block, slot: string, accepts: "condition" | "action", filler: Block | null): Chip {
  const label = t(accepts === "action" ? "graph.action" : "graph.condition");
  const pieces: Piece[] = filler === null ? [{ kind: "hole", vertex: block.vertex.id, slot, label }] : piecesOf(filler);
  const element = filler?.shape.element ?? "";
  return { slot, accepts, icon: filler?.shape.icon ?? "", pieces, filler: filler?.vertex.id ?? null, element };
}

/** The chip of a parked test or value. */
export function chipOf(block: Block): Chip {
  const { shape, vertex } = block;
  const pieces = piecesOf(block);
  return { slot: "", accepts: "condition", icon: shape.icon, pieces, filler: vertex.id, element: shape.element };
}

export function chipWidth(chip: Chip): number {
  let width = 2 * PAD + (chip.icon === "" ? 0 : 15 + 6) + (chip.pieces.length - 1) * 6;
  for (const piece of chip.pieces) {
    width +=
      piece.kind === "words"
        ? textWidth(piece.words, 14, true)
        : textWidth(piece.label, 14) + (chip.pieces.length > 1 ? 18 : 2);
  }
  return Math.min(width, MOST_CHIP);
}

/** A picture in a box. */
export const PICTURE = 18;

export function boxWidth({ label, value, picture }: Box): number {
  const gap = 4;
  const parts = [textWidth(label, 14), picture === null ? 0 : PICTURE, textWidth(value, 14, true)].filter(
    (width) => width > 0,
  );
  return 2 * PAD + 2 + parts.reduce((sum, width) => sum + width, 0) + gap * (parts.length - 1);
}

/** The width that a vertex of that face needs between its edges, before rounding. */
export function faceWidth(face: Face, hexagon: boolean): number {
  const object = face.object === "" ? 0 : textWidth(face.object, 15) + 5;
  const extras = [...face.chips.map(chipWidth), ...face.boxes.map(boxWidth)];
  const boxes = extras.reduce((sum, width) => sum + width + 6, 0);
  const edge = hexagon ? TIP + 6 : PAD;
  return (
    (hexagon ? TIP : PAD) +
    TILE +
    NAME_GAP +
    object +
    textWidth(face.name, 15, true) +
    (boxes > 0 ? 6 + boxes : PAD) +
    edge
  );
}
