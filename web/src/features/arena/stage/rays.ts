/** Where the rays of a robot's range finders begin and end, from what the sensors read. */
import type { Seen } from "../../../components/scene/scene";
import type { Robot } from "../../../model/types";

type Point = [x_mm: number, y_mm: number];

export interface Ray {
  from: Point;
  to: Point;
  /** How long it is, in mm. */
  mm: number;
  /** Whether something is there: false where it goes as far as it can see. */
  ends: boolean;
}

export function raysOf(
  robot: Robot | undefined,
  inputs: Readonly<Record<string, number>>,
  { actor, pose }: Pick<Seen, "actor" | "pose">,
): Ray[] {
  return (robot?.objects ?? []).flatMap(({ name, category, ray, min, max }) => {
    const value = inputs[name];
    if (category !== "sensor" || ray == null || value === undefined || max <= min) return [];
    const share = Math.min(Math.max((value - min) / (max - min), 0), 1);
    const angle = pose.heading_rad + ray.angle_rad;
    const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
    const mm = share * ray.reach_mm;
    const at = (far: number): Point => [pose.x_mm + ux * far, pose.y_mm + uy * far];
    const edge = actor.length_mm / 2;
    return [{ from: at(edge), to: at(edge + mm), mm, ends: share < 1 }];
  });
}
