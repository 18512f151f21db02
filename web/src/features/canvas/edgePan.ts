/** While something is dragged near the canvas's edge, the graph moves, so that every place can be reached. */
import { type RefObject, useEffect } from "react";

import { retarget, useDrag } from "../../session/drag";
import { useCamera } from "./camera";

const NEAR = 40;
const MOST_A_FRAME = 12;

/** How far to move in a frame for a pointer `inside` px from the near edge. */
function pull(inside: number): number {
  return inside >= 0 && inside < NEAR ? ((NEAR - inside) / NEAR) * MOST_A_FRAME : 0;
}

export function useEdgePan(root: RefObject<HTMLDivElement | null>): void {
  const camera = useCamera();
  useEffect(() => {
    let frame = 0;
    /** A drag that comes in over the edge pans only once it has been further inside. */
    let armed = false;
    const step = () => {
      const { at, payload } = useDrag.getState();
      const box = root.current?.getBoundingClientRect();
      if (payload === null || box === undefined) {
        frame = 0;
        return;
      }
      frame = requestAnimationFrame(step);
      const [left, right] = [at.x - box.left, box.right - at.x];
      const [top, bottom] = [at.y - box.top, box.bottom - at.y];
      armed ||= Math.min(left, right, top, bottom) > NEAR;
      const dx = pull(left) - pull(right);
      const dy = pull(top) - pull(bottom);
      if (!armed || (dx === 0 && dy === 0) || Math.min(left, right, top, bottom) < 0) return;
      camera.pan(dx, dy);
      retarget();
    };
    const stop = useDrag.subscribe(({ payload }) => {
      if (payload === null || frame !== 0) return;
      armed = false;
      frame = requestAnimationFrame(step);
    });
    return () => {
      stop();
      cancelAnimationFrame(frame);
    };
  }, [camera, root]);
}
