/** The tabs above the parts: each leads to its place in the list, where nothing is ever closed. */
import { type RefObject, useEffect, useState } from "react";

import { t } from "../../i18n/words";
import { Tile } from "../../theme";
import { listen } from "../../ui/effects";
import type { Tab } from "./tree";

/** How far under the upper edge a section may begin to be the one in view. */
const NEAR = 24;

export const sectionId = (name: string): string => `parts-of-${name}`;

/** The name of the tab whose parts are at the upper edge of the list. */
function useInView(list: RefObject<HTMLElement | null>, tabs: readonly Tab[]): string {
  const [inView, setInView] = useState("");
  useEffect(() => {
    const box = list.current;
    if (box === null) return;
    const look = () => {
      const edge = box.getBoundingClientRect().top + NEAR;
      const sections = tabs.filter(({ name }) => {
        const section = document.getElementById(sectionId(name));
        return section !== null && section.getBoundingClientRect().top <= edge;
      });
      setInView((sections.at(-1) ?? tabs[0])?.name ?? "");
    };
    look();
    return listen(box, { scroll: look }, { passive: true });
  }, [list, tabs]);
  return inView;
}

interface TabsProps {
  tabs: readonly Tab[];
  list: RefObject<HTMLElement | null>;
  /** A tab was chosen: its first part has the keys next. */
  onChoose: (tab: Tab) => void;
}

export function PaletteTabs({ tabs, list, onChoose }: TabsProps) {
  const inView = useInView(list, tabs);
  return (
    <div className="palette-tabs rigid gap-xs" role="group" aria-label={t("parts.tabs")}>
      {tabs.map((tab) => (
        <button
          key={tab.name}
          type="button"
          className="palette-tab column slim gap-2xs hover justify-centre"
          data-testid={`palette-tab-${tab.name}`}
          aria-current={tab.name === inView}
          title={tab.label}
          onClick={() => {
            document.getElementById(sectionId(tab.name))?.scrollIntoView({ block: "start" });
            onChoose(tab);
          }}
        >
          <Tile icon={tab.icon} colour={tab.colour} size={22} />
          <span className="palette-tab-name">{tab.label}</span>
        </button>
      ))}
    </div>
  );
}
