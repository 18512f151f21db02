import { expect, test } from "vitest";

import type { PenMark } from "../../session/pen-marks";
import { recordingBrush } from "../../testing/recording-pen";
import { fitBox } from "./camera";
import { drawStrokes, strokesOf } from "./pen-strokes";

const ROOM = { width: 400, height: 300 };
/** Two px a mm; the world's origin lies at the lower left corner. */
const CAMERA = fitBox({ left: 0, right: 200, bottom: 0, top: 150 }, ROOM, 0);

function drawn(marks: readonly PenMark[], at: readonly [number, number] | undefined) {
  const { brush, asked } = recordingBrush(CAMERA, ROOM);
  drawStrokes(
    brush,
    strokesOf(marks, () => at),
  );
  return asked.map(({ what, colour, width, path }) => ({ what, colour, width, path }));
}

test("a line is drawn along its marks in the colour and the width of the pen, to where the pen is now", () => {
  const marks: PenMark[] = [
    [0, 2, 100, 100, 3, 4],
    [0, 1, 1100, 100, 3, 4],
  ];
  const path = [
    ["lineTo", 20, 280],
    ["lineTo", 220, 280],
    ["lineTo", 220, 180],
  ];
  expect(drawn(marks, [110, 60])).toEqual([{ what: "stroke", colour: "#1d6ad4", width: 8, path }]);
});

test("each line has its own colour, black is the theme's ink, and none is thinner than three px", () => {
  const marks: PenMark[] = [
    [0, 2, 0, 0, 1, 10],
    [1, 2, 0, 500, 0, 1],
    [0, 4, 500, 0, 1, 10],
    [1, 4, 500, 500, 0, 1],
  ];
  expect(drawn(marks, undefined).map(({ colour, width }) => [colour, width])).toEqual([
    ["#d3202f", 20],
    ["ink", 3],
  ]);
});

test("a pen that was only set down has drawn a dot", () => {
  const marks: PenMark[] = [[0, 2, 500, 500, 2, 3]];
  const dot = ["lineTo", 100, 200];
  expect(drawn(marks, undefined)[0]?.path).toEqual([dot, dot]);
});
