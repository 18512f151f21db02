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

export function goToRoom(by: 1 | -1): void {
  const there = ROOMS.flatMap((selector) => {
    const room = document.querySelector<HTMLElement>(selector);
    const entry = room === null || room.offsetParent === null ? null : entryOf(room);
    return room === null || entry === null ? [] : [{ room, entry }];
  });
  const at = there.findIndex(({ room }) => room.contains(document.activeElement));
  const next = at < 0 ? (by > 0 ? 0 : there.length - 1) : (at + by + there.length) % there.length;
  there[next]?.entry.focus();
}
