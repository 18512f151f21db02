/**
 * A menu that opens where it was asked for: under the pointer, the finger that rests, or the thing that has the focus. Kept
 * inside the window; closed by whatever happens outside of it.
 *
 * It stands in the main landmark but outside of whatever it is about, whose keys and gestures are not the menu's.
 */
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { createPortal } from "react-dom";

import { endAll, listen } from "./effects";
import { Menu } from "./Menu";
import type { MenuEntry } from "./menu-model";

const EDGE = 8;

interface FloatingMenuProps {
  /** Names its element, `ID-menu`, and its list. */
  id: string;
  label: string;
  at: { x: number; y: number };
  entries: readonly MenuEntry[];
  /** Something happened elsewhere: the menu goes, the focus stays where it is. */
  onLeave: () => void;
  /** It was used or given up: the menu goes, the focus back. */
  onClose: () => void;
}

export function FloatingMenu(props: FloatingMenuProps) {
  return createPortal(<Open {...props} />, document.querySelector("main") ?? document.body);
}

function Open({ id, label, at: { x, y }, entries, onLeave, onClose }: FloatingMenuProps) {
  const root = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState({ x, y });
  const leave = useRef(onLeave);
  useEffect(() => {
    leave.current = onLeave;
  });

  useLayoutEffect(() => {
    const box = root.current?.querySelector("[role=menu]")?.getBoundingClientRect();
    if (box === undefined) return;
    setPlace({
      x: Math.max(EDGE, Math.min(x, window.innerWidth - EDGE - box.width)),
      y: Math.max(EDGE, Math.min(y, window.innerHeight - EDGE - box.height)),
    });
  }, [x, y]);

  useEffect(() => {
    const outside = (event: Event) => {
      if (event.target instanceof Node && root.current?.contains(event.target) === true) return;
      leave.current();
    };
    return endAll(
      listen(document, { pointerdown: outside, wheel: outside }, { capture: true }),
      listen(window, { blur: outside }),
    );
  }, []);

  return (
    <div
      ref={root}
      className="context-menu"
      data-testid={`${id}-menu`}
      // A place of the window, whichever way the page is read.
      style={{ transform: `translate(${String(place.x)}px, ${String(place.y)}px)` }}
      onContextMenu={(event) => event.preventDefault()}
    >
      <Menu id={`${id}-menu-list`} label={label} entries={[...entries]} onClose={onClose} />
    </div>
  );
}
