/** Versions of MicroPython, as "1.20", "1.24.1" or, before it was released, "1.25.0-preview". */

const NUMBERS = 3;

/** Its numbers, then whether it is a release and no preview of that. */
function orderOf(version: string): number[] {
  const [numbers = "", level] = version.split("-");
  const found = numbers.split(".").map(Number);
  return [...Array.from({ length: NUMBERS }, (_, at) => found[at] ?? 0), level === undefined ? 1 : 0];
}

/** Whether a version is older than the least one. */
export function isOlder(version: string, least: string): boolean {
  const has = orderOf(version);
  const wanted = orderOf(least);
  const at = wanted.findIndex((number, place) => number !== has[place]);
  return at >= 0 && (has[at] ?? 0) < (wanted[at] ?? 0);
}
