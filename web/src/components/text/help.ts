/** What the words of a text mean, in the words of the XML: a call's object, method and parameters, or a construct. */
import { readWhole } from "../../i18n/numbers";
import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { inWords, measureOf } from "../../model/meaning";
import { type Shape, title } from "../../model/parts";
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
    const parameters = method.parameters.map((parameter) => {
      const { name, label, kind, min, max, unit } = parameter;
      const measure = measureOf(parameter, robot);
      const range =
        kind === "boolean"
          ? "0, 1"
          : `${String(min)}…${String(max)}${unit === "" || measure.scale !== 1 ? "" : ` ${unit}`}`;
      const meant = measure.scale === 1 ? "" : ` = ${inWords(measure, min)}…${inWords(measure, max)}`;
      return `${said(label, name)} · ${range}${meant}`;
    });
    const name = `${said(object.label, object.name)} · ${said(method.label, method.name)}`;
    return { from, to, title: name, help: said(method.help), parameters };
  }
  return null;
}

/** What the number at an offset of a line means, and where it stands: "25 means 90°", "angle of “Turn by”". */
export function numberHelp(line: string, at: number, shape: Shape | null): HelpWords | null {
  const found = [...line.matchAll(/\p{Nd}+/gu)].find(
    ({ index, 0: digits }) => at >= index && at <= index + digits.length,
  );
  const comment = line.indexOf("#");
  if (found === undefined || shape === null || (comment >= 0 && at >= comment)) return null;
  const from = found.index;
  const open = line.lastIndexOf("(", from);
  const place = open < 0 || shape.kind !== "method" ? 0 : line.slice(open, from).split(",").length - 1;
  const numbers = shape.fields.filter((one) => one.kind === "integer");
  const field = shape.kind === "method" ? shape.fields[place] : numbers.length === 1 ? numbers[0] : undefined;
  const words = field?.kind === "integer" ? inWords(field, readWhole(found[0]) ?? 0) : found[0];
  if (field === undefined || words === found[0]) return null;
  return {
    from,
    to: from + found[0].length,
    title: t("fields.means", { number: found[0], words }),
    help: t(handKey("fields.where"), { field: said(field.label, field.name), part: title(shape) }),
    parameters: [],
  };
}

/** The help of a construct of that name; null for what is no constructor. */
export function constructHelp(catalogue: Catalogue, element: string): Omit<HelpWords, "from" | "to"> | null {
  let found: Constructor | undefined;
  for (const group of catalogue.groups) found ??= group.constructors.find((one) => one.name === element);
  return found === undefined ? null : { title: said(found.label, found.name), help: said(found.help), parameters: [] };
}
