/**
 * Two fingers: pinch to zoom, move to pan, wherever they are put down. One finger pans beside vertices only (it moves
 * them), and on a small screen two fingers hardly find a place between them.
 */
import { type RefObject, useEffect } from "react";

import { cancelDrag } from "../../session/drag";
import { restFollowing } from "../../session/view";
import { type Spread, watchPinch } from "../../ui/pinch";
import { type Camera, useCamera, zoomed } from "./camera";
import { LEAST_ZOOM, MOST_ZOOM } from "./zoom-range";

/** The camera that keeps what was between the fingers between them; places in px from the canvas's corner. */
export function pinched(camera: Camera, before: Spread, now: Spread): Camera {
  const { zoom } = camera;
  const next = Math.min(MOST_ZOOM, Math.max(Math.min(LEAST_ZOOM, zoom), (zoom * now.far) / before.far));
  const { x, y } = zoomed(camera, next, before);
  return { x: x + now.x - before.x, y: y + now.y - before.y, zoom: next };
}

/** Draws nothing: the gestures of the canvas, where there are fingers. */
export function Pinch({ root }: { root: RefObject<HTMLDivElement | null> }): null {
  const camera = useCamera();
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
        camera.jump(pinched(camera.now(), before, now));
      },
    });
  }, [camera, root]);
  return null;
}
