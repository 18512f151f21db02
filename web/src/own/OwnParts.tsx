/** What lies over the page for parts of one's own: the open sheet, and the menu of a part in the palette. */
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { createPortal } from "react-dom";

import { complain } from "../shell/document";
import { later } from "../shell/later";
import { Menu } from "../shell/Menu";
import { t } from "../words/words";
import { shareParts } from "./share";
import { openDelete, openEdit, useOwn } from "./state";

const OwnSheets = later(() => import("./OwnSheets").then((chunk) => chunk.OwnSheets), complain);
const EDGE = 8;

export function OwnParts() {
  const sheet = useOwn((own) => own.sheet);
  const menu = useOwn((own) => own.menu);
  // Its menu stands within the main landmark, as the canvas's does.
  return (
    <>
      {sheet === null ? null : <OwnSheets sheet={sheet} />}
      {menu === null
        ? null
        : createPortal(
            <PartMenu key={menu.name} name={menu.name} x={menu.x} y={menu.y} />,
            document.querySelector("main") ?? document.body,
          )}
    </>
  );
}

function PartMenu({ name, x, y }: { name: string; x: number; y: number }) {
  const root = useRef<HTMLDivElement>(null);
  const [before] = useState(() => document.activeElement);
  const [place, setPlace] = useState({ x, y });

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
      useOwn.setState({ menu: null });
    };
    document.addEventListener("pointerdown", outside, true);
    document.addEventListener("wheel", outside, true);
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      document.removeEventListener("wheel", outside, true);
    };
  }, []);

  return (
    <div
      ref={root}
      className="context-menu"
      data-testid="own-menu"
      style={{ transform: `translate(${String(place.x)}px, ${String(place.y)}px)` }}
    >
      <Menu
        id="own-menu-list"
        label={t("own.menu", { name })}
        entries={[
          { kind: "item", id: "own-edit", label: t("own.edit"), keys: "F2", run: () => openEdit(name) },
          { kind: "item", id: "own-delete", label: t("own.delete"), keys: "Del", run: () => openDelete(name) },
          { kind: "line", id: "own-1" },
          { kind: "item", id: "own-share", label: t("own.share"), run: () => void shareParts() },
        ]}
        onClose={() => {
          useOwn.setState({ menu: null });
          if (before instanceof HTMLElement) before.focus();
        }}
      />
    </div>
  );
}
