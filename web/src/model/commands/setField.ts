/** Types a value into a field of a vertex; steps of one drag or one word join into a single undo. */
import { t } from "../../i18n/words";
import { type Command, replaceProgram } from "../command";
import type { Step } from "../history";
import type { Parts } from "../parts";
import type { Program } from "../types";

function joined(program: Program, id: string, name: string): string {
  return `set ${program.name} ${id} ${name}`;
}

/** How many of the last steps did nothing but set that field, back to when it had this value; 0 when it had not. */
export function stepsSince(past: readonly Step[], program: Program, id: string, name: string, value: string): number {
  for (let count = 1; count <= past.length; count++) {
    const step = past.at(-count);
    if (step?.joins !== joined(program, id, name)) return 0;
    const before = step.before.programs.find((one) => one.name === program.name);
    if (before?.vertices.find((one) => one.id === id)?.settings[name] === value) return count;
  }
  return 0;
}

/** The command, or null when that is the value already. */
export function setField(program: Program, parts: Parts, id: string, name: string, value: string): Command | null {
  const vertex = program.vertices.find((one) => one.id === id);
  if (vertex === undefined || vertex.settings[name] === value) return null;
  const changed = { ...vertex, settings: inOrder({ ...vertex.settings, [name]: value }, parts, vertex.element) };
  const after = { ...program, vertices: program.vertices.map((one) => (one === vertex ? changed : one)) };
  return { ...replaceProgram(t("command.set", { name }), program, after), joins: joined(program, id, name) };
}

/** Settings in the order of the element's fields, so that the file does not depend on the order of typing. */
function inOrder(settings: Record<string, string>, parts: Parts, element: string): Record<string, string> {
  const fields = parts.shape(element).fields.map((field) => field.name);
  const known = fields.filter((name) => name in settings);
  const rest = Object.keys(settings).filter((name) => !fields.includes(name));
  return Object.fromEntries([...known, ...rest].map((name) => [name, settings[name] ?? ""]));
}
