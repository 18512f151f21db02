/** Names that nothing has yet. */

/** The first name that is free: `name` gives the one with a number. */
export function firstFree(name: (number: number) => string, isTaken: (name: string) => boolean, first = 1): string {
  let number = first;
  while (isTaken(name(number))) number++;
  return name(number);
}

/** The stem, or else `stem-2`, `stem-3`, …: the first that is not taken. */
export function freeStem(stem: string, isTaken: (name: string) => boolean): string {
  return firstFree((number) => (number === 1 ? stem : `${stem}-${String(number)}`), isTaken);
}

/** `stem-1`, `stem-2`, …: the first that is not taken. */
export function freeName(stem: string, taken: readonly string[]): string {
  return firstFree(
    (number) => `${stem}-${String(number)}`,
    (name) => taken.includes(name),
  );
}
