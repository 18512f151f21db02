/** Where the canvas looks: at first as `home.ts` says, remembered for each program, moved only as far as needed. */
import { type RefObject, useEffect, useEffectEvent, useLayoutEffect, useRef, useState } from "react";
import { create } from "zustand";

import { hasCoarsePointer } from "../../i18n/touch";
import { boundsOf, type Box } from "../../model/layout";
import { useStudio } from "../../model/studio";
import { currentDrawing, type Drawing, nodeOf } from "../../session/drawing";
import { restFollowing, setViewport, standsStill, useView } from "../../session/view";
import { listen } from "../../ui/effects";
import { type Camera, type CanvasCamera, createCamera, type Size, useCamera, zoomed } from "./camera";
import { afterResize, homeOf, LEAST_READABLE, type Whole, wholeOf } from "./home";
import { spotOfArc } from "./Lines";
import { leastZoom, MOST_ZOOM } from "./zoom-range";

const MARGIN = 48;
/** A small selection does not fill the canvas. */
const CLOSEST = 1.25;
const STEP = 1.2;
/** What is left free around all of a program, as a part of the canvas. */
const AROUND = 0.03;

/** The cameras that programs of a mission were left with, by name; those of one mission at a time. */
const useLeftCameras = create<{ file: string; cameras: ReadonlyMap<string, Camera> }>(() => ({
  file: "",
  cameras: new Map(),
}));

function leftCamera(file: string, program: string): Camera | undefined {
  const left = useLeftCameras.getState();
  return left.file === file ? left.cameras.get(program) : undefined;
}

function leaveCamera(file: string, program: string, camera: Camera): void {
  const left = useLeftCameras.getState();
  const cameras = new Map(left.file === file ? left.cameras : []).set(program, camera);
  useLeftCameras.setState({ file, cameras });
}

function sizeOf(element: HTMLElement | null): Size {
  return { width: element?.clientWidth ?? 0, height: element?.clientHeight ?? 0 };
}

/** How large the canvas will be: its panel is on the page before it, but for one that is covered. */
function roomNow(): Size {
  const room = sizeOf(document.getElementById("canvas-panel"));
  return room.width > 0 ? room : { width: 904, height: 840 };
}

/** How small a program may open: readable, and with fingers everything that is pressed keeps its 44 px. */
function leastAtFirst(): number {
  return hasCoarsePointer() ? 1 : LEAST_READABLE;
}

/** The camera with which a canvas begins. */
export function useFirstCamera(drawing: Drawing): CanvasCamera {
  const [camera] = useState(() => {
    const [file, room] = [useStudio.getState().file.path, roomNow()];
    return createCamera(leftCamera(file, drawing.program.name) ?? wholeOf(room, drawing, leastAtFirst()), room);
  });
  return camera;
}

/** The camera that shows a box whole and in the middle. */
function cameraOn(box: Box, { width, height }: Size, zoom: number): Camera {
  return { x: width / 2 - (box.x + box.w / 2) * zoom, y: height / 2 - (box.y + box.h / 2) * zoom, zoom };
}

/** Keeps the camera as the canvas and the program change, and gives `useView` the calls that move it. */
export function useViewport(root: RefObject<HTMLDivElement | null>, drawing: Drawing): void {
  const camera = useCamera();
  const { name } = drawing.program;
  const file = useStudio((state) => state.file.path);
  /** How wide the canvas was for its camera, and the camera that showed all, if that was the last one asked for. */
  const stood = useRef<{ width: number; whole: Whole | null } | null>(null);

  useEffect(
    () => () => {
      leaveCamera(file, name, camera.now());
    },
    [camera, file, name],
  );

  const begin = useEffectEvent(() => {
    const size = sizeOf(root.current);
    // An empty program is seen from its beginning, whatever an empty one of that name was left as.
    const isNew = size.width > 0 && (leftCamera(file, name) === undefined || drawing.nodes.has("place"));
    const least = leastAtFirst();
    const whole = isNew ? { camera: wholeOf(size, drawing, least), least } : null;
    stood.current = { width: size.width, whole };
    if (size.width > 0) camera.resize(size);
    if (whole !== null) camera.jump(whole.camera);
  });
  useLayoutEffect(() => {
    begin();
  }, [camera]);

  useEffect(() => {
    const size = () => sizeOf(root.current);
    const zoomBy = (factor: number) => {
      const now = currentDrawing();
      const [{ width, height }, { zoom }] = [size(), camera.now()];
      const least = now === null ? zoom : leastZoom(now.layout.bounds);
      const next = Math.min(MOST_ZOOM, Math.max(least, zoom * factor));
      camera.glide(zoomed(camera.now(), next, { x: width / 2, y: height / 2 }));
    };
    setViewport({
      zoomIn: () => zoomBy(STEP),
      zoomOut: () => zoomBy(1 / STEP),
      home: () => {
        restFollowing();
        const now = currentDrawing();
        if (now !== null) camera.glide(homeOf(size(), now));
      },
      fit: () => {
        const now = currentDrawing();
        if (now === null) return;
        const { bounds } = now.layout;
        const { width, height } = size();
        const zoom = (1 - 2 * AROUND) * Math.min(width / bounds.w, height / bounds.h);
        camera.glide(cameraOn(bounds, size(), Math.min(MOST_ZOOM, Math.max(leastZoom(bounds), zoom))));
      },
      whole: () => {
        const before = camera.now();
        const whole = stood.current?.whole ?? null;
        const now = currentDrawing();
        if (now !== null) {
          const all = wholeOf(size(), now, 0.5);
          stood.current = { width: size().width, whole: { camera: all, least: 0.5 } };
          camera.jump(all);
        }
        return () => {
          stood.current = { width: size().width, whole };
          camera.jump(before);
        };
      },
      zoomToSelection: () => {
        restFollowing();
        const now = currentDrawing();
        const box = now === null ? null : boundsOfVertices(now, useStudio.getState().selection);
        if (box === null) {
          useView.getState().viewport?.fit();
          return;
        }
        const { width, height } = size();
        const room = 2 * MARGIN;
        const zoom = Math.min(CLOSEST, Math.max(0.1, Math.min((width - room) / box.w, (height - room) / box.h)));
        camera.glide(cameraOn(box, size(), zoom));
      },
      reveal: (id) => {
        const now = currentDrawing();
        const node = now === null ? undefined : nodeOf(now, id);
        if (node === undefined) return;
        const { width: all, height } = size();
        // The find panel covers the right side.
        const width = useView.getState().finding && all > 840 ? all - 412 : all;
        const { x, y, zoom } = camera.now();
        const nudge = (from: number, long: number, room: number) => {
          if (from < MARGIN) return MARGIN - from;
          return from + long > room - MARGIN ? Math.max(room - MARGIN - from - long, MARGIN - from) : 0;
        };
        const dx = nudge(node.x * zoom + x, node.w * zoom, width);
        const dy = nudge(node.y * zoom + y, node.h * zoom, height);
        if (dx !== 0 || dy !== 0) camera.glide({ x: x + dx, y: y + dy, zoom });
      },
      place: camera.place,
      focus: () => root.current?.focus({ preventScroll: true }),
    });
    return () => {
      setViewport(null);
    };
  }, [camera, root]);

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
    // The browser scrolls to what it shows (focus, find in page): the camera goes there in its place.
    const pan = ({ target }: Event) => {
      if (!(target instanceof HTMLElement) || !target.classList.contains("canvas-pane")) return;
      const { scrollLeft, scrollTop } = target;
      target.scrollTo({ left: 0, top: 0, behavior: "instant" });
      camera.pan(-scrollLeft, -scrollTop);
    };
    return listen(canvas, { scroll: pan }, { capture: true });
  }, [camera, root]);
  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    // A window, a phone that is turned, a line that is dragged: what was in view stays in view.
    const watcher = new ResizeObserver(() => {
      const [size, was, now] = [sizeOf(canvas), stood.current, currentDrawing()];
      if (size.width === 0) return;
      camera.resize(size);
      if (was === null || was.width === size.width || now === null) return;
      const next = afterResize(camera.now(), was.width, size, now, was.whole);
      stood.current = { width: size.width, whole: next.whole };
      camera.jump(next.camera);
    });
    watcher.observe(canvas);
    return () => {
      watcher.disconnect();
    };
  }, [camera, root]);
}

/** The box around vertices and the frames they own, or null for none. */
function boundsOfVertices(drawing: Drawing, ids: string[]): Box | null {
  const nodes = ids.flatMap((id) => nodeOf(drawing, id) ?? []);
  const owners = new Set(nodes.map((node) => node.id));
  const boxes = [...nodes, ...drawing.layout.frames.filter((frame) => owners.has(frame.id))];
  return boxes.length === 0 ? null : boundsOf(boxes);
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
