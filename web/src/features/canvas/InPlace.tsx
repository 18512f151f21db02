/** The field of a vertex, open under it: by a double click on a value, or by typing a digit. */
import "./in-place.css";

import { useEffect, useLayoutEffect, useRef, useState } from "react";

import { FieldRow } from "../../components/fields/FieldRow";
import { t } from "../../i18n/words";
import type { Field } from "../../model/parts";
import type { Block } from "../../model/structure";
import { useStudio } from "../../model/studio";
import { findSpot } from "../../model/tree";
import { type Drawing, nodeOf } from "../../session/drawing";
import { closeField, useView } from "../../session/view";

const GAP = 10;
const EDGE = 8;

interface InPlaceProps {
  drawing: Drawing;
  vertex: string;
  slot: string;
  typed: string;
}

/** The field of a slot of the block, of what fills it, or the first one there is; null where nothing is typed. */
export function fieldAt(block: Block, slot: string): { block: Block; field: Field } | null {
  const filler = block.plugs.find((plug) => plug.slot === slot)?.block;
  if (filler != null) return fieldAt(filler, "");
  const isFilled = (field: Field) => block.plugs.some((plug) => plug.slot === field.name && plug.block !== null);
  const field = block.shape.fields.find((one) => !isFilled(one) && (slot === "" || one.name === slot));
  if (field !== undefined) return { block, field };
  for (const plug of slot === "" ? block.plugs : []) {
    const inner = plug.block === null ? null : fieldAt(plug.block, "");
    if (inner !== null) return inner;
  }
  return null;
}

export function InPlace({ drawing, vertex, slot, typed }: InPlaceProps) {
  const spot = findSpot(drawing.structure, vertex);
  const found = spot === undefined ? null : fieldAt(spot.block, slot);
  const node = nodeOf(drawing, vertex);
  const box = useRef<HTMLDivElement>(null);
  const [at] = useState(() => {
    const { viewport } = useView.getState();
    if (node === undefined || viewport === null) return { x: 0, top: 0, bottom: 0 };
    const { x, y } = viewport.place({ x: node.x + node.w / 2, y: node.y });
    return { x, top: y, bottom: viewport.place({ x: node.x, y: node.y + node.h }).y };
  });
  // Under the vertex; above it where there is more room.
  useLayoutEffect(() => {
    const element = box.current;
    const room = element?.offsetParent?.clientHeight ?? 0;
    if (element === null || room === 0) return;
    const high = element.offsetHeight;
    const below = at.bottom + GAP;
    const above = at.top - GAP - high;
    const inside = Math.max(EDGE, Math.min(below, room - high - EDGE));
    element.style.top = `${String(below + high <= room - EDGE || above < EDGE ? inside : above)}px`;
  });
  const none = found === null;
  useEffect(() => {
    if (none) closeField();
    else useStudio.getState().select([vertex]);
  }, [none, vertex]);
  if (found === null) return null;
  const close = () => {
    closeField();
    useView.getState().viewport?.focus();
  };
  return (
    <div
      ref={box}
      className="in-place surface scroll"
      data-testid="in-place"
      role="group"
      aria-label={t("fields.of", { name: node?.face.name ?? "" })}
      style={{ "--x": `${String(at.x)}px` } as React.CSSProperties}
      onBlur={(event) => {
        // Another window or a button of its own may take the focus; another place of the page ends it.
        if (event.relatedTarget !== null && !event.currentTarget.contains(event.relatedTarget)) closeField();
      }}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        close();
      }}
    >
      <FieldRow drawing={drawing} vertex={found.block.vertex} field={found.field} typed={typed} done={close} />
      <p className="in-place-keys muted tiny-text">{t("fields.keys")}</p>
    </div>
  );
}
