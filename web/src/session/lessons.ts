/**
 * The path to learn: the lessons of all features in one order, which of them are learned in this browser, and the one that
 * is open. Left to features: what a lesson is, when it is learned, and opening it.
 */
import { create } from "zustand";

import { features } from "./features";
import { inOrder, type Lesson, type LessonKind, nextLesson, readLearned } from "./lesson";
import { readStored, writeStored } from "../ui/browser-storage";

const KEY = "kitrobot.learned";

/** A lesson that is open, and whether all of it is done now. */
interface OpenLesson {
  name: string;
  done: boolean;
}

interface Lessons {
  /** All of them; null until they were asked for. */
  path: readonly Lesson[] | null;
  learned: readonly string[];
  open: Readonly<Record<LessonKind, OpenLesson | null>>;
}

export const useLessons = create<Lessons>(() => ({
  path: null,
  learned: readLearned(readStored(KEY)),
  open: { tutorial: null, exercise: null },
}));

const set = useLessons.setState;

/** Asks the features for their lessons; a folder may have got another one. */
export async function lookForLessons(): Promise<void> {
  const found = await Promise.all(features().map(async ({ lessons }) => (await lessons?.()) ?? []));
  set({ path: inOrder(found.flat()) });
}

/** The lesson of a kind that is open; null for none. What is done once is learned for good. */
export function setOpenLesson(kind: LessonKind, lesson: OpenLesson | null): void {
  const { open, learned } = useLessons.getState();
  const before = open[kind];
  if (before?.name === lesson?.name && before?.done === lesson?.done) return;
  const isNew = lesson?.done === true && !learned.includes(lesson.name);
  set({ open: { ...open, [kind]: lesson }, ...(isNew ? { learned: [...learned, lesson.name] } : {}) });
  if (isNew) writeStored(KEY, JSON.stringify(useLessons.getState().learned));
}

/** The lesson that is open, of whatever kind. */
export function openLesson({ open }: Pick<Lessons, "open">): OpenLesson | null {
  return open.exercise ?? open.tutorial;
}

/** Where the path goes on from the lesson that is open, once that is done; null before. */
export function nextOfOpen(lessons: Lessons): Lesson | null {
  const open = openLesson(lessons);
  return open?.done === true ? nextLesson(lessons.path ?? [], lessons.learned, open.name) : null;
}
