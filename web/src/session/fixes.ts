/**
 * One-click fixes: a problem that has one right answer is mended by doing it.
 *
 * What is wrong in a text that is being written is mended in that text, at its place; what is wrong in the graph by a
 * command, so undo takes it back. Left to others: which answer is right (the server says it with the problem).
 */
import { t } from "../i18n/words";
import { type Command, replaceProgram } from "../model/command";
import { insertPart } from "../model/commands/insertPart";
import { setField } from "../model/commands/setField";
import { unwrapPart } from "../model/commands/wrapParts";
import { partsOf } from "../model/parts";
import { execute, useStudio } from "../model/studio";
import type { Problem, Program, Vertex } from "../model/types";
import { exactStretchesIn } from "./places";
import { typeText, useTyping } from "./typing";

function changed(program: Program, vertex: Vertex, after: Vertex): Program {
  return { ...program, vertices: program.vertices.map((one) => (one === vertex ? after : one)) };
}

/** The command that mends the graph, or null when it is not the graph that is wrong (any more). */
export function fixOf({ fix, program: name, vertices: [id] }: Problem): Command | null {
  const { mission, catalogue } = useStudio.getState();
  const program = mission.programs.find((one) => one.name === name);
  const vertex = program?.vertices.find((one) => one.id === id);
  if (fix == null || program === undefined || vertex === undefined) return null;
  const parts = partsOf(catalogue, program.robot);
  switch (fix.kind) {
    case "element": {
      if (vertex.element === fix.name) return null;
      const after = changed(program, vertex, { ...vertex, element: fix.name });
      return replaceProgram(t("command.change", { name: fix.name }), program, after, [vertex.id]);
    }
    case "setting":
      return setField(program, parts, vertex.id, fix.name, fix.text);
    case "unset": {
      if (!(fix.name in vertex.settings)) return null;
      const { [fix.name]: _, ...settings } = vertex.settings;
      return replaceProgram(
        t("command.set", { name: fix.name }),
        program,
        changed(program, vertex, { ...vertex, settings }),
      );
    }
    case "unwrap":
      return unwrapPart(program, parts, vertex.id);
    case "before": {
      const place = program.arcs.find(({ target, at }) => target === vertex.id && at === "in");
      return place === undefined
        ? null
        : insertPart(program, parts, { kind: "arc", source: place.source, out: place.out }, fix.name);
    }
    case "text":
      return null;
  }
}

/** Whether the problem is one of a text that is being written and does not fit the graph. */
function isOfText(problem: Problem): boolean {
  const draft = useTyping.getState().drafts[problem.program];
  return draft !== undefined && !draft.right && !draft.waiting && draft.problems.includes(problem);
}

/** Whether `applyFix` can mend it now. */
export function canFix(problem: Problem): boolean {
  return problem.fix != null && (isOfText(problem) || fixOf(problem) !== null);
}

/** Mends it; false when there is nothing to mend any more. */
export function applyFix(problem: Problem): boolean {
  const { fix } = problem;
  if (fix == null) return false;
  const draft = useTyping.getState().drafts[problem.program];
  if (draft !== undefined && isOfText(problem)) {
    const { from, to } = exactStretchesIn(draft.text)(problem);
    const text = draft.text.slice(0, from) + fix.text + draft.text.slice(to);
    typeText(problem.program, text, { text: draft.text, spans: draft.spans });
    return true;
  }
  return execute(fixOf(problem));
}
