/**
 * The graph of the program in view.
 *
 * The pane pans and zooms; places come from the layout, and of those what can be seen is drawn (`part.ts`). Selection and
 * edits go through the document's store.
 */
import "./canvas.css";
import "./vertex.css";

import { useEffect, useRef } from "react";
import { createPortal } from "react-dom";

import { t } from "../../i18n/words";
import { title } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { reportError } from "../../session/document";
import { setResolver, useDrag } from "../../session/drag";
import { currentDrawing, type Drawing, nodeOf, useDrawing } from "../../session/drawing";
import {
  acceptedPlaces,
  insideOf,
  REACH,
  slotOnScreen,
  type Target,
  targetInLayout,
  wrapTarget,
} from "../../session/targets";
import { dropArc, sayOnCanvas, useView } from "../../session/view";
import { Icon, Tile } from "../../theme";
import { later } from "../../ui/later";
import { Tool } from "../../ui/Tool";
import { ActiveVertices } from "./active";
import { AddPopup } from "./AddPopup";
import { CameraContext, useCamera } from "./camera";
import { useClipboard } from "./clipboard";
import { useContextMenu } from "./context";
import { useEdgePan } from "./edgePan";
import { useCanvasKeys } from "./keys";
import { Lines } from "./Lines";
import { Marquee } from "./Marquee";
import { Nodes } from "./Nodes";
import { Pane } from "./Pane";
import { usePart } from "./part";
import { usePlain } from "./Plain";
import { useFirstCamera, useViewport } from "./viewport";
import { leastZoom } from "./zoom-range";
import { ZoomControl } from "./ZoomControl";

const ContextMenu = later(() => import("./ContextMenu").then((chunk) => chunk.ContextMenu), reportError);
const Pinch = later(() => import("./pinch").then((chunk) => chunk.Pinch), reportError);
const NoteEditor = later(() => import("./NoteEditor").then((chunk) => chunk.NoteEditor), reportError, { typing: true });
const Find = later(() => import("./Find").then((chunk) => chunk.Find), reportError, { typing: true });
const InPlace = later(() => import("./InPlace").then((chunk) => chunk.InPlace), reportError, { typing: true });
const Minimap = later(() => import("./Minimap").then((chunk) => chunk.Minimap), reportError);
const FirstSteps = later(() => import("./FirstSteps").then((chunk) => chunk.FirstSteps), reportError, {
  words: false,
});

/** The graph of the program in view; fills its parent. */
export function Canvas() {
  const drawing = useDrawing();
  const finding = useView((state) => state.finding);
  if (drawing === null) return <div className="canvas focus-inside" />;
  return (
    <div className="canvas-room relative">
      <CanvasOf key={drawing.program.name} drawing={drawing} />
      {finding ? <Find /> : null}
    </div>
  );
}

/** Each program has a camera of its own. */
function CanvasOf({ drawing }: { drawing: Drawing }) {
  const camera = useFirstCamera(drawing);
  return (
    <CameraContext value={camera}>
      <Graph drawing={drawing} />
    </CameraContext>
  );
}

function Graph({ drawing }: { drawing: Drawing }) {
  const root = useRef<HTMLDivElement>(null);
  useViewport(root, drawing);
  useDropTargets(root);
  useEdgePan(root);
  useCanvasKeys(root);
  useClipboard();
  useContextMenu(root);
  const dragged = useDrag(({ payload }) => payload);
  const accepts =
    dragged === null
      ? ""
      : acceptedPlaces(drawing.parts, drawing.parts.shape(dragged.element), dragged.kind === "vertices");
  const plain = usePlain();
  const part = usePart(plain);
  const { layout } = drawing;
  const adding = useView((state) => state.adding);
  const minimap = useView((state) => state.minimap);
  const menu = useView((state) => state.menu !== null);
  const noting = useView((state) => state.noting);
  const editing = useView((state) => state.editing);
  const empty = drawing.nodes.has("place");
  const last = useStudio((state) => state.selection.at(-1));

  return (
    <div
      ref={root}
      className="canvas focus-inside"
      data-accepts={accepts}
      data-plain={plain}
      role="application"
      tabIndex={0}
      aria-activedescendant={shownBy(drawing, last)}
      aria-label={t("graph.label", { name: drawing.program.name })}
      data-testid="canvas"
    >
      <Pane
        least={leastZoom(layout.bounds)}
        dots={!plain}
        onPress={() => {
          useStudio.getState().select([]);
          dropArc();
        }}
      >
        <Nodes layout={layout} part={part} plain={plain} />
        <Lines layout={layout} part={part} plain={plain} />
        {empty ? <FirstSteps drawing={drawing} /> : null}
      </Pane>
      {empty ? null : <ZoomControl />}
      {adding === null ? null : <AddPopup key={drawing.program.name} adding={adding} drawing={drawing} />}
      {noting === null ? null : <NoteEditor key={noting} id={noting} program={drawing.program.name} />}
      {editing === null ? null : <InPlace key={`${editing.vertex} ${editing.slot}`} drawing={drawing} {...editing} />}
      {minimap ? <Minimap layout={layout} /> : null}
      <Marquee root={root} />
      {navigator.maxTouchPoints > 0 ? <Pinch root={root} /> : null}
      <CanvasMessage />
      {menu ? <ContextMenu /> : null}
      <Ghost />
      <ActiveVertices program={drawing.program.name} />
    </div>
  );
}

/** The id of the element that shows a vertex: its own, its chip's, or that of the vertex which holds it. */
function shownBy(drawing: Drawing, id: string | undefined): string | undefined {
  const node = id === undefined ? undefined : nodeOf(drawing, id);
  if (id === undefined || node === undefined) return undefined;
  return `vertex-${node.face.chips.some(({ filler }) => filler === id) ? id : node.vertex}`;
}

/** Tells a drag where its thing would go on this canvas. */
function useDropTargets(root: React.RefObject<HTMLDivElement | null>): void {
  const camera = useCamera();
  useEffect(() => {
    setResolver((at, payload): Target | null => {
      const drawing = currentDrawing();
      const box = root.current?.getBoundingClientRect();
      if (drawing === null || root.current === null || box === undefined) return null;
      if (at.x < box.left || at.x > box.right || at.y < box.top || at.y > box.bottom) return null;
      const shape = drawing.parts.shape(payload.element);
      const moving = payload.kind === "vertices" ? insideOf(drawing, payload.ids) : new Set<string>();
      const point = camera.point(at, box);
      const around = payload.kind === "part" ? wrapTarget(drawing, point, shape, useStudio.getState().selection) : null;
      if (around !== null) return around;
      const slot = slotOnScreen(drawing, root.current, at, shape, moving);
      if (slot !== null) return slot;
      return targetInLayout(drawing, point, REACH / camera.now().zoom, shape, moving);
    });
    return () => {
      setResolver(() => null);
    };
  }, [camera, root]);
}

/** What follows the pointer during a drag. */
function Ghost() {
  const payload = useDrag((state) => state.payload);
  const { x, y } = useDrag((state) => state.at);
  const copy = useDrag((state) => state.copy);
  const aside = useDrag((state) => state.target?.place.kind === "void");
  const drawing = useDrawing();
  if (payload === null || drawing === null) return null;
  const shape = drawing.parts.shape(payload.element);
  const many = payload.kind === "vertices" && payload.ids.length > 1 ? ` +${String(payload.ids.length - 1)}` : "";
  return createPortal(
    <div
      className="ghost row nowrap carried"
      style={{ transform: `translate(${String(x + 10)}px, ${String(y + 12)}px)` }}
      data-colour={shape.colour}
    >
      <Tile icon={shape.icon} colour={shape.colour} size={22} />
      <strong>
        {title(shape)}
        {many}
      </strong>
      {copy && payload.kind === "vertices" ? <span className="ghost-plus badge bold">+</span> : null}
      {aside ? <span className="muted">{t("graph.park-here")}</span> : null}
    </div>,
    document.body,
  );
}

/** What the canvas has to say about the last thing that was tried: a sentence, gone at the next change. */
function CanvasMessage() {
  const said = useView((state) => state.said);
  useEffect(
    () =>
      useStudio.subscribe((state, before) => {
        if (state.mission !== before.mission || state.activeProgram !== before.activeProgram) sayOnCanvas("");
      }),
    [],
  );
  return (
    <div className="said surface row" role="status" data-testid="said" hidden={said === ""}>
      <Icon name="info" size={16} />
      <span>{said}</span>
      <Tool small icon="x" label={t("graph.close")} onClick={() => sayOnCanvas("")} />
    </div>
  );
}
