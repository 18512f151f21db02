/** The "+" after the tabs: a new program, for one of the robots that there are. */
import { useEffect, useRef, useState } from "react";

import { mirrored } from "../i18n/language";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import { text } from "../model/texts";
import { addProgramFor } from "../session/actions";
import { complain } from "../session/document";
import { Menu } from "../ui/Menu";
import { type MenuEntry, menuItem } from "../ui/menu-model";
import { Tool } from "../ui/Tool";

/** The robots as entries of a menu. */
export function robotEntries(robots: readonly { name: string; label: Record<string, string> }[]): MenuEntry[] {
  const kinds = robots.filter(({ name }) => name !== TEAM_ROBOT);
  return kinds.map(({ name, label }) => menuItem(`add-${name}`, text(label, name), null, () => addProgramFor(name)));
}

/** A program of the whole team; where there is one, of a group. */
function teamEntry(social: boolean): MenuEntry {
  const add = (what: "startTeam" | "addGroupProgram") => () => {
    import("../session/first-team").then((team) => team[what]()).catch(complain);
  };
  return social
    ? menuItem("add-group-program", t("first-team.group"), null, add("addGroupProgram"))
    : menuItem("add-team-program", t("first-team.social"), null, add("startTeam"));
}

export function AddProgram() {
  const social = useStudio((studio) => studio.mission.programs.some((one) => one.level === "social"));
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
      <Tool
        icon="plus"
        ref={button}
        label={t("tabs.add")}
        testId="add-program"
        aria-haspopup="menu"
        aria-expanded={place !== null}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setPlace(place === null ? { left: mirrored() ? box.right : box.left, top: box.bottom + 4 } : null);
        }}
      />
      {place === null ? null : (
        <div className="menu-anchor" style={place}>
          <Menu
            id="add-program-menu"
            label={t("program.add")}
            entries={[
              { kind: "heading", id: "for", label: t("program.add") },
              ...robotEntries(robots),
              { kind: "line", id: "team" },
              teamEntry(social),
            ]}
            onClose={close}
          />
        </div>
      )}
    </div>
  );
}
