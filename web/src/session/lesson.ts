/** A lesson of the path to learn, and where one stands on it, as pure functions. */
import type { TeacherPage } from "../api/generated";
import type { Problem, Texts } from "../model/types";
import { parseStored } from "../ui/browser-storage";

export type LessonKind = "tutorial" | "exercise";

export interface Lesson {
  /** The name of its file. */
  name: string;
  kind: LessonKind;
  /** Its place on the path among the lessons of a folder, as its file says. */
  order: number;
  icon: string;
  label: Texts;
  help: Texts;
  /** The mission that it begins with. */
  start: string;
  teacher: TeacherPage | null;
  /** Whether it can be begun; `problems` say why not. */
  usable: boolean;
  problems: readonly Problem[];
  /** How much it is, or how far a person is in it, in words. */
  far: () => string;
  begin: () => void;
}

const EXAMPLE = "example:";

/** The lessons that come along, then those of the folder; both in their order. */
export function inOrder(lessons: readonly Lesson[]): Lesson[] {
  const own = ({ name }: Lesson) => (name.startsWith(EXAMPLE) ? 0 : 1);
  return [...lessons].sort((a, b) => own(a) - own(b) || a.order - b.order || (a.name < b.name ? -1 : 1));
}

/** Where the path goes on after a lesson ("" its beginning): the next that is not learned, else one before; null for none. */
export function nextLesson(path: readonly Lesson[], learned: readonly string[], after: string): Lesson | null {
  const at = path.findIndex(({ name }) => name === after);
  const onward = [...path.slice(at + 1), ...path.slice(0, Math.max(at, 0))];
  return onward.find(({ name, usable }) => usable && !learned.includes(name)) ?? null;
}

/** The names that were remembered, as far as they make sense. */
export function readLearned(text: string | null): string[] {
  const found = parseStored(text);
  return Array.isArray(found) ? found.filter((one): one is string => typeof one === "string") : [];
}
