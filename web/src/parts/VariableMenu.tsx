/** The menu of a variable in the palette: by the right button, the menu key, or a finger that rests. */
import { useEffect, useLayoutEffect, useRef, useState } from "react";

import { Menu } from "../shell/Menu";
import type { MenuEntry } from "../shell/menu-model";
import { t } from "../words/words";
import { editVariable, newVariable, renameVariable, takeAway, useVariables } from "./variables";

const EDGE = 8;

export function VariableMenu() {
  const menu = useVariables((state) => state.menu);
  if (menu === null) return null;
  return <Open key={`${menu.name} ${String(menu.y)}`} {...menu} />;
}

function Open({ robot, name, x, y }: { robot: string; name: string; x: number; y: number }) {
  const root = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState({ x, y });
  const close = () => useVariables.setState({ menu: null });
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
      close();
    };
    document.addEventListener("pointerdown", outside, true);
    window.addEventListener("blur", outside);
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      window.removeEventListener("blur", outside);
    };
  }, []);
  const of = { robot, name };
  const entries: MenuEntry[] = [
    { kind: "item", id: "variable-rename", label: t("variable.rename"), keys: "F2", run: () => renameVariable(of) },
    { kind: "item", id: "variable-edit", label: t("variable.edit"), run: () => editVariable(of) },
    { kind: "item", id: "variable-remove", label: t("variable.remove"), keys: "Del", run: () => takeAway(of) },
    { kind: "line", id: "variable-1" },
    { kind: "item", id: "variable-new", label: t("variable.new-dots"), run: () => newVariable() },
  ];
  return (
    <div
      ref={root}
      className="context-menu"
      data-testid="variable-menu"
      style={{ transform: `translate(${String(place.x)}px, ${String(place.y)}px)` }}
      onContextMenu={(event) => event.preventDefault()}
    >
      <Menu
        id="variable-menu-list"
        label={t("variable.menu", { name })}
        entries={entries}
        onClose={() => {
          close();
          document.querySelector<HTMLElement>(`[data-row="${CSS.escape(`object variable ${name}`)}"]`)?.focus();
        }}
      />
    </div>
  );
}
