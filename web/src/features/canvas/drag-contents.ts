/** Whether a drag takes a vertex along: it, and what it holds, is no place for what is dragged. */
import { type Payload, useDrag } from "../../session/drag";
import { currentDrawing } from "../../session/drawing";
import { insideOf } from "../../session/targets";

const NOTHING: ReadonlySet<string> = new Set();
/** For each drag: every arc and slot asks. */
const known = new WeakMap<Payload, ReadonlySet<string>>();

function movedBy(payload: Payload | null): ReadonlySet<string> {
  if (payload?.kind !== "vertices") return NOTHING;
  const before = known.get(payload);
  if (before !== undefined) return before;
  const drawing = currentDrawing();
  const inside = drawing === null ? NOTHING : insideOf(drawing, payload.ids);
  known.set(payload, inside);
  return inside;
}

export function useMoved(vertex: string): boolean {
  return useDrag(({ payload }) => movedBy(payload).has(vertex));
}
