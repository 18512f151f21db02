/** One vertex in the drawing of a graph: its box, sign, words, conditions and fields, and the note above it. */
import { t } from "../../i18n/words";
import { hexagonPoints, type LayoutNode, NOTE } from "../../model/layout";
import { textWidth } from "../../model/measure";
import { lightsPath } from "../../model/meaning";
import type { Choice } from "../../model/types";
import { type Box, boxWidth, type Chip, chipWidth, chipOf, type Face, PICTURE } from "../../model/vertex-content";
import { token } from "./ink";
import { fitting, places, RIGHT_TO_LEFT, Sign, Text, turned } from "./text-drawing";

const TILE = 28;

function ChipDrawing({ chip, x, y }: { chip: Chip; x: number; y: number }) {
  const width = chipWidth(chip);
  const whole = chip.pieces.map((piece) => (piece.kind === "words" ? piece.words : piece.label)).join(" ");
  const left = x + (chip.icon === "" ? 8 : 29);
  const words = fitting(whole, x + width - left, 14, true);
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
        <polygon points={hexagonPoints(node)} strokeLinejoin="round" {...line} />
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
export function NoteDrawing({ node: { x, y, w, h, kind, note, noteWidth } }: { node: LayoutNode }) {
  if (note === "") return null;
  const left = x + (w - noteWidth) / 2;
  const bottom = kind === "bar" ? y + h / 2 - 4 : y;
  const words = fitting(note.split("\n")[0] ?? "", noteWidth - 20, 13);
  return (
    <>
      <rect x={left} y={bottom - NOTE} width={noteWidth} height={NOTE} fill={token("panel")} stroke={token("line2")} />
      <Text x={turned(left, noteWidth).text(left + 10, words, 13)} y={bottom - NOTE / 2} size={13} colour="muted">
        {words}
      </Text>
    </>
  );
}

export function NodeDrawing({ node }: { node: LayoutNode }) {
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
