/**
 * The graph of a program as one SVG that stands alone: the layout of the canvas, colours written out, text as text.
 *
 * Colours are those of `ink.ts`. Where the page runs from right to left, so does what stands in a vertex; the flow is the same.
 */
import { headPath, LANE, type Layout, type LayoutLane, roundedPath } from "../../model/layout";
import { textWidth } from "../../model/measure";
import { token } from "./ink";
import { NodeDrawing, NoteDrawing } from "./NodeDrawing";
import { fitting, Text } from "./text-drawing";

const FONT = "'Inter Variable', Inter, system-ui, sans-serif";
/** What a drawing has around the graph, in px. */
export const MARGIN = 32;
/** The head of a lane with who acts in it, and the line on its left, but for that of the first one. */
function LaneDrawing({ lane: { x, y, w, h, names, first } }: { lane: LayoutLane }) {
  const words = fitting(names.join(", "), w - 24, 14, true);
  const width = textWidth(words, 14, true);
  return (
    <>
      <rect x={x} y={y} width={w} height={LANE} fill={token("team-tint")} />
      {first ? null : (
        <path d={`M${String(x)} ${String(y)}v${String(h)}`} stroke={token("team-field")} strokeDasharray="2 5" />
      )}
      <Text x={x + (w - width) / 2} y={y + LANE / 2} size={14} bold colour="team-word">
        {words}
      </Text>
    </>
  );
}

/** `inside` is the text that the drawing carries: the whole mission. */
export function GraphDrawing({ layout, title, inside }: { layout: Layout; title: string; inside: string }) {
  const [x, y] = [Math.floor(layout.bounds.x) - MARGIN, Math.floor(layout.bounds.y) - MARGIN];
  const [w, h] = [Math.ceil(layout.bounds.w) + 2 * MARGIN, Math.ceil(layout.bounds.h) + 2 * MARGIN];
  const word = (colour: string) => token(colour === "flow" ? "muted" : `${colour}-word`);
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      width={w}
      height={h}
      viewBox={[x, y, w, h].join(" ")}
      fontFamily={FONT}
      direction="ltr"
      xmlSpace="preserve"
    >
      <title>{title}</title>
      <metadata id="kitrobot-mission">{inside}</metadata>
      <rect x={x} y={y} width={w} height={h} fill={token("canvas")} />
      {layout.frames.map((frame) => (
        <rect
          key={`${frame.kind} ${frame.id}`}
          x={frame.x}
          y={frame.y}
          width={frame.w}
          height={frame.h}
          rx={frame.kind === "parallel" ? 0 : 8}
          fill={frame.kind === "parked" ? "none" : token(`frame-${frame.colour}`) || token("panel")}
          stroke={frame.kind === "legend" || frame.kind === "parked" ? token("line2") : "none"}
        />
      ))}
      {layout.lanes.map((lane) => (
        <LaneDrawing key={lane.id} lane={lane} />
      ))}
      {layout.nodes.map((node) => (
        <g key={node.id}>
          <NoteDrawing node={node} />
          <NodeDrawing node={node} />
        </g>
      ))}
      {layout.leaps.map(({ source, points, colour, label }) => (
        <g key={source}>
          <path d={roundedPath(points, true)} fill="none" stroke={token(`${colour}-line`)} strokeWidth={2} />
          <path d={headPath(points)} fill={token(`${colour}-line`)} />
          <text x={label.x} y={label.y + 5} fontSize={14} textAnchor={label.anchor} fill={word(colour)}>
            {label.text}
          </text>
        </g>
      ))}
      {layout.arcs.map((arc, index) => {
        const colour = token(arc.colour === "flow" ? "flow" : `${arc.colour}-line`);
        return (
          <g key={index}>
            <path
              d={roundedPath(arc.points, arc.head)}
              fill="none"
              stroke={colour}
              strokeWidth={2}
              {...(arc.missing || arc.dead ? { strokeDasharray: arc.dead ? "2 5" : "3 4" } : {})}
            />
            {arc.head ? <path d={headPath(arc.points)} fill={colour} /> : null}
            {arc.label === null ? null : (
              <text
                x={arc.label.x}
                y={arc.label.y + 5}
                fontSize={14}
                textAnchor={arc.label.anchor}
                fill={word(arc.colour)}
              >
                {arc.label.text}
              </text>
            )}
          </g>
        );
      })}
    </svg>
  );
}
