/** The line between two panels: dragged, moved with the arrow keys, put back with a double click. */
import { type KeyboardEvent, type PointerEvent, useRef } from "react";

import { mirrored } from "../i18n/language";
import { type Edge, LEAST, MOST, useLayout, USUAL } from "../session/layout";

interface SeparatorProps {
  edge: Edge;
  label: string;
  /** "x": a line that stands upright and moves sideways. */
  along: "x" | "y";
  /** -1 where the panel lies after the line or below it. */
  sense?: 1 | -1;
}

export function Separator({ edge, label, along, sense: given = 1 }: SeparatorProps) {
  const sense = along === "x" && mirrored() ? -given : given;
  const kept = useLayout((layout) => layout.sizes[edge]);
  const resize = useLayout((layout) => layout.resize);
  const grip = useRef<{ at: number; size: number } | null>(null);

  // The inspector has no size of its own until it is given one: then that of its content counts.
  const sizeOf = (line: HTMLElement) =>
    kept || Math.round(line.previousElementSibling?.getBoundingClientRect().height ?? 0);
  const place = (event: PointerEvent) => (along === "x" ? event.clientX : event.clientY);
  const onPointerDown = (event: PointerEvent<HTMLDivElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    grip.current = { at: place(event), size: sizeOf(event.currentTarget) };
  };
  const onPointerMove = (event: PointerEvent) => {
    if (grip.current !== null) resize(edge, grip.current.size + sense * (place(event) - grip.current.at));
  };
  const letGo = () => {
    grip.current = null;
  };
  const onKeyDown = (event: KeyboardEvent<HTMLElement>) => {
    const size = sizeOf(event.currentTarget);
    const [less, more] = along === "x" ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
    const step = event.shiftKey ? 64 : 16;
    if (event.key === less) resize(edge, size - sense * step);
    else if (event.key === more) resize(edge, size + sense * step);
    else if (event.key === "Home") resize(edge, LEAST[edge]);
    else if (event.key === "End") resize(edge, MOST[edge]);
    else return;
    event.preventDefault();
  };
  return (
    <div
      className={`separator rigid relative separator-${along}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={along === "x" ? "vertical" : "horizontal"}
      aria-valuenow={Math.max(kept, LEAST[edge])}
      aria-valuemin={LEAST[edge]}
      aria-valuemax={MOST[edge]}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onKeyDown={onKeyDown}
      onDoubleClick={() => resize(edge, USUAL[edge])}
    />
  );
}
