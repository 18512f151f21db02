/** Where the tag beside a robot covers nothing that matters: boxes in px, the first free corner wins. */

export interface Area {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface TagPlace {
  area: Area;
  right: 1 | -1;
  below: 1 | -1;
  /** 0 where it covers nothing and stands where it belongs; more where it does not, in square px. */
  cost: number;
}

const EDGE = 8;
const CORNERS: [right: 1 | -1, below: 1 | -1][] = [
  [1, 1],
  [-1, 1],
  [1, -1],
  [-1, -1],
];

function overlap(a: Area, b: Area): number {
  const width = Math.min(a.left + a.width, b.left + b.width) - Math.max(a.left, b.left);
  const height = Math.min(a.top + a.height, b.top + b.height) - Math.max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

/** `away`: how far from the robot's middle (x, y) the tag begins; `room`: the canvas. */
export function placeTag(
  x: number,
  y: number,
  away: number,
  size: { width: number; height: number },
  room: { width: number; height: number },
  taken: readonly Area[],
): TagPlace {
  let best: TagPlace | null = null;
  for (const [right, below] of CORNERS) {
    const left = right > 0 ? x + away + 12 : x - away - 12 - size.width;
    const top = below > 0 ? y + away * 0.6 : y - away * 0.6 - size.height;
    const area: Area = {
      left: Math.min(Math.max(left, EDGE), Math.max(room.width - size.width - EDGE, EDGE)),
      top: Math.min(Math.max(top, EDGE), Math.max(room.height - size.height - EDGE, EDGE)),
      ...size,
    };
    const pushed = Math.hypot(area.left - left, area.top - top) * 20;
    const cost = taken.reduce((sum, other) => sum + overlap(area, other), pushed);
    if (best === null || cost < best.cost) best = { area, right, below, cost };
  }
  if (best === null) throw new Error("a tag has four corners to choose from");
  return best;
}
