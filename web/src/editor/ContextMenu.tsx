/** The open menu of the canvas, kept inside the window. */
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { createPortal } from "react-dom";

import type { Point } from "../model/layout";
import { Menu } from "../shell/Menu";
import { t } from "../words/words";
import { contextEntries } from "./context-entries";
import { useView } from "./view";

const EDGE = 8;

export function ContextMenu() {
  const at = useView((state) => state.menu);
  // Within the main landmark, but outside of the canvas, whose keys and gestures are not the menu's.
  const place = document.querySelector("main") ?? document.body;
  return at === null ? null : createPortal(<Open key={`${String(at.x)} ${String(at.y)}`} at={at} />, place);
}

function Open({ at }: { at: Point }) {
  const root = useRef<HTMLDivElement>(null);
  const [entries] = useState(contextEntries);
  const [place, setPlace] = useState(at);

  useLayoutEffect(() => {
    const box = root.current?.querySelector("[role=menu]")?.getBoundingClientRect();
    if (box === undefined) return;
    setPlace({
      x: Math.max(EDGE, Math.min(at.x, window.innerWidth - EDGE - box.width)),
      y: Math.max(EDGE, Math.min(at.y, window.innerHeight - EDGE - box.height)),
    });
  }, [at]);

  useEffect(() => {
    const outside = (event: Event) => {
      if (event.target instanceof Node && root.current?.contains(event.target) === true) return;
      useView.setState({ menu: null });
    };
    document.addEventListener("pointerdown", outside, true);
    document.addEventListener("wheel", outside, true);
    window.addEventListener("blur", outside);
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      document.removeEventListener("wheel", outside, true);
      window.removeEventListener("blur", outside);
    };
  }, []);

  return (
    <div
      ref={root}
      className="context-menu"
      data-testid="context-menu"
      // A place of the window, whichever way the page is read.
      style={{ transform: `translate(${String(place.x)}px, ${String(place.y)}px)` }}
      onContextMenu={(event) => {
        event.preventDefault();
      }}
    >
      <Menu
        id="context-menu-list"
        label={t("context.title")}
        entries={entries}
        onClose={() => {
          useView.setState({ menu: null });
          useView.getState().viewport?.focus();
        }}
      />
    </div>
  );
}
