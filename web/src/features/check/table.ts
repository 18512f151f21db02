/** The table of a check: a row for each property, a column for each assumption. */
import type { CheckedEvent, CheckedProperty, OtherWay, Scene, VerifyColumnMessage } from "../../api/generated";
import type { CounterexampleMark } from "../../session/counterexample";
import type { Cell } from "../../ui/grid";

export type { Cell };
export type Timing = VerifyColumnMessage["timing"];

export interface Assumption {
  timing: Timing;
  failures: number;
}

export const TIMINGS: readonly Timing[] = ["lockstep", "prompt", "free"];

/** What an answer looks like: a shape and a word, never a hue. */
export type Shape =
  "holds" | "broken" | "unconfirmed" | "cut" | "vacuous" | "nothing" | "undecided" | "running" | "waits" | "none";

/** The assumptions with up to so many failures, from the fast to the thorough. */
export function plan(failures: number): Assumption[] {
  return Array.from({ length: failures + 1 }, (_, count) =>
    TIMINGS.map((timing): Assumption => ({ timing, failures: count })),
  ).flat();
}

export function sameAssumption(one: Assumption, other: Assumption): boolean {
  return one.timing === other.timing && one.failures === other.failures;
}

export function columnAt(
  assumptions: readonly Assumption[],
  columns: readonly VerifyColumnMessage[],
  place: number,
): VerifyColumnMessage | undefined {
  const wanted = assumptions[place];
  return wanted === undefined ? undefined : columns.find((one) => sameAssumption(one, wanted));
}

/** How an answer is drawn; of a property that has none yet, whether its column is explored now, or will be. */
export function shapeOf(answer: CheckedProperty | undefined, busy: boolean, now: boolean): Shape {
  if (answer === undefined) return !busy ? "none" : now ? "running" : "waits";
  switch (answer.answer) {
    case "holds":
    case "vacuous":
      return answer.answer;
    case "not finished":
      return "cut";
    case "nothing found":
      return "nothing";
    case "not decided":
      return "undecided";
    case "broken":
      return answer.confirmed === null ? "unconfirmed" : "broken";
  }
}

/** A part of a run in words: what happens once, or again and again, and the events that are left out after it. */
export interface Stretch {
  repeats: boolean;
  events: readonly CheckedEvent[];
}

/** A run as what happens at first and what then repeats. */
export function stretches({ events, repeats_from }: CheckedProperty): Stretch[] {
  if (repeats_from < 0) return [{ repeats: false, events }];
  return [
    { repeats: false, events: events.filter(({ step }) => step < repeats_from) },
    { repeats: true, events: events.filter(({ step }) => step >= repeats_from) },
  ];
}

/** A run of the model that can be played step by step. */
export type ModelRun = Pick<CheckedProperty, "scenes" | "events" | "steps" | "repeats_from">;

/** The way that keeps a property, from the deciding step on. */
export function otherRun({ scenes, events }: OtherWay): ModelRun {
  return { scenes, events, steps: scenes.at(-1)?.step ?? 0, repeats_from: -1 };
}

/** The place of the scene with which what repeats begins again; null where nothing does. */
export function repeatedFrom({ scenes, repeats_from }: ModelRun): number | null {
  const again = scenes.findIndex(({ step }) => step === repeats_from + 1);
  return repeats_from < 0 || again < 0 ? null : again;
}

/** The steps of runs from one on of which one of them has a scene, in their order. */
export function momentsFrom(runs: readonly ModelRun[], from: number): number[] {
  const steps = runs.flatMap(({ scenes }) => scenes.map(({ step }) => step)).filter((step) => step >= from);
  return [...new Set(steps)].sort((one, other) => one - other);
}

/** Where a run stands after so many steps; behind its end it repeats, or stays as it is. Null without scenes. */
export function sceneAt({ scenes, repeats_from: from }: ModelRun, step: number): Scene | null {
  const last = scenes.at(-1)?.step ?? 0;
  const round = from >= 0 && last > from ? last - from : 0;
  const there = step <= last || round === 0 ? step : from + 1 + ((step - from - 1) % round);
  return scenes.findLast((scene) => scene.step <= there) ?? null;
}

/** The last steps of a run before its end that are told on the graph. */
const TOLD = 14;

/** What the graph shows of a run: where the property is broken, and the vertices that those robots come to. */
export function counterexampleMarks(
  { guilty, scenes, steps }: CheckedProperty,
  agents: readonly string[],
): CounterexampleMark[] {
  const marks = new Map<string, CounterexampleMark>();
  const at = (program: string, vertex: string): CounterexampleMark => {
    const key = `${program}\n${vertex}`;
    const found = marks.get(key) ?? { program, vertex, sentence: "", robots: [], repeats: false, steps: [] };
    marks.set(key, found);
    return found;
  };
  const put = (mark: CounterexampleMark) => marks.set(`${mark.program}\n${mark.vertex}`, mark);
  const told = new Set<string>();
  for (const { agent, program, vertex, sentence, repeats } of guilty) {
    const mark = at(program, vertex);
    // One sentence in each program: several would lie on each other.
    const words = told.has(program) ? mark.sentence : sentence;
    told.add(program);
    put({ ...mark, sentence: words, repeats: mark.repeats || repeats, robots: [...mark.robots, agent] });
  }
  const robots = agents.flatMap((name, place) => (guilty.some(({ agent }) => agent === name) ? [place] : []));
  scenes.forEach((scene, place) => {
    if (place === 0 || scene.step <= steps - TOLD) return;
    for (const robot of robots) {
      const before = scenes[place - 1]?.robots[robot]?.at ?? [];
      for (const [program, vertex] of scene.robots[robot]?.at ?? []) {
        if (before.some(([one, other]) => one === program && other === vertex)) continue;
        const mark = at(program, vertex);
        if (!mark.steps.includes(scene.step)) put({ ...mark, steps: [...mark.steps, scene.step] });
      }
    }
  });
  return [...marks.values()];
}
