/**
 * Two fingers: pinch to zoom, move to pan, wherever they are put down. The viewport's own gestures leave vertices out
 * (one finger moves them), and on a small screen two fingers hardly find a place between them.
 */
import { useReactFlow } from "@xyflow/react";
import { type RefObject, useEffect } from "react";

import { cancelDrag } from "../../session/drag";
import { restFollowing } from "../../session/view";
import { type Spread, watchPinch } from "../../ui/pinch";
import { LEAST_ZOOM, MOST_ZOOM } from "./zoom-range";

interface Camera {
  x: number;
  y: number;
  zoom: number;
}

/** The camera that keeps what was between the fingers between them; places in px from the canvas's corner. */
export function pinched({ x, y, zoom }: Camera, before: Spread, now: Spread): Camera {
  const next = Math.min(MOST_ZOOM, Math.max(Math.min(LEAST_ZOOM, zoom), (zoom * now.far) / before.far));
  const by = next / zoom;
  return { x: now.x - (before.x - x) * by, y: now.y - (before.y - y) * by, zoom: next };
}

/** Draws nothing: the gestures of the canvas, where there are fingers. */
export function Pinch({ root }: { root: RefObject<HTMLDivElement | null> }): null {
  const flow = useReactFlow();
  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    return watchPinch(canvas, {
      begin: () => {
        cancelDrag();
        return true;
      },
      move: (before, now) => {
        restFollowing();
        void flow.setViewport(pinched(flow.getViewport(), before, now));
      },
    });
  }, [flow, root]);
  return null;
}
