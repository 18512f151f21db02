/**
 * The arcs of a Break: from its right side, on a lane of their own, to the exit of the loop that it leaves.
 *
 * They are not arcs of the graph (a Break has an ordinary `next`, which is drawn as never taken), so nothing can be dropped
 * on them. While a layout is made they are open and travel outwards: straight to the right while nothing stands there,
 * down the gap beside their column and along a row under all columns where something does. A Break never leaves a
 * parallel: without a loop in its branch it ends the branch, without one at all the program.
 */
import { t } from "../../i18n/words";
import type { Shape } from "../parts";
import type { Measured } from "./sizes";
import type { LayoutLeap, Point } from "./types";

/** The height of the row under the columns. */
export const LEAP_ROW = 16;

/** The word of LLL that such a part becomes. */
const WORD = /^\s*BREAK\s*;?\s*$/;

export function leapsOut({ constructor_ }: Shape): boolean {
  return constructor_ !== null && WORD.test(constructor_.code);
}

export class Leaps {
  readonly done: LayoutLeap[] = [];
  private open: LayoutLeap[] = [];

  /** Where the arcs begin that whatever is placed from now on opens. */
  mark(): number {
    return this.open.length;
  }

  /** Whether such an arc is open since that mark. */
  isOpen(mark: number): boolean {
    return this.open.length > mark;
  }

  begin({ shown, width }: Measured, x: number, middle: number): void {
    const from = { x: x + width / 2, y: middle };
    const label = { text: t("graph.leave"), x: from.x + 8, y: middle - 11, anchor: "start" as const };
    this.open.push({ source: shown.vertex.id, points: [from], colour: shown.shape.colour, label });
  }

  /** Straight to the right edge of their loop. */
  endAt(mark: number, x: number): void {
    for (const leap of this.open.splice(mark)) this.finish(leap, { x, y: lastOf(leap).y });
  }

  /** Down the gap at `x` into what is at `y`. */
  endBelow(mark: number, x: number, y: number): void {
    for (const leap of this.open.splice(mark)) {
      leap.points.push({ x, y: lastOf(leap).y });
      this.finish(leap, { x, y });
    }
  }

  /** Past everything at `x`, down, and back to the side of the end. */
  endBeside(mark: number, x: number, end: Point): void {
    for (const leap of this.open.splice(mark)) {
      leap.points.push({ x, y: lastOf(leap).y }, { x, y: end.y });
      this.finish(leap, end);
    }
  }

  /** Down the gap at `x` to the row at `y`; they go on from there. */
  turn(from: number, to: number, x: number, y: number): void {
    for (const leap of this.open.slice(from, to)) leap.points.push({ x, y: lastOf(leap).y }, { x, y });
  }

  /** Those that lead nowhere: a parked chain has no end. */
  forget(mark: number): void {
    this.open = this.open.slice(0, mark);
  }

  private finish(leap: LayoutLeap, point: Point): void {
    leap.points.push(point);
    this.done.push(leap);
  }
}

function lastOf({ points }: LayoutLeap): Point {
  return points.at(-1) ?? { x: 0, y: 0 };
}
