/** What a robot waits for now: the sensors that the conditions name where its threads stand. */
import type { Program } from "../../../model/types";

/** Names of the objects in the conditions of these vertices. */
export function awaitedAt({ vertices, arcs }: Pick<Program, "vertices" | "arcs">, at: readonly string[]): Set<string> {
  const found = new Set<string>();
  const todo = [...at];
  const met = new Set(todo);
  for (let id = todo.pop(); id !== undefined; id = todo.pop()) {
    const element = vertices.find((one) => one.id === id)?.element ?? "";
    if (element.includes(".")) found.add(element.slice(0, element.indexOf(".")));
    for (const arc of arcs) {
      // What comes back and what is done are no conditions.
      if (arc.target !== id || arc.at === "" || arc.at === "return" || arc.at === "action" || met.has(arc.source))
        continue;
      met.add(arc.source);
      todo.push(arc.source);
    }
  }
  return found;
}
