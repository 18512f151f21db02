/** For whom the second bar of a parallel waits: the branches that must end before it goes on. */
import { isMark } from "../../model/parts";
import type { Block } from "../../model/structure";

/**
 * The vertices on which the threads stand that a parallel waits for. A branch with a mark in it is abandoned when the
 * others have ended, so it is not waited for, unless all branches are such. What runs inside a parallel further in has
 * threads of its own; for that one, only its own vertex counts.
 */
export function waitedVertices(parallel: Block): string[] {
  const branches = parallel.bodies.map((body) => body.chain.flatMap(standing));
  const firm = branches.filter((blocks) => !blocks.some(({ shape }) => isMark(shape)));
  return (firm.length > 0 ? firm : branches).flat().map(({ vertex }) => vertex.id);
}

function standing(block: Block): Block[] {
  const plugged = block.plugs.flatMap((plug) => (plug.block === null ? [] : standing(plug.block)));
  const parallel = block.shape.flows.some((flow) => flow.repeat);
  const inside = parallel ? [] : block.bodies.flatMap((body) => body.chain.flatMap(standing));
  return [block, ...plugged, ...inside];
}
