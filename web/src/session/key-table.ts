/**
 * What a key is: what is pressed and what it means. Each stands once, in a table: those of the page with the feature whose
 * they are (`keys` of `Feature`), those of the graph and of the browser here. The handlers look their keys up in these
 * tables, the menus write them beside their entries, and the sheet of shortcuts is made of nothing else.
 */
import type { Key } from "../i18n/words";

export interface KeyRow {
  /** As they are written: "Ctrl+Shift+S". The first one stands in menus. */
  chords: readonly string[];
  says: Key;
  /** Words of the field for it, so that somebody who knows another program finds it. */
  also?: Key;
  /** Also while a field has the focus. */
  typing?: boolean;
}

export type Rows = Record<string, KeyRow>;

/** A key that holds everywhere on the page, with what it does. */
export interface PageKey extends KeyRow {
  run: () => void;
}

/** Keys that hold while one place has the focus, under the name of the place. */
export interface KeyTable {
  heading: Key;
  rows: Rows;
}

/** Keys of the graph; those with Ctrl, and Delete, in the trees of the page too. */
export const GRAPH_KEYS = {
  add: { chords: ["/"], says: "help.keys-insert" },
  up: { chords: ["↑"], says: "help.keys-walk" },
  down: { chords: ["↓"], says: "help.keys-walk" },
  left: { chords: ["←"], says: "help.keys-walk" },
  right: { chords: ["→"], says: "help.keys-walk" },
  arc: { chords: ["A"], says: "help.keys-arc" },
  extendUp: { chords: ["Shift+↑"], says: "help.keys-extend" },
  extendDown: { chords: ["Shift+↓"], says: "help.keys-extend" },
  all: { chords: ["Ctrl+A"], says: "help.keys-all" },
  edit: { chords: ["Enter"], says: "help.keys-edit" },
  note: { chords: ["N"], says: "help.keys-note", also: "search.note" },
  earlier: { chords: ["Alt+↑"], says: "help.keys-move" },
  later: { chords: ["Alt+↓"], says: "help.keys-move" },
  remove: { chords: ["Delete", "Backspace"], says: "help.keys-delete" },
  duplicate: { chords: ["Ctrl+D"], says: "help.keys-duplicate" },
  wrap: { chords: ["W"], says: "help.keys-wrap" },
  unwrap: { chords: ["Shift+W"], says: "help.keys-wrap" },
  fold: { chords: ["C"], says: "help.keys-fold" },
  savePart: { chords: ["P"], says: "own.key", also: "search.block" },
  vary: { chords: ["V"], says: "help.keys-vary", also: "search.experiment" },
  breakpoint: { chords: ["B"], says: "debug.toggle", also: "search.breakpoint" },
  menu: { chords: ["Shift+F10", "ContextMenu"], says: "help.keys-context", also: "search.menu" },
  zoomSelection: { chords: ["Z"], says: "graph.zoom-selection" },
  fit: { chords: ["Shift+Z"], says: "graph.fit", also: "search.zoom" },
  zoomIn: { chords: ["+", "="], says: "help.keys-zoom" },
  zoomOut: { chords: ["-"], says: "help.keys-zoom" },
  home: { chords: ["Ctrl+0"], says: "help.keys-zoom" },
  minimap: { chords: ["M"], says: "graph.minimap", also: "search.minimap" },
  follow: { chords: ["Shift+F"], says: "graph.follow", also: "search.follow" },
  nothing: { chords: ["Escape"], says: "help.keys-nothing" },
} as const satisfies Rows;

/** Keys that the browser or a pattern of the web brings: they need no handler here, but people want to know them. */
export const WEB_KEYS = {
  menus: { chords: ["Alt"], says: "help.keys-menu" },
  clipboard: { chords: ["Ctrl+X", "Ctrl+C", "Ctrl+V"], says: "help.keys-clipboard" },
  type: { chords: ["0…9"], says: "help.keys-type" },
  tabs: { chords: ["←", "→", "Home", "End"], says: "help.keys-tabs" },
  removeTab: { chords: ["Delete"], says: "help.keys-tab-delete" },
  tree: { chords: ["↑", "↓", "←", "→"], says: "help.keys-tree" },
  take: { chords: ["Enter"], says: "help.keys-tree-add" },
  lines: { chords: ["←", "→", "Home", "End"], says: "help.keys-lines" },
} as const satisfies Rows;

/** How a menu writes the key of what it does. */
export const keyFor = {
  page: ({ chords: [first = ""] }: KeyRow): string => first,
  graph: (id: keyof typeof GRAPH_KEYS): string => GRAPH_KEYS[id].chords[0],
  clipboard: (at: 0 | 1 | 2): string => WEB_KEYS.clipboard.chords[at],
};

const NAMED: Record<string, string> = { ArrowUp: "↑", ArrowDown: "↓", ArrowLeft: "←", ArrowRight: "→" };
/** Signs that stand on another key in another script's layout, by where they are on the usual one. */
const BY_PLACE: Record<string, [plain: string, shifted: string]> = {
  Slash: ["/", "?"],
  Comma: [",", ","],
  Period: [".", "."],
  Minus: ["-", "-"],
  Equal: ["=", "+"],
};

/** The letter or sign that is meant: on an Urdu or Greek keyboard it goes by the key's place. */
function signOf({ key, code, shiftKey }: KeyboardEvent): string {
  if (key.length !== 1 || /[!-~]/.test(key)) return key.length === 1 ? key.toUpperCase() : (NAMED[key] ?? key);
  const letter = /^(?:Key|Digit)(.)$/.exec(code)?.[1];
  return letter ?? BY_PLACE[code]?.[shiftKey ? 1 : 0] ?? key;
}

/** A key press as it is written in the table. Shift counts with letters and keys that have names, not with signs. */
export function chordOf(event: KeyboardEvent): string {
  const sign = signOf(event);
  const shift = event.shiftKey && (sign.length > 1 || /[A-Z↑↓←→]/.test(sign));
  const held = [event.ctrlKey || event.metaKey ? "Ctrl" : "", event.altKey ? "Alt" : "", shift ? "Shift" : ""];
  return [...held.filter((one) => one !== ""), sign].join("+");
}

/** Which row of a table a key press means, or null. */
export function keyIn<Id extends string>(rows: Record<Id, KeyRow>, event: KeyboardEvent): Id | null {
  const chord = chordOf(event);
  const found = (Object.keys(rows) as Id[]).find((id) => rows[id].chords.includes(chord));
  return found ?? null;
}
