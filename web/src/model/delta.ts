/**
 * The difference between two values of plain data, small where little changed, and its way back: `patch(a, delta(a, b))`
 * equals `b`.
 *
 * null: equal. `v`: put this in its place. `o`: these fields changed. `e`: these elements of an array changed. `s`: of an
 * array, so many elements at a place gave way to others. What is shared (`===`) is not looked at. A delta that does not
 * fit what it is put on throws a `DeltaError`.
 */
export type Plain = null | boolean | number | string | readonly Plain[] | { readonly [name: string]: Plain };
export type Delta =
  | null
  | { v: Plain }
  | { o: Record<string, Delta> }
  | { e: [at: number, delta: Delta][] }
  | { s: [at: number, removed: number, inserted: readonly Plain[]] };

type Fields = Readonly<Record<string, Plain>>;

export class DeltaError extends Error {}

function isList(value: Plain): value is readonly Plain[] {
  return Array.isArray(value);
}

function isFields(value: Plain): value is Fields {
  return typeof value === "object" && value !== null && !isList(value);
}

function equal(one: Plain, other: Plain): boolean {
  if (one === other) return true;
  if (isList(one)) {
    return isList(other) && one.length === other.length && one.every((item, at) => equal(item, other[at] ?? null));
  }
  if (!isFields(one) || !isFields(other) || !sameNames(one, other)) return false;
  return Object.keys(one).every((name) => equal(one[name] ?? null, other[name] ?? null));
}

/** The same names in the same order: files are written in that order. */
function sameNames(one: Fields, other: Fields): boolean {
  const names = Object.keys(one);
  const others = Object.keys(other);
  return names.length === others.length && names.every((name, at) => name === others[at]);
}

/** What makes `after` of `before`. */
export function delta(before: Plain, after: Plain): Delta {
  if (before === after) return null;
  if (isList(before) && isList(after)) return listDelta(before, after);
  if (isFields(before) && isFields(after) && sameNames(before, after)) {
    const o: Record<string, Delta> = {};
    for (const name of Object.keys(after)) {
      const inner = delta(before[name] ?? null, after[name] ?? null);
      if (inner !== null) o[name] = inner;
    }
    return Object.keys(o).length === 0 ? null : { o };
  }
  return equal(before, after) ? null : { v: after };
}

function listDelta(before: readonly Plain[], after: readonly Plain[]): Delta {
  const shorter = Math.min(before.length, after.length);
  let start = 0;
  while (start < shorter && equal(before[start] ?? null, after[start] ?? null)) start++;
  if (start === before.length && start === after.length) return null;
  let tail = 0;
  while (tail < shorter - start && equal(before.at(-1 - tail) ?? null, after.at(-1 - tail) ?? null)) tail++;
  if (before.length !== after.length) {
    return { s: [start, before.length - start - tail, after.slice(start, after.length - tail)] };
  }
  const e: [number, Delta][] = [];
  for (let at = start; at < after.length - tail; at++) {
    const inner = delta(before[at] ?? null, after[at] ?? null);
    if (inner !== null) e.push([at, inner]);
  }
  return { e };
}

/** `before` with a delta put on it. */
export function patch(before: Plain, change: Delta): Plain {
  if (change === null) return before;
  if ("v" in change) return change.v;
  if ("o" in change) {
    if (!isFields(before)) throw new DeltaError("expected fields");
    const after: Record<string, Plain> = { ...before };
    for (const [name, inner] of Object.entries(change.o)) {
      if (!Object.hasOwn(before, name)) throw new DeltaError(`no field ${name}`);
      after[name] = patch(before[name] ?? null, inner);
    }
    return after;
  }
  if (!isList(before)) throw new DeltaError("expected a list");
  const after = [...before];
  if ("e" in change) {
    for (const [at, inner] of change.e) {
      if (!(at in after)) throw new DeltaError(`no element ${String(at)}`);
      after[at] = patch(after[at] ?? null, inner);
    }
    return after;
  }
  const [at, removed, inserted] = change.s;
  if (at < 0 || removed < 0 || at + removed > after.length) throw new DeltaError("no such stretch");
  after.splice(at, removed, ...inserted);
  return after;
}
