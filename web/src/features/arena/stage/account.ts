/**
 * What a run did, in words, from what is known of it: the shape that was drawn, what was delivered, pushed, found and
 * touched (`deeds.ts`), how far was driven, goals. It knows nothing of any mission.
 *
 * Green is only for a goal; amber says that nothing came of it, red what the run itself calls a failure.
 */
import { decimal } from "../../../i18n/numbers";
import { t } from "../../../i18n/words";
import type { Deed } from "./deeds";
import { commonOf, joinLines, lengthOf, type Line, shapeOf } from "./shape";

export type Tone = "goal" | "plain" | "nothing" | "failure";

export interface Account {
  tone: Tone;
  title: string;
  /** Further sentences. */
  more: string[];
}

export interface Facts {
  /** Whether it ended as done. */
  done: boolean;
  /** How the server says that it ended. */
  sentence: string;
  /** Whether it ended before anything could take time. */
  atOnce: boolean;
  /** How many goals there are and how many are reached; those of the mission and of an exercise. */
  goals: { reached: number; count: number };
  /** What pens drew. */
  lines: readonly Line[];
  /** Of each robot its name and how far it drove, in mm. */
  driven: readonly { name: string; mm: number }[];
  tickMs: number;
  /** What else robots did, the most telling first. */
  deeds: readonly Deed[];
  /** Whether anything else was seen or heard of a robot: light, sound, turning, messages. */
  acted: boolean;
}

/** Less than this is no movement, in mm. */
const STILL_MM = 10;
/** So many sentences stand before the one that says how the run ended. */
const MOST_SAID = 5;
/** More lines than this are not counted one by one. */
const MOST_LINES = 12;

export function lengthWords(mm: number): string {
  return mm < 995 ? `${decimal(Math.round(mm / 10))} cm` : `${decimal(Math.round(mm / 10) / 100)} m`;
}

/** "4 sides of 30 cm, 4 corners of 90°". */
function sidesOf(sides: readonly number[], corners: readonly number[]): string {
  const [side, corner] = [commonOf(sides, 0.06, 8), commonOf(corners, 0, 4)];
  const count = sides.length;
  const many = corners.length;
  return t("account.both", {
    sides: side === null ? t("account.sides", { count }) : t("account.sides-of", { count, length: lengthWords(side) }),
    corners:
      corner === null
        ? t("account.corners", { count: many })
        : t("account.corners-of", { count: many, angle: Math.round(corner) }),
  });
}

/** What pens drew: a title, and what there is to count of it. */
export function drawnWords(lines: readonly Line[]): { title: string; more: string[] } | null {
  const joined = joinLines(lines).filter((line) => lengthOf(line) > STILL_MM);
  const [first] = joined;
  if (first === undefined) return null;
  const length = lengthWords(joined.reduce((sum, line) => sum + lengthOf(line), 0));
  const shapes = joined.length > MOST_LINES ? [] : joined.map(shapeOf);
  const closed = shapes.filter((shape) => shape?.closed === true);
  const [shape] = closed.length > 0 ? closed : shapes;
  if (shape == null || (joined.length > 1 && closed.length === 0)) {
    return { title: t("account.lines", { length }), more: [] };
  }
  if (closed.length > 1) return { title: t("account.closed-many", { count: closed.length }), more: [] };
  if (!shape.closed && shape.sides.length === 1) return { title: t("account.line", { length }), more: [] };
  return {
    title: t(shape.closed ? "account.closed" : "account.open"),
    more: [sidesOf(shape.sides, shape.corners)],
  };
}

function drivenWords(driven: Facts["driven"]): string | null {
  const moved = driven.filter(({ mm }) => mm >= STILL_MM);
  const [one] = moved;
  if (one === undefined) return null;
  if (moved.length === 1) return t("account.drove", { name: one.name, length: lengthWords(one.mm) });
  const length = lengthWords(moved.reduce((sum, { mm }) => sum + mm, 0));
  return t("account.drove-many", { count: moved.length, length });
}

function colourHoles({ name, colour, tick }: Extract<Deed, { kind: "found" | "left" }>, tickMs: number) {
  return { name, colour: t(`world.${colour}`), time: `${decimal((tick * tickMs) / 1000, 1, 1)} s` };
}

/** A deed as a sentence. */
export function deedWords(deed: Deed, tickMs: number): string {
  switch (deed.kind) {
    case "delivered":
      return t("arena.delivered-of", { done: deed.done, total: deed.total });
    case "pushed":
      return t("account.pushed", { count: deed.count, length: lengthWords(deed.mm) });
    case "found":
      return t("account.found", colourHoles(deed, tickMs));
    case "left":
      return t("account.left", colourHoles(deed, tickMs));
    case "followed":
      return t("account.followed", { name: deed.name, length: lengthWords(deed.mm) });
    case "returned":
      return deed.count === 1
        ? t("account.returned", { name: deed.name })
        : t("account.returned-many", { count: deed.count });
    case "before-wall":
      return t("account.before-wall", { name: deed.name, length: lengthWords(deed.mm) });
    case "apart":
      return t("account.apart", { count: deed.count, least: lengthWords(deed.least), most: lengthWords(deed.most) });
    case "changed":
      return `${deed.name} ${deed.text}.`;
    case "touched":
      return t("account.touched", { count: deed.count });
    case "untouched":
      return t("account.untouched");
    case "lit":
      return deed.robots === 1
        ? t("account.lit", { count: deed.count, name: deed.name })
        : t("account.lit-many", { count: deed.count, robots: deed.robots });
    case "turned":
      return t("account.turned", { name: deed.name, angle: deed.angle });
    case "used":
      return t("account.used", { name: deed.name, parts: deed.parts.join(", ") });
    case "counted":
      return t("account.counted", { name: deed.name, value: decimal(deed.value) });
  }
}

export function accountOf(facts: Facts): Account {
  const { sentence, goals, deeds, tickMs } = facts;
  if (!facts.done) return { tone: "failure", title: sentence, more: [] };
  const [drawn, drove] = [drawnWords(facts.lines), drivenWords(facts.driven)];
  const said = deeds.map((deed) => deedWords(deed, tickMs));
  const along = deeds.some(({ kind }) => kind === "followed");
  // What was done comes first; how far was driven stands after the most telling of it.
  const found = [
    ...(drawn === null ? [] : [drawn.title, ...drawn.more]),
    ...said.slice(0, 1),
    // Who followed a line drove as far as that says.
    ...(drove === null || (along && facts.driven.length === 1) ? [] : [drove]),
    ...said.slice(1),
  ].slice(0, MOST_SAID);
  if (goals.count > 0 && goals.reached === goals.count) {
    return {
      tone: "goal",
      title: t("account.goals", { reached: goals.reached, count: goals.count }),
      more: [...found, sentence],
    };
  }
  const some = goals.count > 0 ? [t("account.goals", { reached: goals.reached, count: goals.count })] : [];
  const [title, ...more] = found;
  if (title !== undefined && !facts.atOnce) return { tone: "plain", title, more: [...more, ...some, sentence] };
  if (facts.atOnce || facts.acted) {
    return { tone: facts.atOnce ? "nothing" : "plain", title: sentence, more: [...found, ...some] };
  }
  return { tone: "nothing", title: t("account.still"), more: [...some, sentence] };
}
