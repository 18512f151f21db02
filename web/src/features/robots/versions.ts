/** Versions of MicroPython, as "1.20". */

/** Whether a version is older than the least one, by as many numbers as that has. */
export function isOlder(version: string, least: string): boolean {
  const has = version.split(".").map(Number);
  const wanted = least.split(".").map(Number).slice(0, 2);
  for (const [at, number] of wanted.entries()) {
    const mine = has[at] ?? 0;
    if (mine !== number) return mine < number;
  }
  return false;
}
