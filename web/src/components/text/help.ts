/** What the words of a text mean, in the words of the XML: a call's object, method and parameters, or a construct. */
import { text as said } from "../../model/texts";
import type { Catalogue, Constructor, Robot } from "../../model/types";

export interface HelpWords {
  from: number;
  to: number;
  title: string;
  help: string;
  /** A line a parameter: "speed · 0 to 100 %". */
  parameters: string[];
}

const CALL = /([\p{L}_][\p{L}\p{N}_]*)(?:\s*\.\s*([\p{L}_][\p{L}\p{N}_]*))?/gu;

/** The call whose object or method stands at an offset of a line; null where none does, or the robot has none such. */
export function callHelp(line: string, at: number, robot: Robot | undefined): HelpWords | null {
  const comment = line.indexOf("#");
  if (comment >= 0 && at >= comment) return null;
  for (const match of line.matchAll(CALL)) {
    const from = match.index;
    const to = from + match[0].length;
    if (at < from || at > to) continue;
    const object = robot?.objects.find((one) => one.name === match[1]);
    if (object === undefined) return null;
    const method = object.methods.find((one) => one.name === match[2]);
    if (method === undefined || at < from + object.name.length) {
      const end = from + object.name.length;
      return { from, to: end, title: said(object.label, object.name), help: said(object.help), parameters: [] };
    }
    const parameters = method.parameters.map(({ name, label, kind, min, max, unit }) => {
      const range = kind === "boolean" ? "0, 1" : `${String(min)}…${String(max)}${unit === "" ? "" : ` ${unit}`}`;
      return `${said(label, name)} · ${range}`;
    });
    const title = `${said(object.label, object.name)} · ${said(method.label, method.name)}`;
    return { from, to, title, help: said(method.help), parameters };
  }
  return null;
}

/** The help of a construct of that name; null for what is no constructor. */
export function constructHelp(catalogue: Catalogue, element: string): Omit<HelpWords, "from" | "to"> | null {
  let found: Constructor | undefined;
  for (const group of catalogue.groups) found ??= group.constructors.find((one) => one.name === element);
  return found === undefined ? null : { title: said(found.label, found.name), help: said(found.help), parameters: [] };
}
