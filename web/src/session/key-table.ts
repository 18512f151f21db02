/**
 * Every key of the studio, once: what is pressed, where it holds and what it means. The handlers look their keys up here,
 * the menus write them beside their entries, and the sheet of shortcuts is made of nothing else.
 */
import type { Key } from "../i18n/words";

export interface KeyRow {
  /** As they are written: "Ctrl+Shift+S". The first one stands in menus. */
  chords: readonly string[];
  says: Key;
  /** Also while a field has the focus. */
  typing?: boolean;
}

type Rows = Record<string, KeyRow>;

/** Keys that hold everywhere on the page. */
export const PAGE_KEYS = {
  run: { chords: ["F5"], says: "help.keys-run", typing: true },
  pause: { chords: ["F6"], says: "help.keys-pause", typing: true },
  step: { chords: ["F10"], says: "help.keys-step", typing: true },
  stepBack: { chords: ["F9"], says: "run.step-back", typing: true },
  stepVertex: { chords: ["Ctrl+F10"], says: "run.step-vertex", typing: true },
  stepVertexBack: { chords: ["Ctrl+F9"], says: "run.step-vertex-back", typing: true },
  stop: { chords: ["Shift+F5"], says: "help.keys-stop", typing: true },
  runOnRobot: { chords: ["Ctrl+F5"], says: "boards.run", typing: true },
  slower: { chords: [","], says: "run.slower" },
  faster: { chords: ["."], says: "run.faster" },
  create: { chords: ["Ctrl+Alt+N"], says: "help.keys-new", typing: true },
  open: { chords: ["Ctrl+O"], says: "help.keys-open", typing: true },
  learn: { chords: ["Alt+L"], says: "learn.open", typing: true },
  save: { chords: ["Ctrl+S"], says: "help.keys-save", typing: true },
  saveAs: { chords: ["Ctrl+Shift+S"], says: "help.keys-save-as", typing: true },
  print: { chords: ["Ctrl+P"], says: "out.print", typing: true },
  undo: { chords: ["Ctrl+Z"], says: "help.keys-undo" },
  redo: { chords: ["Ctrl+Y", "Ctrl+Shift+Z"], says: "help.keys-redo" },
  find: { chords: ["Ctrl+F"], says: "help.keys-find", typing: true },
  nextProblem: { chords: ["F8"], says: "help.keys-problem", typing: true },
  previousProblem: { chords: ["Shift+F8"], says: "help.keys-problem", typing: true },
  fix: { chords: ["Ctrl+."], says: "problems.fix", typing: true },
  nextRoom: { chords: ["F7"], says: "help.keys-room", typing: true },
  previousRoom: { chords: ["Shift+F7"], says: "help.keys-room", typing: true },
  nextProgram: { chords: ["Alt+PageDown"], says: "help.keys-program", typing: true },
  previousProgram: { chords: ["Alt+PageUp"], says: "help.keys-program", typing: true },
  programLater: { chords: ["Alt+Shift+PageDown"], says: "help.keys-program-move", typing: true },
  programEarlier: { chords: ["Alt+Shift+PageUp"], says: "help.keys-program-move", typing: true },
  rename: { chords: ["F2"], says: "help.keys-rename" },
  addProgram: { chords: ["Alt+N"], says: "tabs.add", typing: true },
  team: { chords: ["Alt+T"], says: "team.open", typing: true },
  world: { chords: ["Alt+W"], says: "world.open", typing: true },
  robots: { chords: ["Alt+R"], says: "boards.panel", typing: true },
  variable: { chords: ["Alt+V"], says: "variable.new", typing: true },
  check: { chords: ["Alt+C"], says: "run.check", typing: true },
  stage: { chords: ["F"], says: "arena.large" },
  outline: { chords: ["F4"], says: "help.keys-outline", typing: true },
  part: { chords: ["F1"], says: "help.keys-part", typing: true },
  shortcuts: { chords: ["?"], says: "help.keys-this" },
} as const satisfies Rows;

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
  note: { chords: ["N"], says: "help.keys-note" },
  earlier: { chords: ["Alt+↑"], says: "help.keys-move" },
  later: { chords: ["Alt+↓"], says: "help.keys-move" },
  remove: { chords: ["Delete", "Backspace"], says: "help.keys-delete" },
  duplicate: { chords: ["Ctrl+D"], says: "help.keys-duplicate" },
  wrap: { chords: ["W"], says: "help.keys-wrap" },
  unwrap: { chords: ["Shift+W"], says: "help.keys-wrap" },
  fold: { chords: ["C"], says: "help.keys-fold" },
  savePart: { chords: ["P"], says: "own.key" },
  breakpoint: { chords: ["B"], says: "debug.toggle" },
  menu: { chords: ["Shift+F10", "ContextMenu"], says: "help.keys-context" },
  zoomSelection: { chords: ["Z"], says: "graph.zoom-selection" },
  fit: { chords: ["Shift+Z"], says: "graph.fit" },
  zoomIn: { chords: ["+", "="], says: "help.keys-zoom" },
  zoomOut: { chords: ["-"], says: "help.keys-zoom" },
  home: { chords: ["Ctrl+0"], says: "help.keys-zoom" },
  minimap: { chords: ["M"], says: "graph.minimap" },
  follow: { chords: ["Shift+F"], says: "graph.follow" },
  nothing: { chords: ["Escape"], says: "help.keys-nothing" },
} as const satisfies Rows;

/** Keys of the arena, while it has the focus. */
export const ARENA_KEYS = {
  left: { chords: ["←"], says: "help.keys-pan" },
  right: { chords: ["→"], says: "help.keys-pan" },
  up: { chords: ["↑"], says: "help.keys-pan" },
  down: { chords: ["↓"], says: "help.keys-pan" },
  zoomIn: { chords: ["+", "="], says: "help.keys-zoom" },
  zoomOut: { chords: ["-"], says: "help.keys-zoom" },
  fit: { chords: ["0"], says: "arena.fit" },
  next: { chords: ["N"], says: "help.keys-robot" },
  previous: { chords: ["Shift+N"], says: "help.keys-robot" },
  menu: { chords: ["Enter", "Shift+F10", "ContextMenu"], says: "help.keys-robot-menu" },
  follow: { chords: ["Shift+F"], says: "harm.follow" },
  hand: { chords: ["A", "B", "S"], says: "help.keys-hand" },
  take: { chords: ["M", "Shift+M"], says: "help.keys-take" },
} as const satisfies Rows;

/** Keys of the world while it is changed and its place has the focus. */
export const WORLD_KEYS = {
  left: { chords: ["←", "Shift+←"], says: "world.key-move" },
  right: { chords: ["→", "Shift+→"], says: "world.key-move" },
  up: { chords: ["↑", "Shift+↑"], says: "world.key-move" },
  down: { chords: ["↓", "Shift+↓"], says: "world.key-move" },
  next: { chords: ["N"], says: "world.key-walk" },
  previous: { chords: ["Shift+N"], says: "world.key-walk" },
  remove: { chords: ["Delete", "Backspace"], says: "help.keys-delete" },
  duplicate: { chords: ["Ctrl+D"], says: "help.keys-duplicate" },
  all: { chords: ["Ctrl+A"], says: "help.keys-all" },
  stop: { chords: ["Escape"], says: "help.keys-nothing" },
  zoomIn: { chords: ["+", "="], says: "help.keys-zoom" },
  zoomOut: { chords: ["-"], says: "help.keys-zoom" },
  fit: { chords: ["0"], says: "arena.fit" },
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
  page: (id: keyof typeof PAGE_KEYS): string => PAGE_KEYS[id].chords[0],
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
