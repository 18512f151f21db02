/** The whole program, small, and what of it is in view; a press or drag goes there. */
import "./minimap.css";

import type { PointerEvent } from "react";

import { t } from "../../i18n/words";
import type { Drawing } from "../../session/drawing";
import { restFollowing } from "../../session/view";
import { useCamera, useCameraState } from "./camera";

const EDGE = 40;

export function Minimap({ layout }: { layout: Drawing["layout"] }) {
  const camera = useCamera();
  const { x, y, zoom, width, height } = useCameraState((state) => state);
  const { bounds } = layout;
  const box = [bounds.x - EDGE, bounds.y - EDGE, bounds.w + 2 * EDGE, bounds.h + 2 * EDGE];

  const go = (event: PointerEvent<SVGSVGElement>) => {
    if ((event.buttons & 1) === 0) return;
    const matrix = event.currentTarget.getScreenCTM();
    if (matrix === null) return;
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    restFollowing();
    camera.jump({ x: width / 2 - point.x * zoom, y: height / 2 - point.y * zoom, zoom });
  };

  return (
    <svg
      className="minimap surface"
      viewBox={box.join(" ")}
      role="img"
      aria-label={t("graph.minimap")}
      data-testid="minimap"
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        go(event);
      }}
      onPointerMove={go}
    >
      {layout.frames.map((frame) => (
        <rect
          key={`${frame.kind} ${frame.id}`}
          className="minimap-frame"
          data-colour={frame.colour}
          x={frame.x}
          y={frame.y}
          width={frame.w}
          height={frame.h}
        />
      ))}
      {layout.nodes.map((node) => (
        <rect
          key={node.id}
          className="minimap-node"
          data-colour={node.block === null ? undefined : node.colour}
          x={node.x}
          y={node.y}
          width={node.w}
          height={node.h}
        />
      ))}
      <rect className="drawn unscaled" x={-x / zoom} y={-y / zoom} width={width / zoom} height={height / zoom} />
    </svg>
  );
}
