/** Where one more robot can start: beside another, where nobody starts and nothing stands. */
import type { OwnWorld } from "../types";
import { roadLine, startPlace } from "./drawing";
import { thingAt } from "./hit-test";
import { placeAt } from "./line";
import type { Kind, Part } from "./part-reference";

const STEP_MM = 150;
/** From the middle of a robot to what stands there, and to the rim of the world. */
const CLEAR_MM = 75;
const MOST_RINGS = 100;
const IN_THE_WAY: readonly Kind[] = ["start", "ball", "box", "wall", "storehouse"];

type Start = Part<"start">;

function isFree(world: OwnWorld, x: number, y: number): boolean {
  const inside = Math.min(x, y, world.width_mm - x, world.height_mm - y) >= CLEAR_MM;
  return inside && thingAt(world, x, y, CLEAR_MM, IN_THE_WAY) === null;
}

/** 1, -1, 2, -2, … */
function steps(most: number): number[] {
  return Array.from({ length: most }, (_, at) => [at + 1, -at - 1]).flat();
}

function onRoad(world: OwnWorld, beside: Start, name: string): Start | null {
  const line = roadLine(world, beside.road);
  if (line === null) return null;
  const most = Math.min(Math.floor(line.length / STEP_MM), MOST_RINGS);
  for (const step of steps(most)) {
    const far = beside.at_mm + step * STEP_MM;
    const at_mm = Math.round(line.closed ? (far + most * line.length) % line.length : far);
    if (at_mm < 0 || at_mm > line.length) continue;
    const { x, y } = placeAt(line, at_mm);
    if (isFree(world, x, y)) return { ...beside, name, at_mm };
  }
  return null;
}

/** The steps to the places of a square around one, the near ones first. */
function ring(far: number): [number, number][] {
  const side = Array.from({ length: 2 * far + 1 }, (_, at) => at - far);
  return side
    .flatMap((a): [number, number][] => side.map((b) => [a, b]))
    .filter(([a, b]) => Math.max(Math.abs(a), Math.abs(b)) === far)
    .sort((one, other) => Math.hypot(...one) - Math.hypot(...other));
}

/**
 * A start of that name near the start `beside`, on its road where it is on one; near the middle where there is no such start.
 * null where the world is full.
 */
export function startNear(world: OwnWorld, beside: string, name: string): Start | null {
  const near = world.starts.find((start) => start.name === beside) ?? world.starts.at(-1);
  // In a storehouse and at a dock nobody stands in the way of another.
  if (near?.at === "storehouse" || near?.at === "dock") return { ...near, name };
  const along = near?.at === "road" ? onRoad(world, near, name) : null;
  if (along !== null) return along;
  const found = near === undefined ? null : startPlace(world, near);
  const from = found ?? { x: world.width_mm / 2, y: world.height_mm / 2, heading: 0 };
  const rings = Math.min(Math.ceil(Math.max(world.width_mm, world.height_mm) / STEP_MM), MOST_RINGS);
  for (let far = 0; far <= rings; far++) {
    for (const [across, up] of ring(far)) {
      const [x_mm, y_mm] = [Math.round(from.x + across * STEP_MM), Math.round(from.y + up * STEP_MM)];
      if (!isFree(world, x_mm, y_mm)) continue;
      const heading_deg = Math.round((from.heading * 180) / Math.PI);
      return { name, at: "pose", road: "", at_mm: 0, dock: "", storehouse: "", x_mm, y_mm, heading_deg };
    }
  }
  return null;
}
