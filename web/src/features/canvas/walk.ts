/** The arrow keys: up and down in the order of reading, left and right between branches, out of and into bodies. */
import type { LayoutNode } from "../../model/layout";
import { isMark } from "../../model/parts";
import type { Block } from "../../model/structure";
import { findSpot, inChain, type Spot } from "../../model/tree";
import type { Drawing } from "../../session/drawing";

export type Step = "up" | "down" | "left" | "right";

/** The vertex that a step leads to from `id`; from nothing, to the first. */
export function walk(drawing: Drawing, id: string | null, step: Step): string | null {
  const order = drawing.layout.nodes.filter((node) => node.kind !== "barEnd" && node.kind !== "place");
  if (id === null) return order[0]?.vertex ?? null;
  if (step === "up" || step === "down") return neighbour(order, drawing, id, step === "down" ? 1 : -1);
  const spot = findSpot(drawing.structure, id);
  if (spot === undefined) return null;
  const chained = inChain(spot);
  const beside = chained.owner === null ? null : nextBody(chained, step === "right" ? 1 : -1);
  if (step === "right") return shown(spot.block.bodies.find((body) => body.chain.length > 0)?.chain[0]) ?? beside;
  return beside ?? (spot.kind === "slot" ? shown(chained.block) : shown(chained.owner?.block)) ?? null;
}

function neighbour(order: LayoutNode[], drawing: Drawing, id: string, by: 1 | -1): string | null {
  let at = order.findIndex((node) => node.vertex === id);
  if (at < 0) {
    const spot = findSpot(drawing.structure, id);
    const owner = spot === undefined ? undefined : inChain(spot).block.vertex.id;
    at = order.findIndex((node) => node.vertex === owner || node.mark?.vertex.id === owner);
    if (at >= 0 && by < 0) return order[at]?.vertex ?? null;
  }
  return order[at + by]?.vertex ?? null;
}

/** The first vertex of the body beside this one. */
function nextBody(spot: Spot & { kind: "chain" }, by: 1 | -1): string | null {
  const bodies = spot.owner?.block.bodies ?? [];
  const at = bodies.findIndex((body) => body === spot.body);
  for (let index = at + by; index >= 0 && index < bodies.length; index += by) {
    const first = shown(bodies[index]?.chain[0]);
    if (first !== null) return first;
  }
  return null;
}

/** A mark shows as the action it holds. */
function shown(block: Block | undefined): string | null {
  if (block === undefined) return null;
  return (isMark(block.shape) ? block.plugs[0]?.block : null)?.vertex.id ?? block.vertex.id;
}
