/**
 * The graph of a program as one SVG that stands alone: the layout of the canvas, colours written out, text as text.
 *
 * Colours are those of `ink.ts`. Letters are squeezed or stretched to the width that the layout counted with, so
 * that nothing leaves its box where Inter is not installed. Where the page runs from right to left, so does what stands in
 * a vertex, as on the canvas; the flow is the same.
 */
import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { headPath, LANE, type Layout, type LayoutLane, type LayoutNode, NOTE, roundedPath } from "../../model/layout";
import { textWidth } from "../../model/measure";
import { lightsPath } from "../../model/meaning";
import type { Choice } from "../../model/types";
import { type Box, boxWidth, type Chip, chipWidth, chipOf, type Face, PICTURE } from "../../model/vertex-content";
import { Icon } from "../../theme";
import { token } from "./ink";

const FONT = "'Inter Variable', Inter, system-ui, sans-serif";
/** What a drawing has around the graph, in px. */
export const MARGIN = 32;
const TILE = 28;
/** The font whose widths the layout has measured. */
const KNOWN = /^[\x20-\x7e]*$/;
/** Letters of scripts that run from right to left, and lines that begin with one. */
const RIGHT_TO_LEFT = /[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc]/;
const BEGINS_RIGHT_TO_LEFT = /^\P{L}*[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc]/u;

interface TextProps {
  /** The left side of the room that the layout gave it. */
  x: number;
  y: number;
  size: number;
  bold?: boolean;
  colour: string;
  children: string;
}

function Text({ x, y, size, bold = false, colour, children }: TextProps) {
  const width = textWidth(children, size, bold);
  const runsLeft = RIGHT_TO_LEFT.test(children) && (mirrored() || BEGINS_RIGHT_TO_LEFT.test(children));
  return (
    <text
      x={mirrored() ? x + width : x}
      y={y + size * 0.36}
      fontSize={size}
      fontWeight={bold ? 600 : 400}
      direction={runsLeft ? "rtl" : "ltr"}
      textAnchor={runsLeft === mirrored() ? "start" : "end"}
      fill={token(colour)}
      {...(KNOWN.test(children) && width > 0
        ? { textLength: width, lengthAdjust: "spacingAndGlyphs" }
        : { "data-room": width })}
    >
      {children}
    </text>
  );
}

/** Places inside of what reaches from `x` over `w`, turned around where the page is. */
function turned(x: number, w: number) {
  const rtl = mirrored();
  return {
    /** The left side of something that is `width` wide and would begin at `left`. */
    box: (left: number, width: number) => (rtl ? 2 * x + w - left - width : left),
    /** The same for a line of text. */
    text: (left: number, words: string, size: number, bold = false) => {
      return rtl ? 2 * x + w - left - textWidth(words, size, bold) : left;
    },
  };
}

/** Where things of these widths begin, one after the other. */
function places(start: number, widths: readonly number[], gap: number): number[] {
  return widths.map((_, index) => widths.slice(0, index).reduce((sum, width) => sum + width + gap, start));
}

function Sign({ name, x, y, size, colour }: { name: string; x: number; y: number; size: number; colour: string }) {
  return (
    <g transform={`translate(${String(x)} ${String(y - size / 2)})`} color={token(colour)}>
      <Icon name={name} size={size} />
    </g>
  );
}

function ChipDrawing({ chip, x, y }: { chip: Chip; x: number; y: number }) {
  const width = chipWidth(chip);
  let words = chip.pieces.map((piece) => (piece.kind === "words" ? piece.words : piece.label)).join(" ");
  let left = x + 8;
  if (chip.icon !== "") left += 21;
  while (words.length > 1 && left + textWidth(words, 14, true) > x + width) words = `${words.slice(0, -2)}…`;
  const at = turned(x, width);
  return (
    <>
      <rect x={x} y={y - 14} width={width} height={28} rx={6} fill={token("test-tint")} stroke={token("test-field")} />
      {chip.icon === "" ? null : <Sign name={chip.icon} x={at.box(x + 8, 15)} y={y} size={15} colour="test-word" />}
      <Text x={at.text(left, words, 14, true)} y={y} size={14} bold colour="test-word">
        {words}
      </Text>
    </>
  );
}

/** Stands for the picture among the words of a box. */
const PICTURE_PLACE = "\uFFFC";

function PictureDrawing({ choice, x, y, own }: { choice: Choice | null; x: number; y: number; own: string }) {
  if (choice === null) return null;
  const { icon, lights, colour } = choice;
  if (icon) return <Sign name={icon} x={x} y={y} size={PICTURE} colour={`${own}-word`} />;
  return (
    <g transform={`translate(${String(x)} ${String(y - PICTURE / 2)}) scale(${String(PICTURE / 5)})`}>
      {colour ? <rect width="4.8" height="4.8" rx=".8" fill={colour} /> : null}
      <path d={lightsPath(lights ?? "")} fill={token(`${own}-word`)} />
    </g>
  );
}

function BoxDrawing({ box, x, y, colour }: { box: Box; x: number; y: number; colour: string }) {
  const own = box.plugged === null ? colour : "test";
  const all: [string, boolean][] = [
    [box.label, false],
    [box.picture === null ? "" : PICTURE_PLACE, true],
    [box.value === "" ? "…" : box.value, true],
  ];
  const parts = all.filter(([words]) => words !== "");
  const widths = parts.map(([words, bold]) => (words === PICTURE_PLACE ? PICTURE : textWidth(words, 14, bold)));
  const lefts = places(x + 9, widths, 4);
  // Latin words and numbers keep their order among themselves.
  const at = parts.some(([words]) => RIGHT_TO_LEFT.test(words)) ? turned(x, boxWidth(box)) : null;
  return (
    <>
      <rect
        x={x}
        y={y - 14}
        width={boxWidth(box)}
        height={28}
        rx={6}
        fill={token(box.plugged === null ? "field" : "test-tint")}
        stroke={token(`${own}-field`)}
      />
      {parts.map(([words, bold], index) => {
        const left = lefts[index] ?? 0;
        if (words === PICTURE_PLACE)
          return (
            <PictureDrawing
              key={index}
              choice={box.picture}
              x={at === null ? left : at.box(left, PICTURE)}
              y={y}
              own={own}
            />
          );
        return (
          <Text
            key={index}
            x={at === null ? left : at.text(left, words, 14, bold)}
            y={y}
            size={14}
            bold={bold}
            colour={bold ? `${own}-word` : "muted"}
          >
            {words}
          </Text>
        );
      })}
    </>
  );
}

function outline(x: number, y: number, w: number, h: number): string {
  return [
    [x, y + h / 2],
    [x + 14, y],
    [x + w - 14, y],
    [x + w, y + h / 2],
    [x + w - 14, y + h],
    [x + 14, y + h],
  ]
    .map((at) => at.join(","))
    .join(" ");
}

/** The places of an object's name and of what it does, which follow each other from `left`. */
function names({ object, name }: Face, left: number, at: ReturnType<typeof turned>): [number, number] {
  const gap = object === "" ? 0 : textWidth(object, 15) + 5;
  if (RIGHT_TO_LEFT.test(object + name)) return [at.text(left, object, 15), at.text(left + gap, name, 15, true)];
  const begin = at.box(left, gap + textWidth(name, 15, true));
  return [begin, begin + gap];
}

function VertexDrawing({ node }: { node: LayoutNode }) {
  const { x, y, w, h, kind, colour, face, block } = node;
  const hexagon = kind === "hexagon";
  const middle = y + h / 2;
  const line = { fill: token(`${colour}-tint`), stroke: token(`${colour}-line`), strokeWidth: 1.6 };
  const tile = x + (hexagon ? 16 : 8);
  const name = tile + TILE + 10 + (face.object === "" ? 0 : textWidth(face.object, 15) + 5);
  const chips = places(name + textWidth(face.name, 15, true) + 10, face.chips.map(chipWidth), 6);
  const widths = face.boxes.map(boxWidth);
  const all = widths.reduce((sum, width) => sum + width + 6, -6);
  const boxes = places(x + w - (hexagon ? 22 : 8) - all, widths, 6);
  const at = turned(x, w);
  const [first, second] = names(face, tile + TILE + 10, at);
  return (
    <>
      {hexagon ? (
        <polygon points={outline(x, y, w, h)} strokeLinejoin="round" {...line} />
      ) : (
        <rect x={x} y={y} width={w} height={h} rx={6} {...line} />
      )}
      <rect
        x={at.box(tile, TILE)}
        y={middle - TILE / 2}
        width={TILE}
        height={TILE}
        rx={6}
        fill={token(`${colour}-tile`)}
      />
      <Sign
        name={block?.shape.icon ?? ""}
        x={at.box(tile + 5.5, 17)}
        y={middle}
        size={17}
        colour={`${colour}-on-tile`}
      />
      {face.object === "" ? null : (
        <Text x={first} y={middle} size={15} colour="muted">
          {face.object}
        </Text>
      )}
      <Text x={second} y={middle} size={15} bold colour="text">
        {face.name}
      </Text>
      {face.chips.map((chip, index) => (
        <ChipDrawing key={chip.slot} chip={chip} x={at.box(chips[index] ?? 0, chipWidth(chip))} y={middle} />
      ))}
      {face.boxes.map((box, index) => (
        <BoxDrawing key={box.slot} box={box} x={at.box(boxes[index] ?? 0, boxWidth(box))} y={middle} colour={colour} />
      ))}
      {node.mark === null ? null : (
        <g transform={`translate(${String(at.box(x + w - 4, 0))} ${String(y + 2)})`}>
          <circle r={12} fill={token(`${node.mark.shape.colour}-tile`)} stroke={token("canvas")} strokeWidth={2} />
          <circle r={4.5} fill="none" stroke={token(`${node.mark.shape.colour}-on-tile`)} strokeWidth={2.75} />
        </g>
      )}
    </>
  );
}

function TerminalDrawing({ node: { x, y, w, h, kind } }: { node: LayoutNode }) {
  const name = t(kind === "start" ? "graph.start" : "graph.stop");
  const left = x + (w - textWidth(name, 15, true) - 22) / 2;
  const at = turned(x, w);
  const sign = kind === "start" ? "M2 1.2v9.6L10.5 6Z" : "M1 1h10v10H1Z";
  return (
    <>
      <rect x={x} y={y} width={w} height={h} rx={h / 2} fill={token("panel")} stroke={token("ink")} strokeWidth={2} />
      <path
        d={sign}
        transform={`translate(${String(at.box(left, 12))} ${String(y + h / 2 - 6)})`}
        fill={token("ink")}
      />
      <Text x={at.text(left + 22, name, 15, true)} y={y + h / 2} size={15} bold colour="text">
        {name}
      </Text>
    </>
  );
}

function BarDrawing({ node: { x, y, w, h, kind, colour, face, block } }: { node: LayoutNode }) {
  return (
    <>
      <rect x={x} y={y + 10} width={w} height={Math.max(4, h - 20)} rx={4} fill={token(`${colour}-line`)} />
      {kind === "bar" ? <Tag face={face} icon={block?.shape.icon ?? ""} colour={colour} x={x + 8} y={y + 14} /> : null}
    </>
  );
}

function Tag({ face, icon, colour, x, y }: { face: Face; icon: string; colour: string; x: number; y: number }) {
  const width = textWidth(face.name, 14, true) + 46;
  const at = turned(x, width);
  return (
    <>
      <rect x={x} y={y - 14} width={width} height={28} rx={14} fill={token(`${colour}-tile`)} />
      <Sign name={icon} x={at.box(x + 10, 16)} y={y} size={16} colour={`${colour}-on-tile`} />
      <Text x={at.text(x + 34, face.name, 14, true)} y={y} size={14} bold colour={`${colour}-on-tile`}>
        {face.name}
      </Text>
    </>
  );
}

/** The first line of the note above a vertex. */
function NoteDrawing({ node: { x, y, w, h, kind, note, noteWidth } }: { node: LayoutNode }) {
  if (note === "") return null;
  const left = x + (w - noteWidth) / 2;
  const bottom = kind === "bar" ? y + h / 2 - 4 : y;
  let [words = ""] = note.split("\n");
  while (words.length > 1 && textWidth(words, 13) > noteWidth - 20) words = `${words.slice(0, -2)}…`;
  return (
    <>
      <rect x={left} y={bottom - NOTE} width={noteWidth} height={NOTE} fill={token("panel")} stroke={token("line2")} />
      <Text x={turned(left, noteWidth).text(left + 10, words, 13)} y={bottom - NOTE / 2} size={13} colour="muted">
        {words}
      </Text>
    </>
  );
}

function NodeDrawing({ node }: { node: LayoutNode }) {
  if (node.kind === "start" || node.kind === "stop") return <TerminalDrawing node={node} />;
  if (node.kind === "bar" || node.kind === "barEnd") return <BarDrawing node={node} />;
  if (node.kind === "place" && node.id !== "place") {
    const { x, y, w, h, colour } = node;
    return (
      <rect
        x={x}
        y={y}
        width={w}
        height={h}
        rx={8}
        fill="none"
        stroke={token(`${colour}-line`)}
        strokeDasharray="5 4"
      />
    );
  }
  if (node.block === null) return null;
  if (node.kind === "chip") return <ChipDrawing chip={chipOf(node.block)} x={node.x} y={node.y + node.h / 2} />;
  return <VertexDrawing node={node} />;
}

/** The head of a lane with who acts in it, and the line on its left, but for that of the first one. */
function LaneDrawing({ lane: { x, y, w, h, names, first } }: { lane: LayoutLane }) {
  let words = names.join(", ");
  while (words.length > 1 && textWidth(words, 14, true) > w - 24) words = `${words.slice(0, -2)}…`;
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
