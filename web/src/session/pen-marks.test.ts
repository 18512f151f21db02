import { describe, expect, it } from "vitest";

import { strokesOf } from "../components/scene/pen-strokes";
import { drawnAfter, type PenMark } from "./pen-marks";

const begun: PenMark = [0, 2, 0, 0, 1, 3];
const corner: PenMark = [0, 1, 1000, 0, 1, 3];
const ended: PenMark = [0, 4, 1000, 500, 1, 3];

describe("what pens drew", () => {
  const tick = (keep: number, marks: PenMark[]) => ({ type: "tick", drawing: { keep, marks } }) as never;
  it("grows at its end, and is cut when the run goes back", () => {
    const start = { marks: [], pens: [0] };
    const one = drawnAfter(start, tick(0, [begun, corner]));
    expect(drawnAfter(one, { type: "tick", drawing: null } as never)).toBe(one);
    const two = drawnAfter(one, tick(2, [ended]));
    expect(two.marks).toEqual([begun, corner, ended]);
    expect(drawnAfter(two, tick(1, [])).marks).toEqual([begun]);
  });
  it("is lines in mm, and a pen that is down has drawn as far as its robot is", () => {
    expect(strokesOf([begun, corner, ended], () => [7, 7])).toEqual([
      {
        colour: 1,
        width_mm: 3,
        points: [
          [0, 0],
          [100, 0],
          [100, 50],
        ],
      },
    ]);
    expect(strokesOf([begun, corner], () => [100, 20])[0]?.points.at(-1)).toEqual([100, 20]);
    expect(strokesOf([corner], () => undefined)).toEqual([]);
  });
});
