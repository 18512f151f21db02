/** Which examples fit what is looked for, and under which level each stands. */
import type { MissionEntry } from "../../api/generated";
import type { Texts } from "../../model/types";
import { holding } from "../../ui/matching";

export interface Wish {
  /** Words, each of which has to stand somewhere in what is said of an example. */
  words: string;
  /** From 1; 0 for all. */
  level: number;
  /** Names; "" for all. */
  topic: string;
  robot: string;
}

export const ALL: Wish = { words: "", level: 0, topic: "", robot: "" };

type Say = (texts: Texts, fallback: string) => string;

/** All that is said of an example in the reader's language. */
function said(entry: MissionEntry, say: Say, robot: (name: string) => string): string {
  const { example, label, help, name, title } = entry;
  const topics = example?.topics.map((topic) => say(topic.label, topic.name)) ?? [];
  const robots = example?.robots.map(robot) ?? [];
  return [name, say(label, title), say(help, ""), ...topics, ...robots].join(" ");
}

/** The examples that fit, in their order. */
export function fitting(
  examples: readonly MissionEntry[],
  wish: Wish,
  say: Say,
  robot: (name: string) => string,
): MissionEntry[] {
  const holds = holding(wish.words);
  return examples.filter((entry) => {
    const { example } = entry;
    if (example === null) return false;
    if (wish.level > 0 && example.level !== wish.level) return false;
    if (wish.topic !== "" && !example.topics.some(({ name }) => name === wish.topic)) return false;
    if (wish.robot !== "" && !example.robots.includes(wish.robot)) return false;
    return holds(said(entry, say, robot));
  });
}

export interface Level {
  level: number;
  entries: MissionEntry[];
}

/** By level, the easiest first; those of which nobody said one last. */
export function byLevel(entries: readonly MissionEntry[]): Level[] {
  const levels = [...new Set(entries.map(({ example }) => example?.level ?? 0))];
  return levels
    .sort((a, b) => (a || Infinity) - (b || Infinity))
    .map((level) => ({ level, entries: entries.filter(({ example }) => (example?.level ?? 0) === level) }));
}

export interface Named {
  name: string;
  label: Texts;
}

/** The topics there are, each once, the one with the most examples first. */
export function topicsOf(entries: readonly MissionEntry[]): Named[] {
  const found = new Map<string, { topic: Named; count: number }>();
  for (const { example } of entries) {
    for (const topic of example?.topics ?? []) {
      const known = found.get(topic.name);
      if (known === undefined) found.set(topic.name, { topic, count: 1 });
      else known.count++;
    }
  }
  return [...found.values()].sort((a, b) => b.count - a.count).map(({ topic }) => topic);
}

/** The kinds of robots there are, each once. */
export function robotsOf(entries: readonly MissionEntry[]): string[] {
  return [...new Set(entries.flatMap(({ example }) => example?.robots ?? []))];
}
