/**
 * What the card of the result needs of a run that is not in its last state: where robots have been, how often lamps went on, how
 * far robots turned, and which of their parts showed something.
 */
import { ARM_OUT, LAMP, MOVING, type Pose, type PoseFrame } from "../../../api/wire";
import { strokesOfRun } from "../../../components/scene/pen-strokes";
import { decimal } from "../../../i18n/numbers";
import { t } from "../../../i18n/words";
import { text } from "../../../model/texts";
import { useStudio } from "../../../model/studio";
import { lastFrame, placesOfThings } from "../../../session/poses";
import type { RunState } from "../../../session/run";
import { useOpenExercise } from "../../../session/open-exercise";
import { reachedGoal } from "./confetti";
import type { Facts } from "./account";
import { colourDeeds, type Deed, lineDeeds, returnDeeds, trainDeeds, wallDeeds, type RobotPath } from "./deeds";
import type { Trails } from "./trails";

/** A thing that is so far from where it lay was pushed, in mm. */
const PUSHED_MM = 20;
/** A run of so many ticks at most ended at once. */
const AT_ONCE = 2;
const ACTS = LAMP | MOVING | ARM_OUT;
/** Of more robots than this none is spoken of by its name. */
const MANY = 24;
/** So many parts of a robot, numbers and changes of a team are told. */
const FEW = 3;
/** Who turned less than this, in degrees, hardly turned. */
const LEAST_TURN = 20;
/** Who drove so far and touched nothing did that well, in mm. */
const CAREFUL_MM = 1500;

interface RobotRecord {
  lit: number;
  turned_rad: number;
  pose: Pose;
}

export class RunDiary {
  private flags = 0;
  private robots: RobotRecord[] = [];
  /** Of each robot the parts that showed anything. */
  private used = new Map<string, Set<string>>();

  clear(): void {
    this.flags = 0;
    this.robots = [];
    this.used.clear();
  }

  record({ poses }: PoseFrame): void {
    this.robots = poses.map((pose, at) => {
      this.flags |= pose.flags;
      const before = this.robots[at];
      if (before === undefined) return { lit: pose.flags & LAMP, turned_rad: 0, pose };
      const went = (pose.flags & LAMP) !== 0 && (before.pose.flags & LAMP) === 0;
      const turn = pose.heading_rad - before.pose.heading_rad;
      const turned_rad = before.turned_rad + Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn)));
      return { lit: before.lit + (went ? 1 : 0), turned_rad, pose };
    });
  }

  /** What robots showed and sounded. */
  look({ agents }: Pick<RunState, "agents">): void {
    for (const { name, used = [] } of agents) {
      if (used.length > 0) this.used.set(name, new Set([...(this.used.get(name) ?? []), ...used]));
    }
  }

  facts(run: RunState, trails: Trails): Facts {
    const { agents, events, total, status } = run;
    const lines = strokesOfRun(lastFrame()?.poses ?? []);
    const driven = trails.driven;
    const { open, goals } = useOpenExercise.getState();
    const reached = goals.filter((goal) => goal.reached === true).length;
    const own = Math.max(run.mission?.goals.length ?? 0, total > 0 ? 1 : 0);
    const happened = events.filter(({ kind, tick }) => kind !== "end" && tick <= run.tick);
    return {
      done: status === "done",
      sentence: endsPlainly(run, own) ? t("account.done", { time: `${decimal(run.seconds, 1, 1)} s` }) : run.sentence,
      atOnce: run.tick <= AT_ONCE,
      goals:
        open !== null && goals.length > 0
          ? { reached, count: goals.length }
          : { reached: reachedGoal(run) ? own : 0, count: own },
      lines: lines.map(({ points }) => points),
      driven: agents.map(({ name }, at) => ({ name, mm: driven[at] ?? 0 })),
      tickMs: run.tickMs,
      deeds: this.deeds(run, trails),
      acted: this.used.size > 0 || (this.flags & ACTS) !== 0 || happened.length > 0,
    };
  }

  private deeds(run: RunState, trails: Trails): Deed[] {
    const { agents, world, total, collisions } = run;
    const { robots } = useStudio.getState().catalogue;
    const driven = trails.driven;
    const ways = trails.ways.map(({ xs, ys, ticks }, at): RobotPath => {
      const length_mm = robots.find(({ name }) => name === agents[at]?.robot)?.length_mm ?? 0;
      return { name: agents[at]?.name ?? "", length_mm, xs, ys, ticks, mm: driven[at] ?? 0 };
    });
    const moved = ways.filter(({ mm }) => mm >= PUSHED_MM);
    const named = world === null || agents.length > MANY ? [] : moved;
    const careful = world !== null && world.walls.length > 0 && moved.some(({ mm }) => mm >= CAREFUL_MM);
    const done = Object.values(run.delivered).reduce((sum, count) => sum + count, 0);
    return [
      ...(total > 0 ? [{ kind: "delivered" as const, done, total }] : []),
      ...pushDeeds(run),
      ...(world === null ? [] : named.flatMap((way) => [...colourDeeds(world, way), ...lineDeeds(world, way)])),
      ...(collisions > 0 ? [] : trainDeeds(named)),
      ...returnDeeds(named),
      ...(world === null || collisions > 0
        ? []
        : named.flatMap((way) => {
            const pose = this.robots[ways.indexOf(way)]?.pose;
            return pose === undefined ? [] : wallDeeds(world, way, pose);
          })),
      ...teamDeeds(run),
      ...(collisions > 0 ? [{ kind: "touched" as const, count: collisions }] : []),
      ...this.lampDeeds(run),
      ...this.turnDeeds(run, ways),
      ...this.partDeeds(run),
      ...numberDeeds(run),
      ...(careful && collisions === 0 && pushDeeds(run).length === 0 ? [{ kind: "untouched" as const }] : []),
    ];
  }

  private lampDeeds({ agents }: RunState): Deed[] {
    const lit = agents.flatMap(({ name }, at) => {
      const count = this.robots[at]?.lit ?? 0;
      return count > 0 ? [{ name, count }] : [];
    });
    const [first] = lit;
    if (first === undefined) return [];
    const count = lit.reduce((sum, one) => sum + one.count, 0);
    return [{ kind: "lit", name: first.name, robots: lit.length, count }];
  }

  /** Who turned without driving anywhere. */
  private turnDeeds({ agents }: RunState, ways: readonly RobotPath[]): Deed[] {
    if (agents.length > FEW) return [];
    return agents.flatMap(({ name }, at) => {
      const angle = Math.round(((this.robots[at]?.turned_rad ?? 0) * 180) / Math.PI);
      return angle >= LEAST_TURN && (ways[at]?.mm ?? 0) < PUSHED_MM ? [{ kind: "turned", name, angle }] : [];
    });
  }

  /** Displays, music and whatever else showed something; pens are told by what they drew, lamps by their light. */
  private partDeeds({ agents }: RunState): Deed[] {
    const { robots } = useStudio.getState().catalogue;
    return agents.slice(0, FEW).flatMap(({ name, robot }) => {
      const objects = robots.find((one) => one.name === robot)?.objects ?? [];
      const parts = objects
        .filter((one) => one.category === "actuator" && one.look !== "pen" && this.used.get(name)?.has(one.name))
        .map((one) => text(one.label, one.name));
      return parts.length > 0 ? [{ kind: "used", name, parts: parts.slice(0, FEW) }] : [];
    });
  }
}

/** Whether the end itself is no news: programs ended, without goals of the mission, and nobody failed. */
function endsPlainly({ status, tick, events }: RunState, goals: number): boolean {
  return status === "done" && tick > AT_ONCE && goals === 0 && events.every(({ kind }) => kind !== "failure");
}

function pushDeeds({ world }: RunState): Deed[] {
  const places = placesOfThings();
  const far = (world?.things ?? []).map(({ x_mm, y_mm }, at) => {
    const [x, y] = places[at] ?? [x_mm, y_mm];
    return Math.hypot(x - x_mm, y - y_mm);
  });
  const pushed = far.filter((mm) => mm > PUSHED_MM);
  return pushed.length > 0 ? [{ kind: "pushed", count: pushed.length, mm: Math.max(...pushed) }] : [];
}

/** Who went to another place in its team: the first ones are told. */
function teamDeeds({ events, tick }: RunState): Deed[] {
  return events
    .filter((event) => event.kind === "member" && event.tick <= tick && event.agent !== "")
    .slice(-FEW)
    .map(({ agent, text: said }) => ({ kind: "changed", name: agent, text: said }));
}

/** What robots counted: their numbers that are not as they began. */
function numberDeeds({ agents }: RunState): Deed[] {
  const { robots } = useStudio.getState().catalogue;
  const found = agents.slice(0, FEW).flatMap(({ robot, values }) => {
    const objects = robots.find((one) => one.name === robot)?.objects ?? [];
    return objects.flatMap((one): Deed[] => {
      const value = values[one.name];
      const counts = one.category === "variable" && one.type === "integer" && value !== undefined;
      return counts && value !== one.initial ? [{ kind: "counted", name: text(one.label, one.name), value }] : [];
    });
  });
  return found.slice(0, FEW);
}
