/**
 * The graph of the program in view.
 *
 * React Flow is the viewport: it pans, zooms and renders the vertices that can be seen. Places come from the layout,
 * frames and arcs are our own layers (Lines.tsx), selection and edits go through the document's store.
 */
import "@xyflow/react/dist/base.css";
import "./canvas.css";
import "./vertex.css";

import { Background, BackgroundVariant, ReactFlow, ReactFlowProvider, useReactFlow } from "@xyflow/react";
import { useEffect, useMemo, useRef } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { complain } from "../../session/document";
import { setResolver, useDrag } from "../../session/drag";
import { currentDrawing, type Drawing, nodeOf, useDrawing } from "../../session/drawing";
import { insideOf, REACH, slotOnScreen, type Target, targetInLayout, wrapTarget } from "../../session/targets";
import { useView } from "../../session/view";
import { later } from "../../ui/later";
import { ActiveVertices } from "./active";
import { AddPopup } from "./AddPopup";
import { useClipboard } from "./clipboard";
import { useContextMenu } from "./context";
import { useEdgePan } from "./edgePan";
import { Ghost } from "./Ghost";
import { useCanvasKeys } from "./keys";
import { Lines } from "./Lines";
import { Marquee } from "./Marquee";
import { type GraphNode, NODE_TYPES, PLAIN_TYPES } from "./Nodes";
import { usePlain } from "./Plain";
import { Said } from "./Said";
import { moved, useViewport } from "./viewport";
import { leastZoom, MOST_ZOOM } from "./zoom-range";
import { ZoomControl } from "./ZoomControl";

const ContextMenu = later(() => import("./ContextMenu").then((chunk) => chunk.ContextMenu), complain);
const Pinch = later(() => import("./pinch").then((chunk) => chunk.Pinch), complain);
const NoteEditor = later(() => import("./NoteEditor").then((chunk) => chunk.NoteEditor), complain, true);
const Find = later(() => import("./Find").then((chunk) => chunk.Find), complain, true);
const InPlace = later(() => import("./InPlace").then((chunk) => chunk.InPlace), complain, true);
const Minimap = later(() => import("./Minimap").then((chunk) => chunk.Minimap), complain);
const EmptyTeaching = later(() => import("./EmptyTeaching").then((chunk) => chunk.EmptyTeaching), complain);

/** The graph of the program in view; fills its parent. */
export function Canvas() {
  const drawing = useDrawing();
  const finding = useView((state) => state.finding);
  if (drawing === null) return <div className="canvas" />;
  return (
    <div className="canvas-room">
      <ReactFlowProvider key={drawing.program.name}>
        <Graph drawing={drawing} />
      </ReactFlowProvider>
      {finding ? <Find /> : null}
    </div>
  );
}

/** React Flow is named in *About*, with the licences. */
const PRO_OPTIONS = { hideAttribution: true };

function nodesOf({ layout }: Drawing): GraphNode[] {
  return layout.nodes.map((node) => ({
    id: node.id,
    type: "vertex",
    position: { x: node.x, y: node.y },
    width: node.w,
    height: node.h,
    // Sizes and (no) handles are known: React Flow need not render a vertex to measure it.
    measured: { width: node.w, height: node.h },
    handles: [],
    data: { node },
    className: "nopan",
  }));
}

function Graph({ drawing }: { drawing: Drawing }) {
  const root = useRef<HTMLDivElement>(null);
  const nodes = useMemo(() => nodesOf(drawing), [drawing]);
  const { first, onReady } = useViewport(root, drawing);
  useDropTargets(root);
  useEdgePan(root);
  useCanvasKeys(root);
  useClipboard();
  useContextMenu(root);
  const accepts = useDrag(({ payload, target }) => {
    if (payload === null) return "";
    return target === null || target.place.kind === "arc" || target.place.kind === "void" ? "arcs" : "others";
  });
  const plain = usePlain();
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
      className="canvas"
      data-accepts={accepts}
      data-plain={plain}
      role="application"
      tabIndex={0}
      aria-activedescendant={shownBy(drawing, last)}
      aria-label={t("graph.label", { name: drawing.program.name })}
      data-testid="canvas"
    >
      <ReactFlow
        nodes={nodes}
        nodeTypes={plain ? PLAIN_TYPES : NODE_TYPES}
        defaultViewport={first}
        onInit={onReady}
        onMove={moved}
        minZoom={leastZoom(drawing.layout.bounds)}
        maxZoom={MOST_ZOOM}
        onlyRenderVisibleElements
        nodesDraggable={false}
        nodesConnectable={false}
        nodesFocusable={false}
        elementsSelectable={false}
        selectionKeyCode={null}
        multiSelectionKeyCode={null}
        deleteKeyCode={null}
        disableKeyboardA11y
        ariaLabelConfig={{
          "node.a11yDescription.default": t("help.keys-walk"),
          "edge.a11yDescription.default": t("help.keys-insert"),
        }}
        zoomOnDoubleClick={false}
        proOptions={PRO_OPTIONS}
        onPaneClick={() => {
          useStudio.getState().select([]);
          useView.setState({ arc: null, adding: null });
        }}
      >
        {plain ? null : <Background variant={BackgroundVariant.Dots} gap={16} size={2} color="var(--canvas-dot)" />}
        <Lines drawing={drawing} plain={plain} />
        {empty ? <EmptyTeaching drawing={drawing} /> : null}
      </ReactFlow>
      <ZoomControl />
      {adding === null ? null : <AddPopup key={drawing.program.name} adding={adding} drawing={drawing} />}
      {noting === null ? null : <NoteEditor key={noting} id={noting} program={drawing.program.name} />}
      {editing === null ? null : <InPlace key={`${editing.vertex} ${editing.slot}`} drawing={drawing} {...editing} />}
      {minimap ? <Minimap layout={drawing.layout} /> : null}
      <Marquee root={root} />
      {navigator.maxTouchPoints > 0 ? <Pinch root={root} /> : null}
      <Said />
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
  const flow = useReactFlow();
  useEffect(() => {
    setResolver((at, payload): Target | null => {
      const drawing = currentDrawing();
      const box = root.current?.getBoundingClientRect();
      if (drawing === null || root.current === null || box === undefined) return null;
      if (at.x < box.left || at.x > box.right || at.y < box.top || at.y > box.bottom) return null;
      const shape = drawing.parts.shape(payload.element);
      const moving = payload.kind === "vertices" ? insideOf(drawing, payload.ids) : new Set<string>();
      const point = flow.screenToFlowPosition(at, { snapToGrid: false });
      const around = payload.kind === "part" ? wrapTarget(drawing, point, shape, useStudio.getState().selection) : null;
      if (around !== null) return around;
      const slot = slotOnScreen(drawing, root.current, at, shape, moving);
      if (slot !== null) return slot;
      return targetInLayout(drawing, point, REACH / flow.getZoom(), shape, moving);
    });
    return () => {
      setResolver(() => null);
    };
  }, [flow, root]);
}
