/** The "+" after the tabs: a new program, for one of the robots that there are. */
import { useEffect, useRef, useState } from "react";

import { useStudio } from "../model/studio";
import { text } from "../model/texts";
import { Icon } from "../theme";
import { mirrored } from "../words/language";
import { t } from "../words/words";
import { addProgramFor } from "./actions";
import { Menu } from "./Menu";
import type { MenuEntry } from "./menu-model";

/** The robots as entries of a menu. */
export function robotEntries(robots: readonly { name: string; label: Record<string, string> }[]): MenuEntry[] {
  return robots.map(({ name, label }) => ({
    kind: "item",
    id: `add-${name}`,
    label: text(label, name),
    run: () => addProgramFor(name),
  }));
}

export function AddProgram() {
  const robots = useStudio((studio) => studio.catalogue.robots);
  const [place, setPlace] = useState<{ left: number; top: number } | null>(null);
  const root = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);

  useEffect(() => {
    if (place === null) return;
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && root.current?.contains(event.target) === true) return;
      setPlace(null);
    };
    document.addEventListener("pointerdown", outside, true);
    return () => document.removeEventListener("pointerdown", outside, true);
  }, [place]);

  if (robots.length === 0) return null;
  const close = () => {
    setPlace(null);
    button.current?.focus();
  };
  return (
    <div className="add-program" ref={root}>
      <button
        type="button"
        className="tool"
        ref={button}
        data-testid="add-program"
        aria-label={t("tabs.add")}
        title={t("tabs.add")}
        aria-haspopup="menu"
        aria-expanded={place !== null}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setPlace(place === null ? { left: mirrored() ? box.right : box.left, top: box.bottom + 4 } : null);
        }}
      >
        <Icon name="plus" size={18} />
      </button>
      {place === null ? null : (
        <div className="menu-anchor" style={place}>
          <Menu
            id="add-program-menu"
            label={t("program.add")}
            entries={[{ kind: "heading", id: "for", label: t("program.add") }, ...robotEntries(robots)]}
            onClose={close}
          />
        </div>
      )}
    </div>
  );
}
