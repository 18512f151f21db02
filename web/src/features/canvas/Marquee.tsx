/** Shift-drag on the void draws a box; what it touches is selected, besides what was. */
import { type RefObject, useEffect, useState } from "react";

import type { Point } from "../../model/layout";
import { useStudio } from "../../model/studio";
import { currentDrawing, type Drawing } from "../../session/drawing";
import { holdingStill, useView } from "../../session/view";
import { endAll, listen } from "../../ui/effects";
import { useCamera } from "./camera";

interface Rect {
  x: number;
  y: number;
  w: number;
  h: number;
}

function between(a: Point, b: Point): Rect {
  return { x: Math.min(a.x, b.x), y: Math.min(a.y, b.y), w: Math.abs(a.x - b.x), h: Math.abs(a.y - b.y) };
}

/** The vertices that a box of the graph touches, in reading order. */
export function touched({ layout }: Drawing, box: Rect): string[] {
  return layout.nodes.flatMap(({ vertex, block, kind, x, y, w, h }) => {
    const apart = x > box.x + box.w || x + w < box.x || y > box.y + box.h || y + h < box.y;
    return apart || block === null || kind === "barEnd" ? [] : [vertex];
  });
}

export function Marquee({ root }: { root: RefObject<HTMLDivElement | null> }) {
  const camera = useCamera();
  const [box, setBox] = useState<Rect | null>(null);

  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    let from: Point = { x: 0, y: 0 };
    let before: string[] = [];

    const move = (event: PointerEvent) => {
      const to = { x: event.clientX, y: event.clientY };
      const corner = canvas.getBoundingClientRect();
      const drawn = between(from, to);
      setBox({ ...drawn, x: drawn.x - corner.left, y: drawn.y - corner.top });
      const drawing = currentDrawing();
      if (drawing === null) return;
      const inside = touched(drawing, between(camera.point(from, corner), camera.point(to, corner)));
      holdingStill(() => {
        const { selection, select } = useStudio.getState();
        const wanted = [...new Set([...before, ...inside])];
        if (wanted.length !== selection.length || wanted.some((id, at) => id !== selection[at])) select(wanted);
      });
    };
    let endFollowing = () => {};
    const end = () => {
      endFollowing();
      setBox(null);
      useView.getState().viewport?.focus();
    };
    const down = (event: MouseEvent) => {
      const { target } = event;
      if (!event.shiftKey || event.button !== 0) return;
      if (!(target instanceof Element) || !target.classList.contains("canvas-pane")) return;
      event.preventDefault();
      from = { x: event.clientX, y: event.clientY };
      before = useStudio.getState().selection;
      endFollowing = listen(window, { pointermove: move, pointerup: end, pointercancel: end });
    };
    // The click at the end does not clear the selection.
    const click = (event: MouseEvent) => {
      if (event.shiftKey && event.target instanceof Element && event.target.classList.contains("canvas-pane"))
        event.stopPropagation();
    };
    return endAll(() => endFollowing(), listen(canvas, { mousedown: down, click }, { capture: true }));
  }, [camera, root]);

  return box === null ? null : (
    <div
      className="marquee passive"
      style={{ width: box.w, height: box.h, transform: `translate(${String(box.x)}px, ${String(box.y)}px)` }}
    />
  );
}
