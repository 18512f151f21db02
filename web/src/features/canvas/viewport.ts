/** Where the canvas looks: at first as `home.ts` says, remembered for each program, moved only as far as needed. */
import { useReactFlow, useStoreApi, type Viewport as Camera } from "@xyflow/react";
import { type RefObject, useEffect, useRef, useState } from "react";

import { useStudio } from "../../model/studio";
import type { Drawing } from "../../session/drawing";
import { currentDrawing, nodeOf } from "../../session/drawing";
import { restFollowing, standsStill, useView } from "../../session/view";
import { afterResize, homeOf, LEAST_READABLE, type Size, type Whole, wholeOf } from "./home";
import { spotOfArc } from "./Lines";

const remembered = new Map<string, Camera>();
const MARGIN = 48;
const MOVE_MS = 140;
/** A small selection does not fill the canvas. */
const CLOSEST = 1.25;

/** How large the canvas was when it was last opened: the first guess for the next time. */
let last: Size = { width: 904, height: 840 };
let opened = "";

/** Clears the remembered viewports when another mission is opened. */
useStudio.subscribe((state, before) => {
  if (state.file.path !== before.file.path || state.file.revision === "") return;
  if (opened !== state.file.path) remembered.clear();
  opened = state.file.path;
});

function sizeOf(element: HTMLElement | null): Size {
  return { width: element?.clientWidth ?? 0, height: element?.clientHeight ?? 0 };
}

/** How large the canvas will be: its panel is on the page before it. */
function roomNow(): Size {
  const room = sizeOf(document.getElementById("canvas-panel"));
  return room.width > 0 ? room : last;
}

/** How small a program may open: readable, and with fingers everything that is pressed keeps its 44 px. */
function leastAtFirst(): number {
  return matchMedia("(pointer: coarse)").matches ? 1 : LEAST_READABLE;
}

let lastByHand: MouseEvent | TouchEvent | null = null;

/**
 * The canvas was moved, by that event if by hand; a move by hand rests following. Until d3-zoom ends a turn of the wheel,
 * 150 ms later, it gives the wheel's event with moves of the program too: an event counts once.
 */
export function moved(event: MouseEvent | TouchEvent | null): void {
  if (event === null || event === lastByHand) return;
  lastByHand = event;
  restFollowing();
}

/** The first camera, the callback for the ready viewport, and the viewport as `useView` has it. */
export function useViewport(
  root: RefObject<HTMLDivElement | null>,
  drawing: Drawing,
): { first: Camera; onReady: () => void } {
  const flow = useReactFlow();
  const store = useStoreApi();
  const { name } = drawing.program;
  const [first] = useState<Camera>(() => remembered.get(name) ?? wholeOf(roomNow(), drawing, leastAtFirst()));
  /** How wide the canvas was for its camera, and the camera that showed all, if that was the last one asked for. */
  const stood = useRef<{ width: number; whole: Whole | null } | null>(null);

  useEffect(
    () => () => {
      remembered.set(name, flow.getViewport());
    },
    [flow, name],
  );

  useEffect(() => {
    const size = () => sizeOf(root.current);
    const animated = { duration: matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : MOVE_MS };
    useView.setState({
      viewport: {
        zoomIn: () => void flow.zoomIn(animated),
        zoomOut: () => void flow.zoomOut(animated),
        home: () => {
          restFollowing();
          const now = currentDrawing();
          if (now !== null) void flow.setViewport(homeOf(size(), now), animated);
        },
        fit: () => {
          const now = currentDrawing();
          if (now === null) return;
          const { x, y, w, h } = now.layout.bounds;
          void flow.fitBounds({ x, y, width: w, height: h }, { padding: 0.06, ...animated });
        },
        whole: () => {
          const before = flow.getViewport();
          const whole = stood.current?.whole ?? null;
          const now = currentDrawing();
          if (now !== null) {
            const camera = wholeOf(size(), now, 0.5);
            stood.current = { width: size().width, whole: { camera, least: 0.5 } };
            void flow.setViewport(camera);
          }
          return () => {
            stood.current = { width: size().width, whole };
            void flow.setViewport(before);
          };
        },
        zoomToSelection: () => {
          restFollowing();
          const now = currentDrawing();
          const box = now === null ? null : boundsOf(now, useStudio.getState().selection);
          if (box === null) {
            useView.getState().viewport?.fit();
            return;
          }
          const { width, height } = size();
          const room = 2 * MARGIN;
          const zoom = Math.min(CLOSEST, Math.max(0.1, Math.min((width - room) / box.w, (height - room) / box.h)));
          const middle = { x: box.x + box.w / 2, y: box.y + box.h / 2 };
          void flow.setViewport({ x: width / 2 - middle.x * zoom, y: height / 2 - middle.y * zoom, zoom }, animated);
        },
        reveal: (id) => {
          const now = currentDrawing();
          const node = now === null ? undefined : nodeOf(now, id);
          if (node === undefined) return;
          const { width: all, height } = size();
          // The find panel covers the right side.
          const width = useView.getState().finding && all > 840 ? all - 412 : all;
          const { x, y, zoom } = flow.getViewport();
          const nudge = (from: number, long: number, room: number) => {
            if (from < MARGIN) return MARGIN - from;
            return from + long > room - MARGIN ? Math.max(room - MARGIN - from - long, MARGIN - from) : 0;
          };
          const dx = nudge(node.x * zoom + x, node.w * zoom, width);
          const dy = nudge(node.y * zoom + y, node.h * zoom, height);
          if (dx !== 0 || dy !== 0) void flow.setViewport({ x: x + dx, y: y + dy, zoom }, animated);
        },
        place: (point) => {
          const [x, y, zoom] = store.getState().transform;
          return { x: point.x * zoom + x, y: point.y * zoom + y };
        },
        focus: () => root.current?.focus({ preventScroll: true }),
      },
    });
    return () => {
      useView.setState({ viewport: null });
    };
  }, [flow, store, root]);

  useEffect(
    () =>
      // A vertex that was selected elsewhere, or made beyond the edge, comes into view.
      useStudio.subscribe((state, before) => {
        const latest = state.selection.at(-1);
        if (latest === undefined || state.selection === before.selection || standsStill()) return;
        queueMicrotask(() => useView.getState().viewport?.reveal(latest));
      }),
    [],
  );
  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    // React Flow undoes scrolling, so what the browser scrolled into view (focus, find in page) would go out of it again.
    const pan = ({ target }: Event) => {
      if (!(target instanceof HTMLElement) || !target.classList.contains("react-flow")) return;
      const { scrollLeft, scrollTop } = target;
      target.scrollTo({ left: 0, top: 0, behavior: "instant" });
      const { x, y, zoom } = flow.getViewport();
      void flow.setViewport({ x: x - scrollLeft, y: y - scrollTop, zoom });
    };
    canvas.addEventListener("scroll", pan, true);
    return () => {
      canvas.removeEventListener("scroll", pan, true);
    };
  }, [flow, root]);
  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    // A window, a phone that is turned, a line that is dragged: what was in view stays in view.
    const watcher = new ResizeObserver(() => {
      const [size, was, now] = [sizeOf(canvas), stood.current, currentDrawing()];
      if (size.width === 0 || was === null || was.width === size.width || now === null) return;
      const { camera, whole } = afterResize(flow.getViewport(), was.width, size, now, was.whole);
      stood.current = { width: size.width, whole };
      void flow.setViewport(camera);
    });
    watcher.observe(canvas);
    return () => {
      watcher.disconnect();
    };
  }, [flow, root]);
  const onReady = () => {
    const now = sizeOf(root.current);
    const guessed = now.width === last.width && now.height === last.height;
    const least = leastAtFirst();
    const isNew = !remembered.has(name) && now.width > 0;
    const camera = isNew && !guessed ? wholeOf(now, drawing, least) : first;
    if (camera !== first) void flow.setViewport(camera);
    stood.current = { width: now.width, whole: isNew ? { camera, least } : null };
    last = now;
  };
  return { first, onReady };
}

/** The box around vertices and the frames they own, or null for none. */
function boundsOf(drawing: Drawing, ids: string[]): { x: number; y: number; w: number; h: number } | null {
  const nodes = ids.flatMap((id) => nodeOf(drawing, id) ?? []);
  const owners = new Set(nodes.map((node) => node.id));
  const boxes = [...nodes, ...drawing.layout.frames.filter((frame) => owners.has(frame.id))];
  if (boxes.length === 0) return null;
  const x = Math.min(...boxes.map((box) => box.x));
  const y = Math.min(...boxes.map((box) => box.y));
  const right = Math.max(...boxes.map((box) => box.x + box.w));
  const bottom = Math.max(...boxes.map((box) => box.y + box.h));
  return { x, y, w: right - x, h: bottom - y };
}

/** Where a popup for the selection opens, in px from the canvas's corner. */
export function anchorOf(vertex: string | null, arc: string | null): { x: number; y: number } | null {
  const { viewport } = useView.getState();
  if (viewport === null) return null;
  const drawing = currentDrawing();
  const node = vertex === null || drawing === null ? undefined : nodeOf(drawing, vertex);
  if (node !== undefined) return viewport.place({ x: node.x + node.w / 2, y: node.y + node.h + 8 });
  const spot = spotOfArc(arc ?? "start.next");
  return spot === null ? null : viewport.place({ x: spot.x, y: spot.y + 16 });
}
