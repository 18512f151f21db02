/** Lessons for tests: the path to learn as the test wants it. */
import { features, install } from "../session/features";
import type { Lesson } from "../session/lesson";
import { lookForLessons, useLessons } from "../session/lessons";

export function lesson(name: string, order: number, more: Partial<Lesson> = {}): Lesson {
  const texts = { label: { "": name }, help: {}, icon: "", start: `${name}.krt`, teacher: null, problems: [] };
  return { name, order, kind: "tutorial", ...texts, usable: true, far: () => "", begin: () => undefined, ...more };
}

const CLOSED = { tutorial: null, exercise: null };

/** The path is of these, and nothing is learned; the returned function puts back what other tests need. */
export async function setPath(...lessons: Lesson[]): Promise<() => void> {
  const before = features();
  install([{ name: "lessons", lessons: () => Promise.resolve(lessons) }]);
  localStorage.clear();
  useLessons.setState({ path: null, learned: [], open: CLOSED });
  await lookForLessons();
  return () => {
    install(before);
    useLessons.setState({ path: null, learned: [], open: CLOSED });
  };
}
