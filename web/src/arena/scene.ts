/**
 * What the arena shows: the world, who is in it and where, the stock; before a run, as the mission starts.
 *
 * Who drives, who is an arm beside a dock and who sits in a storehouse is read from where they start: that decides how
 * they are drawn and nothing else.
 */
import type { Catalogue, Goal, Mission, World } from "../api/types";
import { COLLISION, FAILED, type Pose } from "../api/wire";
import { text } from "../model/texts";
import type { RunAgent, RunState } from "../run/run";
import { nearestOn, signAt } from "./geometry";

export type Role = "robot" | "arm" | "keeper";

export interface Actor {
  name: string;
  program: string;
  number: number;
  role: Role;
  start: Pose;
  /** "Sign = 4", "Cargo": what its sensors say now. */
  senses: string[];
  failed: boolean;
}

export interface Scene {
  world: World;
  actors: Actor[];
  stock: Record<string, number>;
  delivered: number;
  total: number;
  collisions: number;
  running: boolean;
}

const ARM_REACH_MM = 90;
const NOWHERE: Pose = { x_mm: 0, y_mm: 0, heading_rad: 0, load: 0, flags: 0 };

export function roleAt(world: World, x: number, y: number): Role {
  const inside = world.storehouses.some(
    (house) =>
      x >= house.x_mm && x <= house.x_mm + house.width_mm && y >= house.y_mm && y <= house.y_mm + house.height_mm,
  );
  if (inside) return "keeper";
  if (world.roads.some((road) => nearestOn(road, x, y).off <= road.width_mm / 2)) return "robot";
  const beside = world.docks.some((dock) => {
    const half = (world.roads.find((road) => road.name === dock.road)?.width_mm ?? 0) / 2;
    const off = Math.hypot(dock.x_mm - x, dock.y_mm - y);
    return off > half && off < half + ARM_REACH_MM;
  });
  return beside ? "arm" : "robot";
}

function numberOf(name: string, index: number): number {
  const digits = /(\d+)$/.exec(name)?.[1];
  return digits === undefined ? index + 1 : Number(digits);
}

/** Where an agent starts; null where the world has no such place. */
function startPose(world: World, mission: Mission, name: string): Pose | null {
  const wanted = mission.agents.find((agent) => agent.name === name)?.start ?? "";
  const start = world.starts.find((one) => one.name === (wanted === "" ? name : wanted));
  if (start === undefined) return null;
  const { x_mm, y_mm, heading_rad } = start;
  return { x_mm, y_mm, heading_rad, load: 0, flags: 0 };
}

/** How much has to be delivered; "all" is everything that lies elsewhere. */
export function totalOf(world: World, goals: readonly Goal[]): number {
  let total = 0;
  for (const { storehouse, stock } of goals) {
    const elsewhere = world.storehouses.filter((house) => house.name !== storehouse);
    total += stock === "all" ? elsewhere.reduce((sum, house) => sum + house.stock, 0) : Number(stock) || 0;
  }
  return total;
}

/** A robot's sensors in words; tests say their name only while they are true. */
export function sensesOf(agent: RunAgent, catalogue: Catalogue): string[] {
  const objects = catalogue.robots.find((robot) => robot.name === agent.robot)?.objects ?? [];
  const words: string[] = [];
  for (const [name, value] of Object.entries(agent.inputs)) {
    // An actuator may have the same name.
    const object = objects.find((one) => one.name === name && one.category === "sensor");
    if (object === undefined) continue;
    const label = text(object.label, name);
    if (object.type === "boolean") {
      if (value !== 0) words.push(label);
    } else {
      words.push(`${label} = ${String(value)}`);
    }
  }
  return words;
}

export function sceneBefore(mission: Mission, world: World): Scene {
  return {
    world,
    actors: mission.agents.flatMap((agent, index) => {
      const start = startPose(world, mission, agent.name);
      if (start === null) return [];
      const role = roleAt(world, start.x_mm, start.y_mm);
      const number = numberOf(agent.name, index);
      return [{ name: agent.name, program: agent.program, number, role, start, senses: [], failed: false }];
    }),
    stock: Object.fromEntries(world.storehouses.map((house) => [house.name, house.stock])),
    delivered: 0,
    total: totalOf(world, mission.goals),
    collisions: 0,
    running: false,
  };
}

export function sceneOf(run: RunState, mission: Mission, catalogue: Catalogue, world: World): Scene {
  return {
    world,
    actors: run.agents.map((agent) => {
      const pose = startPose(world, mission, agent.name) ?? NOWHERE;
      return {
        name: agent.name,
        program: agent.program,
        number: agent.number,
        role: roleAt(world, pose.x_mm, pose.y_mm),
        start: pose,
        senses: sensesOf(agent, catalogue),
        failed: agent.state === "failed",
      };
    }),
    stock: run.stock,
    delivered: Object.values(run.delivered).reduce((sum, count) => sum + count, 0),
    total: run.total,
    collisions: run.collisions,
    running: true,
  };
}

export interface Seen {
  actor: Actor;
  pose: Pose;
  sign: number | null;
  failed: boolean;
  collided: boolean;
}

/** The actors at their poses. */
export function lookAt(scene: Scene, poses: readonly Pose[] | null): Seen[] {
  return scene.actors.map((actor, index) => {
    const pose = poses?.[index] ?? actor.start;
    return {
      actor,
      pose,
      sign: actor.role === "robot" ? signAt(scene.world, pose.x_mm, pose.y_mm) : null,
      failed: actor.failed || (pose.flags & FAILED) !== 0,
      collided: (pose.flags & COLLISION) !== 0,
    };
  });
}
