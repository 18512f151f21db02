/**
 * A graph cut into parts that fit on pages: between vertices, not through them, wherever that is possible.
 *
 * Measures are px of the layout. A part is a layout of its own that holds what touches its stretch of the whole.
 */
import { type Layout, NOTE } from "../../../model/layout";

interface Stretch {
  from: number;
  to: number;
}

interface Area {
  x: number;
  y: number;
  w: number;
  h: number;
}

/** Parts this much shorter than a page are still well filled. */
const LEAST_FILLED = 0.5;
/** Room that must stay between a cut and a vertex. */
const GAP = 6;

/**
 * Where to cut the stretch `from`…`to`: its parts in order, each at most `room(index)` long.
 *
 * @param solid what should not be cut through.
 */
export function cuts(from: number, to: number, room: (index: number) => number, solid: readonly Stretch[]): Stretch[] {
  const parts: Stretch[] = [];
  let start = from;
  while (to - start > room(parts.length)) {
    const most = start + room(parts.length);
    const least = start + (most - start) * LEAST_FILLED;
    const end = lastFree(least, most, solid) ?? most;
    parts.push({ from: start, to: end });
    start = end;
  }
  return [...parts, { from: start, to }];
}

/** The last place of a stretch that nothing solid covers. */
function lastFree(least: number, most: number, solid: readonly Stretch[]): number | null {
  let at = most;
  const near = solid.filter((one) => one.to + GAP > least && one.from - GAP < most).sort((a, b) => b.to - a.to);
  for (let again = true; again;) {
    again = false;
    for (const one of near) {
      if (one.from - GAP < at && one.to + GAP > at) {
        at = one.from - GAP;
        again = true;
      }
    }
  }
  return at >= least ? at : null;
}

export interface Paper {
  /** Room on a page in px of CSS. */
  width: number;
  height: number;
  /** What the heading takes of the first one. */
  heading: number;
  /** The largest and the smallest that a graph is drawn. */
  largest: number;
  smallest: number;
}

export interface Part {
  layout: Layout;
  /** Width on paper in px of CSS. */
  width: number;
}

/** So that what fits exactly is not cut. */
const ROUNDING = 0.01;
/** Rather a little smaller than on two pages. */
const WORTH_ONE_PAGE = 0.8;

/** The parts of a graph, from top to bottom, then from left to right; `margin` is what a drawing adds around. */
export function partsOf(layout: Layout, paper: Paper, margin: number): Part[] {
  const { x, y, w, h } = layout.bounds;
  const [wide, tall] = [w + 2 * margin, h + 2 * margin];
  let scale = Math.max(paper.smallest, Math.min(paper.largest, paper.width / wide));
  const whole = (paper.height - paper.heading) / tall;
  if (whole < scale && whole >= Math.max(paper.smallest, scale * WORTH_ONE_PAGE)) scale = whole;
  const boxes = layout.nodes.map((node) => {
    const above = node.note === "" ? 0 : NOTE;
    return { kind: node.kind, x: node.x, y: node.y - above, w: node.w, h: node.h + above };
  });
  // A bar reaches over all its branches, and is cut between two of them.
  const standing = boxes.filter(({ kind }) => kind !== "bar" && kind !== "barEnd");
  const across = cuts(
    x - margin,
    x + w + margin,
    () => paper.width / scale + ROUNDING,
    standing.map((box) => ({ from: box.x, to: box.x + box.w })),
  );
  return across.flatMap((column, index) =>
    cuts(
      y - margin,
      y + h + margin,
      (part) => (paper.height - (index + part === 0 ? paper.heading : 0)) / scale + ROUNDING,
      boxes.map((box) => ({ from: box.y, to: box.y + box.h })),
    ).map((row) => {
      const seen = { x: column.from, y: row.from, w: column.to - column.from, h: row.to - row.from };
      return { layout: within(layout, seen, margin), width: seen.w * scale };
    }),
  );
}

/** The paper on which all of a graph is largest, and its width there in px of CSS. */
export function wholePage(
  { bounds }: Pick<Layout, "bounds">,
  papers: readonly Paper[],
  margin: number,
): { paper: Paper; width: number } {
  const [wide, tall] = [bounds.w + 2 * margin, bounds.h + 2 * margin];
  const all = papers.map((paper) => ({
    paper,
    width: wide * Math.min(paper.largest, paper.width / wide, (paper.height - paper.heading) / tall),
  }));
  return all.reduce((best, one) => (one.width > best.width ? one : best));
}

/** What is seen of a layout in an area; a drawing puts its margin around the bounds again. */
function within(layout: Layout, seen: Area, margin: number): Layout {
  const bounds = { x: seen.x + margin, y: seen.y + margin, w: seen.w - 2 * margin, h: seen.h - 2 * margin };
  const meets = (box: Area) =>
    box.x <= seen.x + seen.w && box.x + box.w >= seen.x && box.y <= seen.y + seen.h && box.y + box.h >= seen.y;
  const along = ({ points }: { points: readonly { x: number; y: number }[] }) => {
    const [xs, ys] = [points.map((point) => point.x), points.map((point) => point.y)];
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    return meets({ x: left - LABEL, y: top, w: Math.max(...xs) - left + 2 * LABEL, h: Math.max(...ys) - top });
  };
  return {
    ...layout,
    bounds,
    nodes: layout.nodes.filter((node) => meets({ ...node, y: node.y - STRIP, h: node.h + STRIP })),
    frames: layout.frames.filter(meets),
    lanes: layout.lanes.filter(meets),
    arcs: layout.arcs.filter(along),
    leaps: layout.leaps.filter(along),
  };
}

/** Room beside a line for its words, and above a vertex for its note. */
const [LABEL, STRIP] = [120, 40];
