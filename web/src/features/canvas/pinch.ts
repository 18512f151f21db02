/**
 * Two fingers: pinch to zoom, move to pan, wherever they are put down. The viewport's own gestures leave vertices out
 * (one finger moves them), and on a small screen two fingers hardly find a place between them.
 */
import { useReactFlow } from "@xyflow/react";
import { type RefObject, useEffect } from "react";

import { cancelDrag } from "../../session/drag";
import { restFollowing } from "../../session/view";
import { LEAST_ZOOM, MOST_ZOOM } from "./zoom-range";

interface Spread {
  x: number;
  y: number;
  far: number;
}

interface Camera {
  x: number;
  y: number;
  zoom: number;
}

/** The middle of two fingers and how far they are apart. */
function spreadOf(touches: TouchList): Spread | null {
  const [a, b] = [touches[0], touches[1]];
  if (a === undefined || b === undefined || touches.length !== 2) return null;
  const far = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  return { x: (a.clientX + b.clientX) / 2, y: (a.clientY + b.clientY) / 2, far: Math.max(1, far) };
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
    let before: Spread | null = null;
    const inside = (spread: Spread): Spread => {
      const { left, top } = canvas.getBoundingClientRect();
      return { ...spread, x: spread.x - left, y: spread.y - top };
    };
    const begin = (event: TouchEvent) => {
      before = spreadOf(event.touches);
      if (before === null) return;
      cancelDrag();
      event.preventDefault();
      event.stopPropagation();
    };
    const move = (event: TouchEvent) => {
      const now = spreadOf(event.touches);
      if (before === null || now === null) return;
      event.preventDefault();
      event.stopPropagation();
      restFollowing();
      void flow.setViewport(pinched(flow.getViewport(), inside(before), inside(now)));
      before = now;
    };
    const end = (event: TouchEvent) => {
      before = spreadOf(event.touches);
    };
    const captured = { capture: true, passive: false };
    canvas.addEventListener("touchstart", begin, captured);
    canvas.addEventListener("touchmove", move, captured);
    canvas.addEventListener("touchend", end, true);
    canvas.addEventListener("touchcancel", end, true);
    return () => {
      canvas.removeEventListener("touchstart", begin, captured);
      canvas.removeEventListener("touchmove", move, captured);
      canvas.removeEventListener("touchend", end, true);
      canvas.removeEventListener("touchcancel", end, true);
    };
  }, [flow, root]);
  return null;
}
