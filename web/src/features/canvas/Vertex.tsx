/** A vertex that is a box or a stretched diamond: tile, name, chips for its conditions, boxes for its values. */
import { memo, type PointerEvent } from "react";

import { ChoicePicture } from "../../components/ChoicePicture";
import type { LayoutNode } from "../../model/layout";
import { useStudio } from "../../model/studio";
import { type Box, type Chip, chipWidth, faceWidth, MOST_CHIP, PICTURE } from "../../model/vertex-content";
import { reportError } from "../../session/document";
import { beginDrag, justDragged, useDrag } from "../../session/drag";
import { useRun } from "../../session/run";
import { spoken } from "../../session/spoken";
import { holdingStill, openField, useView } from "../../session/view";
import { Icon, Tile } from "../../theme";
import { later } from "../../ui/later";
import { useThreadsAt } from "./active";
import { Badges } from "./Badges";
import { FoldedWords } from "./Folding";
import { useMoved } from "./drag-contents";

/** Selects on a click; Shift or Ctrl adds to the selection or takes away from it. */
export function selectVertex(id: string, event: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): void {
  const { selection, select } = useStudio.getState();
  const adds = event.shiftKey || event.ctrlKey || event.metaKey;
  const others = selection.filter((one) => one !== id);
  holdingStill(() => {
    select(!adds ? [id] : selection.includes(id) ? others : [...selection, id]);
  });
  useView.getState().viewport?.focus();
}

/** The vertices that a drag of this one takes along: all selected ones, if it is one of them. */
export function dragVertices(event: PointerEvent, id: string, element: string): void {
  const { selection } = useStudio.getState();
  beginDrag(event, { kind: "vertices", ids: selection.includes(id) ? selection : [id], element });
}

const LiveValue = later(() => import("./LiveValue").then((chunk) => chunk.LiveValue), reportError);

export const Vertex = memo(function Vertex({ node }: { node: LayoutNode }) {
  const { vertex: id, face, block, kind, w, h, colour } = node;
  const selected = useStudio((state) => state.selection.includes(id));
  const takes = (slot: string) => block?.shape.plugs.find(({ name }) => name === slot)?.accepts;
  const threads = useThreadsAt(id, node.mark?.vertex.id ?? null, node.inside?.vertices);
  const aimed = useDrag((state) => state.target?.key === `vertex:${id}`);
  const lifted = useDrag(
    (state) => state.payload?.kind === "vertices" && !state.copy && state.payload.ids.includes(id),
  );
  if (block === null) return null;
  const hexagon = kind === "hexagon";
  const spare = node.inside === null ? w - faceWidth(face, hexagon) : 0;
  const classes = ["vertex", kind];
  if (selected) classes.push("is-selected");
  if (threads !== "") classes.push("is-active");
  if (aimed) classes.push("is-aimed");
  if (lifted) classes.push("is-lifted");
  if (block.shape.kind === "unknown") classes.push("is-unknown");
  if (node.inside !== null) classes.push("is-folded");
  if (node.parked) classes.push("is-parked");
  return (
    <div
      className={classes.join(" ")}
      data-testid={`vertex-${id}`}
      data-colour={colour}
      data-threads={threads === "" ? undefined : threads}
      id={`vertex-${id}`}
      role="group"
      aria-label={spoken(node)}
      aria-current={selected}
      style={{ width: w, height: h }}
      onPointerDown={(event) => dragVertices(event, id, block.shape.element)}
      onClick={(event) => {
        if (!justDragged()) selectVertex(id, event);
      }}
      onDoubleClick={({ target }) => {
        openField(
          id,
          target instanceof Element ? (target.closest<HTMLElement>("[data-slot]")?.dataset["slot"] ?? "") : "",
        );
      }}
    >
      <Outline w={w} h={h} hexagon={hexagon} />
      <Tile icon={block.shape.icon} colour={colour} />
      <span className="vertex-name">
        {face.object === "" ? null : <span className="muted">{face.object} </span>}
        <strong>{face.name}</strong>
      </span>
      {face.chips.map((chip) => (
        <ChipView key={chip.slot} chip={chip} vertex={id} />
      ))}
      {face.chips.length === 1 ? <Live node={node} spare={spare} /> : null}
      <span className="grow" />
      {face.boxes.map((box) => (
        <BoxView key={box.slot} box={box} vertex={id} takes={takes(box.slot)} />
      ))}
      <FoldedWords node={node} />
      <Badges node={node} threads={threads} />
    </div>
  );
});

/** The vertex's shape, `grow` px outside of it; tips of 14. */
function outline(w: number, h: number, hexagon: boolean, grow: number): string {
  if (!hexagon) {
    const radius = 6 + Math.max(0, grow) * 0.6;
    const long = w + 2 * grow - 2 * radius;
    const high = h + 2 * grow - 2 * radius;
    const corner = (x: number, y: number) => `a${String(radius)} ${String(radius)} 0 0 1 ${String(x)} ${String(y)}`;
    return `M${String(radius - grow)} ${String(-grow)}h${String(long)}${corner(radius, radius)}v${String(high)}${corner(-radius, radius)}h${String(-long)}${corner(-radius, -radius)}v${String(-high)}${corner(radius, -radius)}Z`;
  }
  const tip = 14 + grow * 0.3;
  const long = w + 2.4 * grow - 2 * tip;
  const half = h / 2 + grow;
  return `M${String(-1.2 * grow)} ${String(h / 2)}l${String(tip)} ${String(-half)}h${String(long)}l${String(tip)} ${String(half)}l${String(-tip)} ${String(half)}h${String(-long)}Z`;
}

function Outline({ w, h, hexagon }: { w: number; h: number; hexagon: boolean }) {
  return (
    <svg className="outline" width={w} height={h} aria-hidden="true">
      <path className="outline-ring" d={outline(w, h, hexagon, 4)} />
      <path className="outline-body" d={outline(w, h, hexagon, -0.8)} />
    </svg>
  );
}

/** A condition slot: what fills it in words, holes for what is missing. */
export function ChipView({ chip, vertex }: { chip: Chip; vertex: string }) {
  const selected = useStudio((state) => chip.filler !== null && state.selection.includes(chip.filler));
  const aimed = useDrag((state) => state.target?.key === `slot:${vertex}.${chip.slot}`);
  const classes = ["chip"];
  if (selected) classes.push("is-selected");
  if (aimed) classes.push("is-aimed");
  if (useMoved(chip.filler ?? vertex)) classes.push("is-own");
  if (chip.filler === null) classes.push("is-empty");
  const words = chip.pieces.map((piece) => (piece.kind === "words" ? piece.words : piece.label)).join(" ");
  return (
    <span
      className={classes.join(" ")}
      id={chip.filler === null ? undefined : `vertex-${chip.filler}`}
      data-testid={`slot-${vertex}.${chip.slot}`}
      data-vertex={vertex}
      data-slot={chip.slot}
      data-takes={chip.accepts}
      role={chip.pieces.length > 1 ? "group" : "button"}
      aria-label={words}
      title={chipWidth(chip) < MOST_CHIP ? undefined : words}
      onPointerDown={(event) => {
        if (chip.filler === null) return;
        event.stopPropagation();
        dragVertices(event, chip.filler, chip.element);
      }}
      onClick={(event) => {
        event.stopPropagation();
        if (justDragged()) return;
        if (chip.filler === null) openSlot(vertex, chip.slot);
        else selectVertex(chip.filler, event);
      }}
    >
      {chip.icon === "" ? null : <Icon name={chip.icon} size={15} />}
      {chip.pieces.map((piece, index) =>
        piece.kind === "words" ? (
          <span className="chip-words slim" key={index}>
            {piece.words}
          </span>
        ) : chip.filler === null ? (
          <span key={index}>{piece.label}</span>
        ) : (
          <Hole key={index} vertex={piece.vertex} slot={piece.slot} label={piece.label} />
        ),
      )}
    </span>
  );
}

/** An empty slot inside a chip. */
function Hole({ vertex, slot, label }: { vertex: string; slot: string; label: string }) {
  const aimed = useDrag((state) => state.target?.key === `slot:${vertex}.${slot}`);
  const own = useMoved(vertex);
  return (
    <span
      className={`hole${aimed ? " is-aimed" : ""}${own ? " is-own" : ""}`}
      data-testid={`slot-${vertex}.${slot}`}
      data-vertex={vertex}
      data-slot={slot}
      data-hole=""
      data-takes="condition"
      role="button"
      onClick={(event) => {
        event.stopPropagation();
        openSlot(vertex, slot);
      }}
    >
      {label}
    </span>
  );
}

/** A click on an empty slot asks what should go there. */
function openSlot(vertex: string, slot: string): void {
  useStudio.getState().select([vertex]);
  useView.getState().setAdding({ vertex, slot: { kind: "slot", vertex, slot } });
}

function BoxView({ box, vertex, takes }: { box: Box; vertex: string; takes: string | undefined }) {
  const aimed = useDrag((state) => state.target?.key === `slot:${vertex}.${box.slot}`);
  const selected = useStudio((state) => box.plugged !== null && state.selection.includes(box.plugged));
  const classes = ["box"];
  if (useMoved(vertex)) classes.push("is-own");
  if (box.plugged !== null) classes.push("is-plugged");
  if (aimed) classes.push("is-aimed");
  if (selected) classes.push("is-selected");
  return (
    <span
      className={classes.join(" ")}
      data-testid={`slot-${vertex}.${box.slot}`}
      data-vertex={vertex}
      data-slot={box.slot}
      data-takes={takes}
      onClick={(event) => {
        if (box.plugged === null || justDragged()) return;
        event.stopPropagation();
        selectVertex(box.plugged, event);
      }}
    >
      {box.label === "" ? null : <span className="muted">{box.label}</span>}
      {box.picture === null ? null : <ChoicePicture choice={box.picture} size={PICTURE} />}
      <strong>{box.value === "" ? "…" : box.value}</strong>
    </span>
  );
}

/** While a run exists, what the sensor of its chip says now. */
function Live({ node, spare }: { node: LayoutNode; spare: number }) {
  const on = useView((state) => state.live);
  const runs = useRun((run) => run.agents.length > 0);
  return on && runs ? <LiveValue node={node} spare={spare} /> : null;
}
