/**
 * Where the canvas looks: a store with the camera and the size of the canvas, and the calls that move it.
 *
 * A point (x, y) of the graph stands at (x · zoom + camera.x, y · zoom + camera.y), in px from the corner of the canvas.
 */
import { createContext, useContext } from "react";
import { useStore } from "zustand";
import { createStore } from "zustand/vanilla";

import type { Point } from "../../model/layout";

export interface Camera {
  x: number;
  y: number;
  zoom: number;
}

export interface Size {
  width: number;
  height: number;
}

const MOVE_MS = 140;

/** The camera that shows the graph so large, while `at` of the canvas stays where it is. */
export function zoomed({ x, y, zoom }: Camera, next: number, at: Point): Camera {
  const by = next / zoom;
  return { x: at.x - (at.x - x) * by, y: at.y - (at.y - y) * by, zoom: next };
}

/** Slow at both ends. */
function eased(share: number): number {
  return share < 0.5 ? 4 * share ** 3 : 1 - 4 * (1 - share) ** 3;
}

export function createCamera(first: Camera, size: Size) {
  const store = createStore<Camera & Size>(() => ({ ...first, ...size }));
  let frame = 0;

  const now = (): Camera => {
    const { x, y, zoom } = store.getState();
    return { x, y, zoom };
  };
  const jump = (camera: Camera) => {
    cancelAnimationFrame(frame);
    store.setState(camera);
  };
  return {
    store,
    now,
    jump,
    /** Goes there in a moment; at once for who wants less motion. */
    glide: (to: Camera) => {
      if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
        jump(to);
        return;
      }
      cancelAnimationFrame(frame);
      const [from, begin] = [now(), performance.now()];
      const step = (time: number) => {
        const share = Math.min(1, Math.max(0, (time - begin) / MOVE_MS));
        const mix = (key: keyof Camera) => from[key] + (to[key] - from[key]) * eased(share);
        store.setState(share === 1 ? to : { x: mix("x"), y: mix("y"), zoom: mix("zoom") });
        if (share < 1) frame = requestAnimationFrame(step);
      };
      frame = requestAnimationFrame(step);
    },
    pan: (dx: number, dy: number) => {
      const { x, y, zoom } = now();
      jump({ x: x + dx, y: y + dy, zoom });
    },
    resize: (size: Size) => store.setState(size),
    /** A point of the graph, in px from the corner of the canvas. */
    place: (point: Point): Point => {
      const { x, y, zoom } = now();
      return { x: point.x * zoom + x, y: point.y * zoom + y };
    },
    /** The other way round; `at` is in px of the window, as is `corner`, that of the canvas. */
    point: (at: Point, corner: { left: number; top: number }): Point => {
      const { x, y, zoom } = now();
      return { x: (at.x - corner.left - x) / zoom, y: (at.y - corner.top - y) / zoom };
    },
  };
}

export type CanvasCamera = ReturnType<typeof createCamera>;

export const CameraContext = createContext<CanvasCamera | null>(null);

/** The camera of the canvas around. */
export function useCamera(): CanvasCamera {
  const camera = useContext(CameraContext);
  if (camera === null) throw new Error("there is no canvas around");
  return camera;
}

/** What a component shows of it. */
export function useCameraState<T>(select: (state: Camera & Size) => T): T {
  return useStore(useCamera().store, select);
}
