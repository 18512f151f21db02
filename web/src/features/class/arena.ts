/** What a pupil's page tells of its run while the teacher looks on: where the robots are in which world, once a second. */
import type { ClassArena } from "../../api/generated";
import { useStudio } from "../../model/studio";
import { lastFrame, watchFrames } from "../../session/poses";
import { useRun } from "../../session/run";

const EVERY_MS = 1000;
/** After so many times it is told once more: the class may have begun anew, or the teacher have looked away. */
const AGAIN = 3;
const STEP_MM = 20;
const MOST_POINTS = 400;
const MOST_ROBOTS = 50;
/** A larger message than that the class does not take: then the world is too large to be told. */
const LONGEST = 48 * 1024;

export type Way = readonly [number, number][];

/** The way with one more point, when that is further on; half of its points where there are too many. */
export function further(way: Way, x: number, y: number): Way {
  const last = way.at(-1);
  if (last !== undefined && Math.hypot(x - last[0], y - last[1]) < STEP_MM) return way;
  const before = way.length < MOST_POINTS ? way : way.filter((_, at) => at % 2 === 0);
  return [...before, [Math.round(x), Math.round(y)]];
}

/** Tells it as long as `looked` says so; the returned function ends that. */
export function tellArena(looked: () => boolean, tell: (arena: ClassArena) => void): () => void {
  let way: Way = [];
  let of = "";
  let told = "";
  let quiet = 0;
  const off = watchFrames(() => {
    const { name } = useRun.getState();
    const first = lastFrame()?.poses[0];
    if (name !== of) way = [];
    of = name;
    if (first !== undefined) way = further(way, first.x_mm, first.y_mm);
  });
  const timer = setInterval(() => {
    if (!looked()) {
      told = "";
      return;
    }
    const { status, seconds, world: ran, real } = useRun.getState();
    const world = ran ?? useStudio.getState().world;
    if (world === null || real) return;
    const arena: ClassArena = {
      running: status === "running",
      seconds,
      world,
      poses: (lastFrame()?.poses ?? []).slice(0, MOST_ROBOTS).map((one) => [one.x_mm, one.y_mm, one.heading_rad]),
      way: [...way],
    };
    const words = JSON.stringify(arena);
    if ((words === told && ++quiet < AGAIN) || words.length > LONGEST) return;
    told = words;
    quiet = 0;
    tell(arena);
  }, EVERY_MS);
  return () => {
    off();
    clearInterval(timer);
  };
}
