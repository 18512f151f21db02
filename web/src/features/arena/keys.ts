/** Keys of the arena: the one that makes it the stage, and those that it has while it has the focus. */
import type { PageKey, Rows } from "../../session/key-table";
import { toggleStage } from "./parts";

export const PAGE_KEYS = {
  stage: { chords: ["F"], says: "arena.large", also: "search.stage", run: toggleStage },
} satisfies Record<string, PageKey>;

export const ARENA_KEYS = {
  left: { chords: ["←"], says: "help.keys-pan" },
  right: { chords: ["→"], says: "help.keys-pan" },
  up: { chords: ["↑"], says: "help.keys-pan" },
  down: { chords: ["↓"], says: "help.keys-pan" },
  zoomIn: { chords: ["+", "="], says: "help.keys-zoom" },
  zoomOut: { chords: ["-"], says: "help.keys-zoom" },
  fit: { chords: ["0"], says: "arena.fit", also: "search.zoom" },
  next: { chords: ["N"], says: "help.keys-robot" },
  previous: { chords: ["Shift+N"], says: "help.keys-robot" },
  menu: { chords: ["Enter", "Shift+F10", "ContextMenu"], says: "help.keys-robot-menu", also: "search.menu" },
  follow: { chords: ["Shift+F"], says: "harm.follow", also: "search.follow" },
  hand: { chords: ["A", "B", "S"], says: "help.keys-hand" },
  take: { chords: ["M", "Shift+M"], says: "help.keys-take" },
} as const satisfies Rows;
