/**
 * A program as rows to be read aloud: one row a vertex of a chain, deeper by one level inside a body.
 *
 * Where a vertex has several bodies each is a row of its own ("then", "else", "branch 2"), which stands for no vertex.
 * Conditions and values are part of the vertex that they belong to, as on the graph.
 */
import { t } from "../../i18n/words";
import { type Field, isMark, title } from "../../model/parts";
import type { Block, Structure } from "../../model/structure";
import { text } from "../../model/texts";
import { fieldWords, wordsOf } from "../../model/words";

export interface OutlineRow {
  key: string;
  /** The vertex that the row stands for; null for a body or a heading. */
  vertex: string | null;
  /** From 1. */
  level: number;
  words: string;
}

export function outlineOf(structure: Structure): OutlineRow[] {
  const rows: OutlineRow[] = [];
  const terminal = (id: string | undefined, words: string) => {
    if (id !== undefined) rows.push({ key: id, vertex: id, level: 1, words });
  };
  const chain = (blocks: Block[], level: number) => {
    for (const block of blocks) {
      const { vertex, bodies } = block;
      // A mark shows as the action that it holds.
      const held = isMark(block.shape) ? (block.plugs[0]?.block ?? null) : null;
      const words = held === null ? blockWords(block) : `${blockWords(held)}, ${title(block.shape)}`;
      rows.push({ key: vertex.id, vertex: (held ?? block).vertex.id, level, words });
      for (const [index, body] of bodies.entries()) {
        if (bodies.length === 1) {
          chain(body.chain, level + 1);
          continue;
        }
        const heading = bodyWords(block, body.out, index);
        rows.push({ key: `${vertex.id} ${body.out}`, vertex: null, level: level + 1, words: heading });
        chain(body.chain, level + 2);
      }
    }
  };
  terminal(structure.start?.id, t("graph.start"));
  chain(structure.main.chain, 1);
  terminal(structure.stop?.id, t("graph.stop"));
  if (structure.parked.length > 0) {
    rows.push({ key: "parked", vertex: null, level: 1, words: t("graph.parked") });
    for (const parked of structure.parked) chain(parked, 2);
  }
  return rows;
}

/** Name, what fills its slots, and its values: "While, Run is true", "Wheel Advance, speed 50 %". */
export function blockWords(block: Block): string {
  const { shape, plugs } = block;
  const values = shape.fields.map((field) => valueWords(block, field));
  const fields = new Set(shape.fields.map((field) => field.name));
  const fillers = plugs.flatMap((plug) => (plug.block === null || fields.has(plug.slot) ? [] : [wordsOf(plug.block)]));
  return [title(shape), ...fillers, ...values].filter((words) => words !== "").join(", ");
}

function valueWords(block: Block, field: Field): string {
  const value = fieldWords(block, field.name);
  return value === "" ? "" : `${text(field.label, field.name)} ${value}`;
}

/** "then", or "branch 2" where one slot has several bodies. */
function bodyWords({ shape }: Block, out: string, index: number): string {
  const slot = out.split(".")[0] ?? out;
  const flow = shape.flows.find((one) => one.name === slot);
  const words = text(flow?.label ?? {}, slot);
  return flow?.repeat === true ? `${words} ${String(index + 1)}` : words;
}

/** The row that holds this one, or -1. */
export function rowAbove(rows: readonly OutlineRow[], at: number): number {
  const level = rows[at]?.level ?? 1;
  for (let index = at - 1; index >= 0; index--) if ((rows[index]?.level ?? 1) < level) return index;
  return -1;
}
