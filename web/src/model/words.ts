/**
 * A test or value in words: "Sign = 0", "Run is true and not Cargo pressed".
 *
 * A method brings its own phrase with holes; a constructor of conditions joins its tests by its own name (two tests or
 * more) or stands in front by the name of its slot (one). Empty slots stay visible as holes.
 */
import { t } from "../i18n/words";
import { choiceOf, inWords, measureOf, storedNumber } from "./meaning";
import { shortTitle, title } from "./parts";
import type { Block } from "./structure";
import { text } from "./texts";
import type { RobotObject } from "./types";

/** A run of words, or an empty slot. `vertex` is the vertex they speak of, or whose slot it is. */
export type Piece =
  { kind: "words"; vertex: string; words: string } | { kind: "hole"; vertex: string; slot: string; label: string };

/** The pieces of a condition, value or plugged action, in the order of reading. */
export function piecesOf(block: Block): Piece[] {
  return joined(block.shape.kind === "method" ? methodPieces(block) : constructorPieces(block));
}

/** The same as one line; holes read as their label in brackets. */
export function wordsOf(block: Block): string {
  return piecesOf(block)
    .map((piece) => (piece.kind === "words" ? piece.words : `(${piece.label})`))
    .join(" ");
}

function methodPieces(block: Block): Piece[] {
  const { shape, vertex } = block;
  const { object, method } = shape;
  const phrase = method === null ? "" : text(method.phrase);
  if (phrase === "" || object === null) {
    const given = shape.fields.map((field) => fieldWords(block, field.name)).join(", ");
    return [{ kind: "words", vertex: vertex.id, words: given === "" ? title(shape) : `${title(shape)} ${given}` }];
  }
  const words = phrase.replace(/\{([^}]*)\}/g, (_, hole: string) => {
    if (hole === "object") return text(object.label, object.name);
    return fieldWords(block, hole) || "…";
  });
  return [{ kind: "words", vertex: vertex.id, words }];
}

function constructorPieces(block: Block): Piece[] {
  const { shape, vertex, plugs } = block;
  const own = (words: string): Piece => ({ kind: "words", vertex: vertex.id, words });
  const parts = plugs.map(({ slot, block: filler }): Piece[] => {
    const label = text(shape.plugs.find((plug) => plug.name === slot)?.label ?? {}, slot);
    if (filler === null) return [{ kind: "hole", vertex: vertex.id, slot, label }];
    const inner = piecesOf(filler);
    const nested = filler.plugs.length > 1 && filler.shape.kind !== "method" && filler.shape.element !== shape.element;
    return nested ? [own("("), ...inner, own(")")] : inner;
  });
  const [first, ...others] = parts;
  if (first === undefined) return [own(shortTitle(shape))];
  if (others.length === 0) return [own(text(shape.plugs[0]?.label ?? {}, shortTitle(shape).toLowerCase())), ...first];
  return [...first, ...others.flatMap((part) => [own(shortTitle(shape).toLowerCase()), ...part])];
}

/** Neighbouring words in one run, brackets close to what they hold. */
function joined(pieces: Piece[]): Piece[] {
  const result: Piece[] = [];
  for (const piece of pieces) {
    const last = result.at(-1);
    if (piece.kind === "words" && last?.kind === "words") {
      const tight = last.words.endsWith("(") || piece.words.startsWith(")");
      result[result.length - 1] = { ...last, words: `${last.words}${tight ? "" : " "}${piece.words}` };
    } else result.push(piece);
  }
  return result;
}

/** The value of a field in words: what was typed, or what is plugged in. */
export function fieldWords(block: Block, name: string): string {
  const filler = block.plugs.find((plug) => plug.slot === name)?.block;
  if (filler != null) return wordsOf(filler);
  const typed = block.vertex.settings[name] ?? "";
  const field = block.shape.fields.find((one) => one.name === name);
  const number = field?.kind === "integer" ? storedNumber(typed) : null;
  if (field !== undefined && number !== null) return inWords(field, number);
  if (field?.kind !== "boolean") return typed;
  return t(isOn(typed) ? "parts.on" : "parts.off");
}

/** Whether a switch's setting means on. */
export function isOn(setting: string): boolean {
  return setting !== "" && setting !== "0" && setting !== "false";
}

/** What a sensor or variable says now: "77 cm", "red", "free". */
export function valueWords(object: Pick<RobotObject, "type" | "unit" | "meaning">, value: number): string {
  const measure = measureOf(object, null);
  if (object.type === "boolean" && choiceOf(measure, value) === undefined)
    return t(value === 0 ? "parts.off" : "parts.on");
  return inWords(measure, value);
}
