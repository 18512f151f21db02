/** What a menu is made of, without knowing how it is drawn. */
import type { ReactNode } from "react";

export interface MenuItem {
  kind: "item" | "radio" | "check";
  id: string;
  label: string;
  run: () => void;
  /** As it is written beside the label: "Ctrl+S". */
  keys?: string;
  disabled?: boolean;
  checked?: boolean;
  /** Before the label. */
  picture?: ReactNode;
}

export type MenuEntry = MenuItem | { kind: "line"; id: string } | { kind: "heading"; id: string; label: string };

/** An entry that does something; `keys` is null where no key does the same. */
export function menuItem(
  id: string,
  label: string,
  keys: string | null,
  run: () => unknown,
  disabled = false,
): MenuItem {
  return { kind: "item", id, label, ...(keys === null ? {} : { keys }), disabled, run: () => void run() };
}

/** An entry of which one of several is chosen. */
export function menuRadio(id: string, label: string, checked: boolean, run: () => unknown): MenuItem {
  return { kind: "radio", id, label, checked, run: () => void run() };
}

/** An entry that is on or off. */
export function menuCheck(
  id: string,
  label: string,
  checked: boolean,
  run: () => unknown,
  keys: string | null = null,
): MenuItem {
  return { ...menuItem(id, label, keys, run), kind: "check", checked };
}

export interface MenuPart {
  id: string;
  label: string;
  entries: MenuEntry[];
}

/** One menu in place of several, each under its name. */
export function menuInCommon(menus: readonly MenuPart[], label: string): MenuPart {
  const entries = menus.flatMap((menu): MenuEntry[] => [
    { kind: "heading", id: `${menu.id}-heading`, label: menu.label },
    ...menu.entries,
  ]);
  return { id: "more", label, entries };
}

export function isItem(entry: MenuEntry): entry is MenuItem {
  return entry.kind !== "line" && entry.kind !== "heading";
}

/** The item that the keyboard goes to from `from` (-1: before the first), skipping what cannot be chosen. */
export function stepItem(entries: readonly MenuEntry[], from: number, by: 1 | -1): number {
  const count = entries.length;
  for (let move = 1; move <= count; move++) {
    const at = ((((from < 0 && by < 0 ? count : from) + by * move) % count) + count) % count;
    const entry = entries[at];
    if (entry !== undefined && isItem(entry)) return at;
  }
  return -1;
}

/** The item that has the focus when the menu opens: the first that can be chosen. */
export function firstItem(entries: readonly MenuEntry[]): number {
  const found = entries.findIndex((entry) => isItem(entry) && entry.disabled !== true);
  return found < 0 ? stepItem(entries, -1, 1) : found;
}

/** The next item after `from` whose label begins with a letter. */
export function itemByLetter(entries: readonly MenuEntry[], from: number, letter: string): number {
  for (let move = 1; move <= entries.length; move++) {
    const at = (Math.max(from, -1) + move) % entries.length;
    const entry = entries[at];
    if (entry !== undefined && isItem(entry) && entry.label.toLowerCase().startsWith(letter.toLowerCase())) return at;
  }
  return -1;
}
