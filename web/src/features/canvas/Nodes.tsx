/** The vertices of the graph. Each takes its place and size from the layout. */
import { memo, useMemo } from "react";

import { hasCoarsePointer } from "../../i18n/touch";
import { t } from "../../i18n/words";
import type { Layout, LayoutNode } from "../../model/layout";
import { isMark } from "../../model/parts";
import type { Block } from "../../model/structure";
import { useStudio } from "../../model/studio";
import { chipOf } from "../../model/vertex-content";
import { beginDrag, justDragged, useDrag } from "../../session/drag";
import { spoken } from "../../session/spoken";
import { useView } from "../../session/view";
import { Icon } from "../../theme";
import { useThreadsAmong, useThreadsAt } from "./active";
import { Threads, Trouble } from "./Badges";
import { NoteStrip } from "./Notes";
import { boxInside, type Part } from "./part";
import { PlainNode } from "./Plain";
import { ChipView, selectVertex, Vertex } from "./Vertex";

/** Those that stand in a part of the graph; `plain` as they are looked at from far away. */
export function Nodes({ layout, part, plain }: { layout: Layout; part: Part; plain: boolean }) {
  return layout.nodes
    .filter((node) => boxInside(node, part))
    .map((node) => (
      <div
        key={node.id}
        className="canvas-node"
        data-id={node.id}
        style={{
          width: node.w,
          height: node.h,
          transform: `translate(${String(node.x)}px, ${String(node.y)}px)`,
        }}
      >
        <NodeView node={node} plain={plain} />
      </div>
    ));
}

const NodeView = memo(function NodeView({ node, plain }: { node: LayoutNode; plain: boolean }) {
  if (plain && node.kind !== "place") return <PlainNode node={node} />;
  switch (node.kind) {
    case "start":
    case "stop":
      return <Terminal node={node} />;
    case "bar":
    case "barEnd":
      return <Bar node={node} />;
    case "chip":
      return <Loose node={node} />;
    case "place":
      return <FirstPlace node={node} />;
    case "rect":
    case "hexagon":
      return <Vertex node={node} />;
  }
});

function Terminal({ node }: { node: LayoutNode }) {
  const { vertex: id, kind, w, h } = node;
  const selected = useStudio((state) => state.selection.includes(id));
  const threads = useThreadsAt(id, null);
  const name = t(kind === "start" ? "graph.start" : "graph.stop");
  return (
    <div
      className={`row justify-centre terminal${selected ? " is-selected" : ""}`}
      id={`vertex-${id}`}
      data-testid={`vertex-${id}`}
      role="group"
      aria-label={name}
      aria-current={selected}
      style={{ width: w, height: h }}
      onClick={(event) => selectVertex(id, event)}
    >
      <svg width="12" height="12" viewBox="0 0 12 12" aria-hidden="true">
        <path
          d={kind === "start" ? "M2 1.2v9.6L10.5 6Z" : "M1 1h10v10H1Z"}
          fill="currentColor"
          strokeLinejoin="round"
        />
      </svg>
      <strong>{name}</strong>
      <Threads threads={threads} />
      <Trouble id={id} />
      <NoteStrip node={node} />
    </div>
  );
}

/** A bar of a parallel; the first one carries its name. */
function Bar({ node }: { node: LayoutNode }) {
  const { vertex: id, kind, w, h, colour, block, face } = node;
  const selected = useStudio((state) => state.selection.includes(id));
  const threads = useThreadsAt(id, null);
  const aimed = useDrag((state) => state.target?.key === `vertex:${id}`);
  const first = kind === "bar";
  return (
    <div
      className={`bars${selected ? " is-selected" : ""}${aimed ? " is-aimed" : ""}`}
      data-testid={first ? `vertex-${id}` : `vertex-${id}-end`}
      data-colour={colour}
      id={first ? `vertex-${id}` : undefined}
      role="group"
      aria-label={spoken(node)}
      aria-current={selected}
      aria-hidden={first ? undefined : true}
      style={{ width: w, height: h }}
      onPointerDown={(event) => beginDrag(event, { kind: "vertices", ids: [id], element: block?.shape.element ?? "" })}
      onClick={(event) => {
        if (!justDragged()) selectVertex(id, event);
      }}
    >
      <span className="bar" />
      <NoteStrip node={node} />
      {first ? (
        <span className="bar-tag row">
          <Icon name={block?.shape.icon ?? ""} size={16} />
          {face.name}
          <Trouble id={id} />
        </span>
      ) : threads === "" ? null : (
        <Waits block={block} threads={threads} />
      )}
    </div>
  );
}

/** "▶0 waits for ▶1 ▶2", on the second bar. */
function Waits({ block, threads }: { block: Block | null; threads: string }) {
  const vertices = useMemo(() => (block === null ? [] : waitedVertices(block)), [block]);
  const others = useThreadsAmong(vertices);
  return (
    <span className="bar-waits row nowrap" data-testid={`waits-${block?.vertex.id ?? ""}`}>
      <Threads threads={threads} />
      {others === "" ? null : (
        <>
          <span>{t("graph.waits-for")}</span>
          <Threads threads={others} />
        </>
      )}
    </span>
  );
}

/** A parked test or value. */
function Loose({ node }: { node: LayoutNode }) {
  const { vertex: id, block, w, h } = node;
  if (block === null) return null;
  return (
    <div className="loose flex" data-testid={`vertex-${id}`} style={{ width: w, height: h }}>
      <ChipView chip={chipOf(block)} vertex={id} />
      <NoteStrip node={node} />
      <Trouble id={id} />
    </div>
  );
}

/** The dashed place on the only arc of a new program, and in an empty body. */
function FirstPlace({ node: { id, colour, w, h } }: { node: LayoutNode }) {
  const isFirst = id === "place";
  const fingers = hasCoarsePointer();
  const first = fingers ? "graph.tap-here" : "graph.drop-here";
  const aimed = useDrag((state) => state.target?.key === `arc:${isFirst ? "start.next" : id}`);
  return (
    <button
      type="button"
      className={`row muted justify-centre first-place${aimed ? " is-aimed" : ""}`}
      data-testid={isFirst ? "first-place" : `place-${id}`}
      data-colour={isFirst ? undefined : colour}
      tabIndex={isFirst ? 0 : -1}
      style={{ width: w, height: h }}
      onClick={(event) => {
        event.stopPropagation();
        if (!isFirst) useView.getState().selectArc(id);
        useView.getState().setAdding({ vertex: null, slot: null });
      }}
    >
      <Icon name="plus" size={16} />
      <strong>{t(isFirst ? first : colour === "loop" ? "graph.drop-repeats" : "graph.drop-inside")}</strong>
      {fingers ? null : (
        <>
          <span>{t("graph.or-press")}</span>
          <kbd>/</kbd>
        </>
      )}
    </button>
  );
}

/**
 * The vertices on which the threads stand that a parallel waits for. A branch with a mark in it is abandoned when the
 * others have ended, so it is not waited for, unless all branches are such. What runs inside a parallel further in has
 * threads of its own; for that one, only its own vertex counts.
 */
export function waitedVertices(parallel: Block): string[] {
  const branches = parallel.bodies.map((body) => body.chain.flatMap(standing));
  const firm = branches.filter((blocks) => !blocks.some(({ shape }) => isMark(shape)));
  return (firm.length > 0 ? firm : branches).flat().map(({ vertex }) => vertex.id);
}

function standing(block: Block): Block[] {
  const plugged = block.plugs.flatMap((plug) => (plug.block === null ? [] : standing(plug.block)));
  const parallel = block.shape.flows.some((flow) => flow.repeat);
  const inside = parallel ? [] : block.bodies.flatMap((body) => body.chain.flatMap(standing));
  return [block, ...plugged, ...inside];
}
