/** Keys of the page itself: files, history, rooms, programs. */
import { useStudio } from "../model/studio";
import { goToProgram, moveActiveProgram } from "../session/actions";
import { show } from "../session/document";
import { STOP_KEY, stopEverything } from "../session/features";
import type { PageKey } from "../session/key-table";
import { save } from "../session/saving";
import { renameInTab } from "./tab-rename";

export const KEYS = {
  stop: { ...STOP_KEY, run: stopEverything },
  create: { chords: ["Ctrl+Alt+N"], says: "help.keys-new", typing: true, run: () => show("new") },
  open: { chords: ["Ctrl+O"], says: "help.keys-open", typing: true, run: () => show("open") },
  save: { chords: ["Ctrl+S"], says: "help.keys-save", typing: true, run: () => void save() },
  saveAs: { chords: ["Ctrl+Shift+S"], says: "help.keys-save-as", typing: true, run: () => show("save-as") },
  undo: { chords: ["Ctrl+Z"], says: "help.keys-undo", run: () => useStudio.getState().undo() },
  redo: { chords: ["Ctrl+Y", "Ctrl+Shift+Z"], says: "help.keys-redo", run: () => useStudio.getState().redo() },
  nextRoom: { chords: ["F7"], says: "help.keys-room", typing: true, run: () => goToRoom(1) },
  previousRoom: { chords: ["Shift+F7"], says: "help.keys-room", typing: true, run: () => goToRoom(-1) },
  nextProgram: { chords: ["Alt+PageDown"], says: "help.keys-program", typing: true, run: () => goToProgram(1) },
  previousProgram: { chords: ["Alt+PageUp"], says: "help.keys-program", typing: true, run: () => goToProgram(-1) },
  programLater: {
    chords: ["Alt+Shift+PageDown"],
    says: "help.keys-program-move",
    typing: true,
    run: () => moveActiveProgram(1),
  },
  programEarlier: {
    chords: ["Alt+Shift+PageUp"],
    says: "help.keys-program-move",
    typing: true,
    run: () => moveActiveProgram(-1),
  },
  rename: { chords: ["F2"], says: "help.keys-rename", run: () => renameInTab(useStudio.getState().activeProgram) },
  addProgram: {
    chords: ["Alt+N"],
    says: "tabs.add",
    typing: true,
    run: () => document.querySelector<HTMLElement>(".add-program button")?.click(),
  },
  shortcuts: { chords: ["?"], says: "help.keys-this", also: "search.keys", run: () => show("shortcuts") },
} satisfies Record<string, PageKey>;

/** F7 goes through the rooms of the page: menus, parts, programs, graph, inspector, code, arena, problems. */
const ROOMS = [
  ".menubar",
  ".toolbar",
  ".parts",
  ".tabs",
  ".canvas",
  ".side-inspector",
  ".side-code",
  ".side-arena",
  "footer.bottom-bar",
] as const;

const CAN_HAVE_FOCUS =
  "[tabindex='0'], a[href], button:not(:disabled):not([tabindex='-1']), input:not(:disabled), select, textarea, [contenteditable=true]";

/** What takes the focus in a room: its entry in the order of Tab, or itself. */
function entryOf(room: HTMLElement): HTMLElement | null {
  if (room.matches("[tabindex='0']")) return room;
  const marked = room.querySelector<HTMLElement>("[aria-selected='true'][tabindex='0'], [role=treeitem][tabindex='0']");
  return marked ?? room.querySelector<HTMLElement>(CAN_HAVE_FOCUS);
}

function goToRoom(by: 1 | -1): void {
  const there = ROOMS.flatMap((selector) => {
    const room = document.querySelector<HTMLElement>(selector);
    const entry = room === null || room.offsetParent === null ? null : entryOf(room);
    return room === null || entry === null ? [] : [{ room, entry }];
  });
  const at = there.findIndex(({ room }) => room.contains(document.activeElement));
  const next = at < 0 ? (by > 0 ? 0 : there.length - 1) : (at + by + there.length) % there.length;
  there[next]?.entry.focus();
}
