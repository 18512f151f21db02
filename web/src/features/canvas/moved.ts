/** Whether a drag takes a vertex along: it, and what it holds, is no place for what is dragged. */
import { type Payload, useDrag } from "../../session/drag";
import { currentDrawing } from "../../session/drawing";
import { insideOf } from "../../session/targets";

const NOTHING: ReadonlySet<string> = new Set();
/** For the drag that is on: every arc and slot asks. */
let last: { payload: Payload; inside: ReadonlySet<string> } | null = null;

function movedBy(payload: Payload | null): ReadonlySet<string> {
  if (payload?.kind !== "vertices") return NOTHING;
  if (last?.payload === payload) return last.inside;
  const drawing = currentDrawing();
  const inside = drawing === null ? NOTHING : insideOf(drawing, payload.ids);
  last = { payload, inside };
  return inside;
}

export function useMoved(vertex: string): boolean {
  return useDrag(({ payload }) => movedBy(payload).has(vertex));
}
