/**
 * The kit that somebody builds with who has no board at hand yet: the palette leaves out what the kit has nothing for.
 *
 * It is remembered in this browser, with what it lacks of each kind of robot, so that the palette asks nobody.
 */
import { create } from "zustand";

import type { KitEntry } from "../api/generated";
import type { Robot, RobotObject } from "../model/types";
import { parseStored, readStored, writeStored } from "../ui/browser-storage";

export type BuiltKit = Pick<KitEntry, "name" | "label" | "absent">;

const KEY = "kitrobot.kit";

function isText(value: unknown): value is string {
  return typeof value === "string";
}

function isTable(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The kit that was remembered; null for what is none. */
export function readKit(text: string | null): BuiltKit | null {
  const found = parseStored(text);
  if (!isTable(found)) return null;
  const { name, label, absent } = found;
  if (!isText(name) || !isTable(label) || !isTable(absent)) return null;
  const isPart = (part: unknown) => isTable(part) && isText(part["name"]) && isText(part["category"]);
  const parts = Object.values(absent).every((list) => Array.isArray(list) && list.every(isPart));
  if (!Object.values(label).every(isText) || !parts) return null;
  return { name, label: label as BuiltKit["label"], absent: absent as BuiltKit["absent"] };
}

export const useKit = create<{ kit: BuiltKit | null }>(() => ({ kit: readKit(readStored(KEY)) }));

/** From now on parts are those of this kit; null for those of the robot's own file. */
export function buildWith(kit: BuiltKit | null): void {
  useKit.setState({ kit: kit === null ? null : { name: kit.name, label: kit.label, absent: kit.absent } });
  writeStored(KEY, kit === null ? null : JSON.stringify(useKit.getState().kit));
}

export function isAbsent(kit: BuiltKit | null, robot: string, object: Pick<RobotObject, "category" | "name">): boolean {
  return (
    kit?.absent[robot]?.some(({ category, name }) => category === object.category && name === object.name) === true
  );
}

/** The robot that a kit can be most of: with the fewest parts that it lacks, of equals the one that it is now, then the richest. */
export function suitedRobot(kit: BuiltKit, robots: readonly Robot[], now: string): string {
  const known = robots.filter(({ name }) => kit.absent[name] !== undefined);
  const lacking = ({ name }: Robot) => kit.absent[name]?.length ?? 0;
  const isNow = ({ name }: Robot) => (name === now ? 1 : 0);
  const [best] = [...known].sort(
    (a, b) => lacking(a) - lacking(b) || isNow(b) - isNow(a) || b.objects.length - a.objects.length,
  );
  return best?.name ?? now;
}
