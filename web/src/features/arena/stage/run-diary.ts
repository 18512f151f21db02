/**
 * What the card of the result needs of a run that is not in its last state: where robots have been, and whether anything was
 * seen or heard of them.
 */
import { ARM_OUT, LAMP, MOVING, type PoseFrame } from "../../../api/wire";
import { strokesOfRun } from "../../../components/scene/pen-strokes";
import { lastFrame, placesOfThings } from "../../../session/poses";
import type { RunState } from "../../../session/run";
import { useOpenExercise } from "../../../session/open-exercise";
import { reachedGoal } from "./confetti";
import type { Facts } from "./account";
import type { Trails } from "./trails";

/** A thing that is so far from where it lay was pushed, in mm. */
const PUSHED_MM = 20;
/** A run of so many ticks at most ended at once. */
const AT_ONCE = 2;
const ACTS = LAMP | MOVING | ARM_OUT;

export class RunDiary {
  private flags = 0;
  private shown = false;

  clear(): void {
    this.flags = 0;
    this.shown = false;
  }

  record({ poses }: PoseFrame): void {
    for (const pose of poses) this.flags |= pose.flags;
  }

  /** What robots show and sound. */
  look({ agents }: Pick<RunState, "agents">): void {
    this.shown ||= agents.some(({ shown }) => Object.values(shown).some((numbers) => numbers.some((one) => one !== 0)));
  }

  facts(run: RunState, trails: Trails): Facts {
    const { agents, events, world, total, status } = run;
    const lines = strokesOfRun(lastFrame()?.poses ?? []);
    const places = placesOfThings();
    const pushed = (world?.things ?? []).filter(({ x_mm, y_mm }, at) => {
      const [x, y] = places[at] ?? [x_mm, y_mm];
      return Math.hypot(x - x_mm, y - y_mm) > PUSHED_MM;
    });
    const driven = trails.driven;
    const { open, goals } = useOpenExercise.getState();
    const reached = goals.filter((goal) => goal.reached === true).length;
    const own = Math.max(run.mission?.goals.length ?? 0, total > 0 ? 1 : 0);
    const happened = events.filter(({ kind, tick }) => kind !== "end" && tick <= run.tick);
    return {
      done: status === "done",
      sentence: run.sentence,
      atOnce: run.tick <= AT_ONCE,
      goals:
        open !== null && goals.length > 0
          ? { reached, count: goals.length }
          : { reached: reachedGoal(run) ? own : 0, count: own },
      lines: lines.map(({ points }) => points),
      driven: agents.map(({ name }, at) => ({ name, mm: driven[at] ?? 0 })),
      pushed: pushed.length,
      acted: this.shown || (this.flags & ACTS) !== 0 || happened.length > 0,
    };
  }
}
