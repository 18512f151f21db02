/**
 * Words of the field for what the sheet of keys lists under a plain label, so that somebody who knows another program finds
 * it: by the key of what a row says, or by the name of a menu's entry.
 */
import type { Key } from "../i18n/words";

export const SEARCH_WORDS: Readonly<Record<string, Key>> = {
  "debug.toggle": "search.breakpoint",
  "help.keys-step": "search.step",
  "run.step-vertex": "search.step",
  "run.step-back": "search.back",
  "run.step-vertex-back": "search.back",
  "help.keys-run": "search.run",
  "help.keys-stop": "search.stop",
  "boards.run": "search.deploy",
  "boards.panel": "search.connect",
  "run.check": "search.verify",
  "arena.large": "search.stage",
  "arena.fit": "search.zoom",
  "graph.fit": "search.zoom",
  "graph.minimap": "search.minimap",
  "graph.follow": "search.follow",
  "harm.follow": "search.follow",
  "help.keys-outline": "search.structure",
  "help.keys-problem": "search.problems",
  "problems.fix": "search.quick-fix",
  "help.keys-note": "search.note",
  "own.key": "search.block",
  "world.open": "search.world",
  "team.open": "search.team",
  "help.keys-context": "search.menu",
  "help.keys-robot-menu": "search.menu",
  "help.keys-this": "search.keys",
  "run-save": "search.trace",
  "run-sweep": "search.faults",
  "view-live": "search.live",
  "view-simple": "search.simple",
  "view-light": "search.theme",
  "view-dark": "search.theme",
  "view-contrast": "search.theme",
  "view-system": "search.theme",
  "view-en": "search.language",
  "view-fr": "search.language",
  "view-ur": "search.language",
  "file-parts": "search.import",
  "file-download-lll": "search.source",
  "file-download-kri": "search.binary",
  "file-download-kra": "search.listing",
  "file-export-svg": "search.picture",
  "file-export-png": "search.picture",
};

/** What has neither a key nor a menu: its name, where it is, and the words that find it. */
export const ELSEWHERE: readonly { name: Key; says: Key; also: Key }[] = [
  { name: "debug.watch", says: "elsewhere.watch", also: "search.watch" },
  { name: "elsewhere.timeline-name", says: "elsewhere.timeline", also: "search.timeline" },
  { name: "help.keys-save", says: "elsewhere.merge", also: "search.merge" },
  { name: "elsewhere.gamepad-name", says: "elsewhere.gamepad", also: "search.gamepad" },
];
