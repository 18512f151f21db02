/**
 * Keeps a second click from removing something: what removes (`data-removes`) may come to stand under a pointer that has just
 * pressed something else there, since a panel has moved or a question has appeared.
 *
 * Such a click on what removes does nothing when the click before it was on another control, at the same place, and the
 * pointer has not been elsewhere since. The next one does. Several rows are removed one after another without a pause.
 */
import { endAll, listen } from "./effects";

const NEAR_PX = 8;
const CONTROLS =
  "button, a, input, select, summary, label, [role=button], [role^=menuitem], [role=tab], [role=treeitem]";

interface Press {
  x: number;
  y: number;
  control: Element | null;
}

let before: Press | null = null;

function far({ clientX, clientY }: MouseEvent): boolean {
  return before === null || Math.hypot(clientX - before.x, clientY - before.y) > NEAR_PX;
}

function removes(control: Element | null): boolean {
  return control !== null && control.hasAttribute("data-removes");
}

function onMove(event: PointerEvent): void {
  if (far(event)) before = null;
}

function onClick(event: MouseEvent): void {
  // Keys press what has the focus.
  if (event.detail === 0) return;
  const control = event.target instanceof Element ? event.target.closest(CONTROLS) : null;
  const came = !far(event) && before?.control !== control && !removes(before?.control ?? null) && removes(control);
  before = { x: event.clientX, y: event.clientY, control };
  if (!came) return;
  event.preventDefault();
  event.stopPropagation();
}

/** Watches the clicks of the page; gives what ends it. */
export function guardRemoving(): () => void {
  const forget = () => {
    before = null;
  };
  return endAll(forget, listen(window, { pointermove: onMove, click: onClick }, { capture: true }));
}
