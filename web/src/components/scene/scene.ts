/**
 * What the arena shows: the world, who is in it and where, the stock; before a run, as the mission starts.
 *
 * Who drives, who is an arm beside a dock and who sits in a storehouse is read from where they start: that decides how
 * they are drawn and nothing else.
 */
import { COLLISION, FAILED, MUTED, type Pose, STALLED } from "../../api/wire";
import { text } from "../../model/texts";
import type { Catalogue, Goal, Mission, Robot, World } from "../../model/types";
import { valueWords } from "../../model/words";
import type { RunAgent, RunState } from "../../session/run";
import {
  type Face,
  faceOf,
  type HandKey,
  type Indicator,
  indicatorsOf,
  keysOf,
  type Slider,
  slidersOf,
} from "./boards";
import { isIn, nearestOn, ROBOT_MM } from "./geometry";
import { DRIVING, STONE, SUN } from "./lids";

export type Role = "robot" | "arm" | "keeper";

export interface Actor {
  name: string;
  program: string;
  number: number;
  role: Role;
  /** How long its body is: of one that moves freely the diameter of the disc that touches walls and others. */
  length_mm: number;
  /** Whether it is off the roads. */
  free: boolean;
  start: Pose;
  /** How it is drawn (`figures.ts`), and in which of the colours of robots (`lids.ts`). */
  figure: string;
  lid: number;
  /** "Sign = 4", "Cargo": what its sensors say now, by their names. */
  senses: { name: string; words: string }[];
  failed: boolean;
  /** What it shows, when it is a board with a display. */
  face: Face | null;
  /** What a person can hold. */
  keys: HandKey[];
  sliders: Slider[];
  /** What is drawn beside it. */
  indicators: Indicator[];
}

export interface Scene {
  world: World;
  actors: Actor[];
  stock: Record<string, number>;
  delivered: number;
  total: number;
  collisions: number;
  running: boolean;
  /** Whether real robots run, or ran in a recording: nobody knows where they are, so none is drawn. */
  real: boolean;
}

const ARM_REACH_MM = 90;
const NOWHERE: Pose = { x_mm: 0, y_mm: 0, heading_rad: 0, load: 0, flags: 0 };

export function roleAt(world: World, x: number, y: number): Role {
  if (world.storehouses.some((house) => isIn(house, { x_mm: x, y_mm: y }))) return "keeper";
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

interface Place {
  start: Pose;
  role: Role;
  free: boolean;
  lid: number;
}

/** What a robot is drawn as whose XML names nothing. */
const FIGURES: Readonly<Record<Role, string>> = { robot: "mini-robot", arm: "loader", keeper: "store-manager" };

/** The places of one mission in one world, worked out once: there may be thousands of robots, and thirty frames a second. */
type Starting = Pick<Mission, "agents">;
const known = new WeakMap<World, { mission: Starting; places: Map<string, Place> }>();

/** Where each agent starts, by its name; without those whose start the world does not have. */
function placesOf(world: World, mission: Starting): Map<string, Place> {
  const before = known.get(world);
  if (before?.mission.agents === mission.agents) return before.places;
  const starts = new Map(world.starts.map((start) => [start.name, start]));
  const places = new Map<string, Place>();
  let driving = 0;
  for (const agent of mission.agents) {
    const start = starts.get(agent.start === "" ? agent.name : agent.start);
    if (start === undefined) continue;
    const { x_mm, y_mm, heading_rad } = start;
    const pose = { x_mm, y_mm, heading_rad, load: 0, flags: 0 };
    const free = !world.roads.some((road) => nearestOn(road, x_mm, y_mm).off <= road.width_mm / 2);
    const role = roleAt(world, x_mm, y_mm);
    const lid = role === "robot" ? driving++ % DRIVING : role === "arm" ? SUN : STONE;
    places.set(agent.name, { start: pose, role, free, lid });
  }
  known.set(world, { mission, places });
  return places;
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

/** What is drawn of somebody who takes part in a run. */
export type SceneAgent = Pick<RunAgent, "name" | "program" | "robot" | "number" | "state" | "inputs" | "shown">;

/** A robot's sensors in words; tests say their name only while they are true. */
function sensesOf(agent: SceneAgent, robot: Robot | undefined): Actor["senses"] {
  const objects = robot?.objects ?? [];
  const senses: Actor["senses"] = [];
  const say = (name: string, words: string) => senses.push({ name, words });
  for (const [name, value] of Object.entries(agent.inputs)) {
    // An actuator may have the same name.
    const object = objects.find((one) => one.name === name && one.category === "sensor");
    if (object === undefined) continue;
    const label = text(object.label, name);
    if (object.meaning != null || object.unit) say(name, `${label}: ${valueWords(object, value)}`);
    else if (object.type !== "boolean") say(name, `${label} = ${String(value)}`);
    else if (value !== 0) say(name, label);
  }
  return senses;
}

/** A robot that stands somewhere, as it is drawn. */
function bodyOf(
  robot: Robot | undefined,
  place: Place,
  shown: RunAgent["shown"] = {},
  inputs: RunAgent["inputs"] = {},
): Place & Pick<Actor, "length_mm" | "figure" | "face" | "keys" | "sliders" | "indicators"> {
  return {
    ...place,
    // Arms, boards and robots that are not at hand have no length of their own.
    length_mm: robot?.length_mm || ROBOT_MM,
    figure: robot?.figure || FIGURES[place.role],
    face: faceOf(robot, shown),
    keys: keysOf(robot, inputs),
    sliders: slidersOf(robot, inputs),
    indicators: indicatorsOf(robot, shown),
  };
}

export function sceneBefore(mission: Mission, world: World, catalogue: Catalogue | null = null): Scene {
  const places = placesOf(world, mission);
  const robots = new Map<string, Robot | undefined>(
    mission.programs.map(({ name, robot }) => [name, catalogue?.robots.find((one) => one.name === robot)]),
  );
  return {
    world,
    actors: mission.agents.flatMap((agent, index) => {
      const place = places.get(agent.name);
      if (place === undefined) return [];
      const number = numberOf(agent.name, index);
      const { name, program } = agent;
      return [{ name, program, number, ...bodyOf(robots.get(program), place), senses: [], failed: false }];
    }),
    stock: Object.fromEntries(world.storehouses.map((house) => [house.name, house.stock])),
    delivered: 0,
    total: totalOf(world, mission.goals),
    collisions: 0,
    running: false,
    real: false,
  };
}

/** The world without the robots that nobody knows the place of. */
export function sceneOfReal(world: World): Scene {
  const stock = Object.fromEntries(world.storehouses.map((house) => [house.name, house.stock]));
  return { world, actors: [], stock, delivered: 0, total: 0, collisions: 0, running: true, real: true };
}

type Standing = Pick<RunState, "stock" | "delivered" | "total" | "collisions">;

const LOST: Place = { start: NOWHERE, role: "robot", free: true, lid: 0 };

/** Those who take part in a run. */
export function actorsOf(
  agents: readonly SceneAgent[],
  mission: Starting,
  catalogue: Catalogue,
  world: World,
): Actor[] {
  const places = placesOf(world, mission);
  return agents.map((agent) => {
    const { name, program, number } = agent;
    const robot = catalogue.robots.find((one) => one.name === agent.robot);
    const body = bodyOf(robot, places.get(name) ?? LOST, agent.shown, agent.inputs);
    return { name, program, number, ...body, senses: sensesOf(agent, robot), failed: agent.state === "failed" };
  });
}

/** Whether the world or the team of one mission is not that of the other; what the programs do is not asked. */
export function hasOtherPlaces(one: Mission, other: Mission): boolean {
  const parts = ["agents", "world", "own_world"] as const;
  return parts.some(
    (part) => one[part] !== other[part] && JSON.stringify(one[part] ?? null) !== JSON.stringify(other[part] ?? null),
  );
}

/** A run as it stands. */
export function sceneOf(run: Standing, actors: Actor[], world: World): Scene {
  return {
    world,
    actors,
    stock: run.stock,
    delivered: Object.values(run.delivered).reduce((sum, count) => sum + count, 0),
    total: run.total,
    collisions: run.collisions,
    running: true,
    real: false,
  };
}

export interface Seen {
  actor: Actor;
  pose: Pose;
  failed: boolean;
  stalled: boolean;
  muted: boolean;
  collided: boolean;
}

/** The actors at their poses. */
export function lookAt(scene: Scene, poses: readonly Pose[] | null): Seen[] {
  return scene.actors.map((actor, index) => {
    const pose = poses?.[index] ?? actor.start;
    return {
      actor,
      pose,
      failed: actor.failed || (pose.flags & FAILED) !== 0,
      stalled: (pose.flags & STALLED) !== 0,
      muted: (pose.flags & MUTED) !== 0,
      collided: (pose.flags & COLLISION) !== 0,
    };
  });
}
