/** On a phone: which room is open under the graph. What a narrow page looks like is in narrow.css. */
import "./narrow.css";
import { create } from "zustand";

import { type Panel, useLayout } from "../shell/layout";
import { Icon } from "../theme";
import { t } from "../words/words";

const ROOMS: readonly [room: Panel, icon: string][] = [
  ["palette", "boxes"],
  ["inspector", "sliders-horizontal"],
  ["code", "file"],
  ["arena", "map"],
];

/** The room that is open, or null for the graph alone. */
export const useNarrow = create<{ room: Panel | null }>(() => ({ room: null }));

function open(room: Panel): void {
  const { folded, toggle } = useLayout.getState();
  // A panel that was folded away on a wide page is wanted now.
  if (folded[room]) toggle(room);
  useNarrow.setState(({ room: before }) => ({ room: before === room ? null : room }));
}

export function NarrowTabs() {
  const chosen = useNarrow(({ room }) => room);
  return (
    <nav className="narrow-tabs" aria-label={t("view.panels")}>
      {ROOMS.map(([room, icon]) => (
        <button
          key={room}
          type="button"
          data-testid={`room-${room}`}
          aria-pressed={chosen === room}
          onClick={() => {
            open(room);
          }}
        >
          <Icon name={icon} size={18} />
          {t(`view.${room}`)}
        </button>
      ))}
    </nav>
  );
}
