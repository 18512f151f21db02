/**
 * What can be typed at a place of an LLL text: objects, methods behind the dot, constructs as snippets.
 *
 * The place is told by the brackets that are open before it; everything else comes from the robot's XML and the constructors'.
 */
import {
  type Completion,
  type CompletionContext,
  type CompletionResult,
  snippetCompletion,
} from "@codemirror/autocomplete";

import { standsFor } from "../../model/parts";
import { text as said } from "../../model/texts";
import type { Catalogue, Constructor, Method, Robot, RobotObject } from "../../model/types";

/** What may stand at a place; "none" inside a comment. */
export type Standing = "instruction" | "condition" | "parameter" | "none";

const TOKEN = /#[^\n]*|[\p{L}_][\p{L}\p{N}_]*|\/\/|[^\s]/gu;
const WORD = /^[\p{L}_]/u;

/** What may stand at the end of that text. */
export function standingAt(before: string): Standing {
  const open: { closer: string; standing: Standing }[] = [];
  let last = "";
  for (const match of before.matchAll(TOKEN)) {
    const token = match[0];
    if (token.startsWith("#")) {
      if (match.index + token.length === before.length) return "none";
      continue;
    }
    const around = open.at(-1)?.standing ?? "instruction";
    if (token === "[" || token === "<") open.push({ closer: token === "[" ? "]" : ">", standing: "condition" });
    else if (token === "(") {
      const call = WORD.test(last) && last !== "WAIT";
      const standing = call || last === "WAIT" ? "parameter" : around;
      open.push({ closer: ")", standing });
    } else if (open.at(-1)?.closer === token) open.pop();
    last = token;
  }
  return open.at(-1)?.standing ?? "instruction";
}

function fits(method: Method, standing: Standing): boolean {
  if (standing === "instruction") return method.kind === "procedure";
  return standing === "condition" ? method.kind === "test" : method.kind !== "procedure";
}

/** A name that a snippet takes as it is. */
function plain(words: string): string {
  return words.replace(/[{}$\\]/g, " ");
}

/** A call with a field for each parameter, its default written in it. */
export function callSnippet(method: Method, standing: Standing): string {
  const fields = method.parameters.map((one) => `\${${String(Math.max(0, one.default))}}`);
  return `${method.name}(${fields.join(", ")})${standing === "instruction" ? ";" : ""}\${}`;
}

/** A construct with a field for each slot; bodies on lines of their own. */
export function constructSnippet(constructor: Constructor): string {
  let code = constructor.code.trim();
  for (const slot of constructor.slots) {
    const hole = `{${slot.name}}`;
    if (slot.kind === "flow") code = code.replace(`(${hole})`, "(\n\t${}\n)").replace(hole, "${}");
    else code = code.split(hole).join(`\${${plain(slot.default || slot.name)}}`);
  }
  return code.endsWith(";") ? code : `${code};`;
}

/** The code of a construct as a person would say it: "*[condition](body)". */
export function constructWords(constructor: Constructor): string {
  return constructor.code.trim().replace(/[{}]/g, "");
}

function methodOptions(object: RobotObject, standing: Standing): Completion[] {
  return object.methods.map((method) =>
    snippetCompletion(callSnippet(method, standing), {
      label: method.name,
      detail: said(method.label, ""),
      info: said(method.help, ""),
      type: method.kind,
      boost: fits(method, standing) ? 10 : -10,
    }),
  );
}

function objectOptions(robot: Robot, standing: Standing): Completion[] {
  return robot.objects.map((object) => ({
    label: object.name,
    detail: said(object.label, ""),
    info: said(object.help, ""),
    type: "object",
    apply: `${object.name}.`,
    boost: object.methods.some((method) => fits(method, standing)) ? 10 : -10,
  }));
}

function constructOptions(
  catalogue: Catalogue,
  robot: Robot | undefined,
  standing: Standing,
  byCode: boolean,
): Completion[] {
  const role = standing === "instruction" ? "instruction" : "condition";
  return catalogue.groups.flatMap((group) =>
    group.constructors
      .filter((one) => one.role === role && one.code.trim() !== "" && standsFor(one, robot))
      .map((one) => {
        const name = said(one.label, one.name);
        const snippet = role === "instruction" ? constructSnippet(one) : constructSnippet(one).replace(/;$/, "");
        const words = constructWords(one);
        return snippetCompletion(snippet, {
          label: byCode ? words : name,
          detail: byCode ? name : words,
          info: said(one.help, ""),
          type: "construct",
        });
      }),
  );
}

/** Everything that may stand at a place. `explicit`: the person asked for it by key. */
export function complete(
  before: string,
  robot: Robot | undefined,
  catalogue: Catalogue,
  explicit: boolean,
): { from: number; options: Completion[]; byCode?: boolean } | null {
  const standing = standingAt(before);
  if (standing === "none" || robot === undefined) return null;
  const method = /([\p{L}_][\p{L}\p{N}_]*)\.([\p{L}_][\p{L}\p{N}_]*)?$/u.exec(before);
  if (method !== null) {
    const object = robot.objects.find((one) => one.name === method[1]);
    if (object === undefined) return null;
    return { from: before.length - (method[2] ?? "").length, options: methodOptions(object, standing) };
  }
  const marks = /[*[</°!]+$/u.exec(before);
  if (marks !== null && standingAt(before.slice(0, marks.index)) === "instruction") {
    const options = constructOptions(catalogue, robot, "instruction", true).filter((one) =>
      one.label.startsWith(marks[0]),
    );
    return options.length === 0 ? null : { from: marks.index, options, byCode: true };
  }
  const word = /[\p{L}_][\p{L}\p{N}_]*$/u.exec(before);
  if (word === null && !explicit) return null;
  const constructs = standing === "parameter" ? [] : constructOptions(catalogue, robot, standing, false);
  return { from: word?.index ?? before.length, options: [...objectOptions(robot, standing), ...constructs] };
}

/** The source for CodeMirror; `parts` gives the parts as they are now. */
export function completionSource(parts: () => { robot: Robot | undefined; catalogue: Catalogue }) {
  return (context: CompletionContext): CompletionResult | null => {
    const { robot, catalogue } = parts();
    const found = complete(context.state.sliceDoc(0, context.pos), robot, catalogue, context.explicit);
    if (found === null) return null;
    if (found.byCode === true) return { from: found.from, options: found.options, filter: false };
    return { from: found.from, options: found.options, validFor: /^[\p{L}_][\p{L}\p{N}_]*$/u };
  };
}
