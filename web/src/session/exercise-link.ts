/**
 * Links that open an exercise: `#exercise=NAME`, in a class also its name and its code, with which a new pupil joins
 * (`classroom/overview.py` writes those). What stands behind `#` is sent to no server.
 */
const LONGEST = 1000;

export interface ExerciseLink {
  exercise: string;
  /** The class that it is for, and its code; "" where the link does not say so. */
  className: string;
  code: string;
}

/** What the part of an address behind its `#` opens; null where that is no exercise. */
export function readExerciseLink(hash: string): ExerciseLink | null {
  const said = new URLSearchParams(hash.slice(0, 4 * LONGEST).replace(/^#/, ""));
  const exercise = said.get("exercise") ?? "";
  if (exercise === "" || exercise.length > LONGEST) return null;
  const code = (said.get("code") ?? "").toUpperCase().slice(0, 12);
  return { exercise, className: said.get("class") ?? "", code };
}

/** The address of a page with the exercise in it. */
export function addressOfExercise(page: string, exercise: string): string {
  const address = new URL(page);
  address.hash = `exercise=${encodeURIComponent(exercise)}`;
  return address.href;
}
