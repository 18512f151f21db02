/** The switches in the bar of a large arena: icon and word, icons alone where there is little room. */
import type { LucideIcon } from "lucide-react";
import ImageDown from "lucide-react/icons/image-down";
import Radar from "lucide-react/icons/radar";
import Radio from "lucide-react/icons/radio";
import Route from "lucide-react/icons/route";
import Navigation from "lucide-react/icons/navigation";
import Tag from "lucide-react/icons/tag";
import Volume2 from "lucide-react/icons/volume-2";

import { t } from "../../../i18n/words";
import { openKeep } from "./shown-menu";
import { flip, SHOWS, type Shows, useOn } from "./switches";

/** On a large arena nothing is said beside a robot: there is no tag to switch. */
const ICONS: Readonly<Partial<Record<Shows, LucideIcon>>> = {
  trails: Route,
  rays: Radar,
  ahead: Navigation,
  radio: Radio,
  names: Tag,
  sound: Volume2,
};

export function Switches() {
  const on = useOn();
  return (
    <span className="flex gap-s card-title" role="group" aria-label={t("arena.show")}>
      {SHOWS.map(({ id, label }) => {
        const Picture = ICONS[id];
        if (Picture === undefined) return null;
        return (
          <button
            key={id}
            type="button"
            className="stage-switch finger muted small-text inline-row nowrap gap-s hover justify-centre"
            data-testid={`show-${id}`}
            aria-pressed={on[id]}
            title={t(label)}
            onClick={() => flip(id)}
          >
            <Picture size={16} aria-hidden="true" />
            <span>{t(label)}</span>
          </button>
        );
      })}
      <button
        type="button"
        className="stage-switch finger small-text inline-row nowrap gap-s hover justify-centre"
        data-testid="arena-keep"
        aria-haspopup="menu"
        title={t("arena.keep")}
        onClick={({ currentTarget }) => {
          const { left, bottom } = currentTarget.getBoundingClientRect();
          openKeep(left, bottom + 4);
        }}
      >
        <ImageDown size={16} aria-hidden="true" />
        <span>{t("arena.keep")}</span>
      </button>
    </span>
  );
}
