/**
 * What a run did, in words, from what is known of it: the shape that was drawn, how far was driven, what was pushed and
 * delivered, goals. It knows nothing of any mission.
 *
 * Green is only for a goal; amber says that nothing came of it, red what the run itself calls a failure.
 */
import { decimal } from "../../../i18n/numbers";
import { t } from "../../../i18n/words";
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
  pushed: number;
  /** Whether anything else was seen or heard of a robot: light, sound, turning, messages. */
  acted: boolean;
}

/** Less than this is no movement, in mm. */
const STILL_MM = 10;
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

export function accountOf(facts: Facts): Account {
  const { sentence, goals, pushed } = facts;
  if (!facts.done) return { tone: "failure", title: sentence, more: [] };
  const [drawn, drove] = [drawnWords(facts.lines), drivenWords(facts.driven)];
  const found = [
    ...(drawn === null ? [] : [drawn.title, ...drawn.more]),
    ...(pushed > 0 ? [t("account.pushed", { count: pushed })] : []),
    ...(drove === null ? [] : [drove]),
  ];
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
