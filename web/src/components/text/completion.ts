/**
 * What can be typed at a place of an LLL text: objects, methods behind the dot, constructs as snippets.
 *
 * The place is told by the brackets and words before it (`completion-place`); everything else comes from the robot's XML and the
 * constructors', and the names of a team from its mission and its declarations.
 */
import {
  type Completion,
  type CompletionContext,
  type CompletionResult,
  snippetCompletion,
} from "@codemirror/autocomplete";

import { moreWords } from "../../i18n/words";
import { standsFor } from "../../model/parts";
import { text as said } from "../../model/texts";
import { TEAM_ROBOT } from "../../model/team-robot";
import type { Catalogue, Constructor, Method, Robot, RobotObject } from "../../model/types";
import type { TeamNames } from "./team-names";
import { placeAtEnd, type Standing } from "./completion-place";
import { declarationOptions, nameOptions } from "./team-completion";

/** What may stand at the end of that text. */
export function standingAt(before: string, team = false): Standing {
  return placeAtEnd(before, team).standing;
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
        // The forms of a team are words of the language, so that is what a person begins to type.
        const first = byCode || (one.level ?? "agent") !== "agent";
        return snippetCompletion(snippet, {
          label: first ? words : name,
          detail: first ? name : words,
          info: said(one.help, ""),
          type: "construct",
        });
      }),
  );
}

const NO_NAMES: TeamNames = { roles: [], groups: [], agents: [], programs: [], robots: [] };

/** Everything that may stand at a place. `explicit`: the person asked for it by key; `names`: those of the mission's team. */
export function complete(
  before: string,
  robot: Robot | undefined,
  catalogue: Catalogue,
  explicit: boolean,
  names: TeamNames = NO_NAMES,
): { from: number; options: Completion[]; byCode?: boolean } | null {
  const team = robot?.name === TEAM_ROBOT;
  const place = placeAtEnd(before, team);
  const { standing } = place;
  if (standing === "none" || robot === undefined) return null;
  const method = /([\p{L}_][\p{L}\p{N}_]*)\.([\p{L}_][\p{L}\p{N}_]*)?$/u.exec(before);
  if (method !== null) {
    const object = robot.objects.find((one) => one.name === method[1]);
    if (object === undefined) return null;
    return { from: before.length - (method[2] ?? "").length, options: methodOptions(object, standing) };
  }
  const marks = /[*[</°!]+$/u.exec(before);
  if (marks !== null && standingAt(before.slice(0, marks.index), team) === "instruction") {
    const options = constructOptions(catalogue, robot, "instruction", true).filter((one) =>
      one.label.startsWith(marks[0]),
    );
    return options.length === 0 ? null : { from: marks.index, options, byCode: true };
  }
  if (standing !== "instruction" && standing !== "condition" && standing !== "parameter") {
    if (!team || (place.from === before.length && !explicit)) return null;
    const options = nameOptions(place, names);
    return options.length === 0 ? null : { from: place.from, options };
  }
  const word = /[\p{L}_][\p{L}\p{N}_]*$/u.exec(before);
  if (word === null && !explicit) return null;
  const constructs = standing === "parameter" ? [] : constructOptions(catalogue, robot, standing, false);
  const declarations = team && place.declares ? declarationOptions() : [];
  const from = word?.index ?? before.length;
  return { from, options: [...declarations, ...objectOptions(robot, standing), ...constructs] };
}

/** The source for CodeMirror; `parts` gives the parts and the names of the team as they are now. */
export function completionSource(
  parts: () => { robot: Robot | undefined; catalogue: Catalogue; names?: TeamNames | undefined },
) {
  return async (context: CompletionContext): Promise<CompletionResult | null> => {
    const { robot, catalogue, names } = parts();
    if (robot?.name === TEAM_ROBOT) await moreWords();
    const found = complete(context.state.sliceDoc(0, context.pos), robot, catalogue, context.explicit, names);
    if (found === null) return null;
    if (found.byCode === true) return { from: found.from, options: found.options, filter: false };
    return { from: found.from, options: found.options, validFor: /^(?:[\p{L}_][\p{L}\p{M}\p{N}_-]*|"[^"]*)$/u };
  };
}
