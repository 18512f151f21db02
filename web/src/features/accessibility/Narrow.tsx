/** On a phone: which room is open under the graph. What a narrow page looks like is in narrow.css. */
import { t } from "../../i18n/words";
import { type Panel, useLayout } from "../../session/layout";
import { toggleRoom, useMobileRoom } from "../../session/narrow";
import { enlargeStage, setBeside } from "../../session/stage";
import { Icon } from "../../theme";

const ROOMS: readonly [room: Panel, icon: string][] = [
  ["palette", "boxes"],
  ["inspector", "sliders-horizontal"],
  ["code", "file"],
  ["arena", "map"],
];

function open(room: Panel): void {
  const { folded, toggle } = useLayout.getState();
  // It may have been folded away on a wide page.
  if (folded[room]) toggle(room);
  enlargeStage(false);
  if (room !== "arena") setBeside(false);
  toggleRoom(room);
}

export function NarrowTabs() {
  const chosen = useMobileRoom(({ room }) => room);
  return (
    <nav className="narrow-tabs" aria-label={t("view.panels")}>
      {ROOMS.map(([room, icon]) => (
        <button
          key={room}
          type="button"
          data-testid={`room-${room}`}
          aria-pressed={chosen === room}
          onClick={() => open(room)}
        >
          <Icon name={icon} size={18} />
          {t(`view.${room}`)}
        </button>
      ))}
    </nav>
  );
}
