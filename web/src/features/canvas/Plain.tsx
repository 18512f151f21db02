/**
 * Vertices from far away: their shape and colour, nothing in them; what happens to them (selected, active, wrong) stays to be
 * seen. Below `PLAIN_ZOOM` words would be smaller than can be read, and a screen holds many vertices.
 */
import { memo } from "react";

import type { LayoutNode } from "../../model/layout";
import { useStudio } from "../../model/studio";
import { justDragged, useDrag } from "../../session/drag";
import { spoken } from "../../session/spoken";
import { useThreadsAt } from "./active";
import { useCameraState } from "./camera";
import { useTroubled, useTroubles } from "./problem-badges";
import { dragVertices, selectVertex } from "./Vertex";
import "./plain.css";

/** Words of 14 px are less than 6 px high there. */
export const PLAIN_ZOOM = 0.4;

/** Whether the graph is looked at from far away. */
export function usePlain(): boolean {
  return useCameraState((state) => state.zoom < PLAIN_ZOOM);
}

const NOTHING: string[] = [];

export const PlainNode = memo(function PlainNode({ node }: { node: LayoutNode }) {
  const { vertex: id, kind, w, h, colour, block, inside, mark } = node;
  const selected = useStudio((state) => state.selection.includes(id));
  const threads = useThreadsAt(id, mark?.vertex.id ?? null, inside?.vertices);
  const aimed = useDrag((state) => state.target?.key === `vertex:${id}`);
  const lifted = useDrag(
    (state) => state.payload?.kind === "vertices" && !state.copy && state.payload.ids.includes(id),
  );
  const [worst] = useTroubles(useTroubled(id, inside?.vertices ?? NOTHING));
  const terminal = kind === "start" || kind === "stop";
  const end = kind === "barEnd";
  const classes = ["plain", `plain-${kind}`];
  if (selected) classes.push("is-selected");
  if (threads !== "") classes.push("is-active");
  if (aimed) classes.push("is-aimed");
  if (lifted) classes.push("is-lifted");
  if (node.parked) classes.push("is-parked");
  if (block?.shape.kind === "unknown") classes.push("is-unknown");
  if (inside !== null) classes.push("is-folded");
  return (
    <div
      className={classes.join(" ")}
      data-testid={end ? `vertex-${id}-end` : `vertex-${id}`}
      data-colour={terminal ? undefined : colour}
      id={end ? undefined : `vertex-${id}`}
      role="group"
      aria-label={spoken(node)}
      aria-current={selected}
      aria-hidden={end ? true : undefined}
      style={{ width: w, height: h }}
      onPointerDown={(event) => {
        if (!terminal && block !== null) dragVertices(event, id, block.shape.element);
      }}
      onClick={(event) => {
        if (!justDragged()) selectVertex(id, event);
      }}
    >
      <span className="plain-body cover" />
      {worst === undefined ? null : <span className="plain-trouble" data-severity={worst.severity} />}
    </div>
  );
});
