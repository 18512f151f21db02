/** Keys of the world while it is changed and its place has the focus. */
import type { Rows } from "../../session/key-table";

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
  fit: { chords: ["0"], says: "arena.fit", also: "search.zoom" },
} as const satisfies Rows;
