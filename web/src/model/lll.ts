/**
 * Blocks as LLL text, by the templates of their constructors: what the clipboard holds.
 *
 * Each hole of a template is filled with what stands in the slot; bodies are laid out a line an instruction. It says what
 * is there: an open slot leaves its hole empty. The program's own text is the server's; nothing here is run.
 */
import type { Block } from "./structure";

/** The text of a chain: an instruction a line, each with its `;`. Conditions and values stand alone without one. */
export function lllOf(blocks: readonly Block[]): string {
  const [only] = blocks;
  if (blocks.length === 1 && only !== undefined && only.shape.role !== "instruction") return `${textOf(only, "")}\n`;
  return lines(blocks, "");
}

function lines(chain: readonly Block[], indent: string): string {
  return chain
    .map((block) => `${comments(block, indent)}${indent}${textOf(block, indent)};${behind(block)}\n`)
    .join("");
}

function comments({ vertex }: Block, indent: string): string {
  const above = vertex.notes.filter((note) => note.at === "").flatMap((note) => note.text.split("\n"));
  return above.map((line) => `${`${indent}# ${line}`.trimEnd()}\n`).join("");
}

function behind({ vertex }: Block): string {
  const after = vertex.notes.filter((note) => note.at === "after").map((note) => note.text.replaceAll("\n", " "));
  return after.length === 0 ? "" : `  # ${after.join(" ")}`;
}

function textOf(block: Block, indent: string): string {
  const { shape, vertex } = block;
  const template = shape.constructor_?.code;
  if (template === undefined) {
    const values = shape.fields.map((field) => valueOf(block, field.name));
    const rest = Object.entries(vertex.settings).filter(([name]) => shape.fields.every((field) => field.name !== name));
    return `${vertex.element}(${[...values, ...rest.map(([, value]) => value)].join(", ")})`;
  }
  return template.replace(/\{([^}]*)\}/g, (hole, slot: string) => {
    const flow = shape.flows.find((one) => one.name === slot);
    if (flow !== undefined) return bodies(block, slot, flow.repeat, indent);
    return block.plugs.some((plug) => plug.slot === slot) || slot in vertex.settings ? valueOf(block, slot) : hole;
  });
}

/** What is typed in a slot, or what fills it. A joined condition inside another one keeps its brackets. */
function valueOf(block: Block, slot: string): string {
  const filler = block.plugs.find((plug) => plug.slot === slot)?.block ?? null;
  if (filler === null) return block.vertex.settings[slot] ?? "";
  const words = textOf(filler, "");
  const joins = filler.shape.constructor_ !== null && filler.plugs.length > 1;
  return joins && block.shape.role === "condition" && block.plugs.length > 1 ? `(${words})` : words;
}

function bodies(block: Block, slot: string, repeat: boolean, indent: string): string {
  const inner = `${indent}  `;
  const wanted = block.bodies.filter(({ out }) => (repeat ? out.startsWith(`${slot}.`) : out === slot));
  const texts = wanted.flatMap(({ out, chain }) => {
    const end = block.vertex.notes.filter((note) => note.at === `in:${out}`).flatMap((note) => note.text.split("\n"));
    const text = `${lines(chain, inner)}${end.map((line) => `${inner}# ${line}\n`).join("")}`;
    return text === "" ? [] : [text];
  });
  return texts.length === 0 ? "" : `\n${texts.join(`${inner},\n`)}${indent}`;
}
