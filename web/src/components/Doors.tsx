/** Three ways to begin, at the top of each of them: learn on a path, make something new, look at what is there. */
import type { Key } from "../i18n/words";
import { t } from "../i18n/words";
import { type Overlay, show, useDocument } from "../session/document";
import { Icon } from "../theme";
import "./doors.css";

const DOORS: readonly { sheet: Exclude<Overlay, null>; icon: string; name: Key; help: Key }[] = [
  { sheet: "learn", icon: "graduation-cap", name: "door.learn", help: "door.learn-help" },
  { sheet: "new", icon: "pencil", name: "door.make", help: "door.make-help" },
  { sheet: "open", icon: "images", name: "door.look", help: "door.look-help" },
];

export function Doors() {
  const open = useDocument(({ overlay }) => overlay);
  return (
    <nav className="doors" aria-label={t("door.ways")}>
      {DOORS.map(({ sheet, icon, name, help }) => (
        <button
          key={sheet}
          type="button"
          className="door row"
          data-testid={`door-${sheet}`}
          aria-current={open === sheet ? "page" : undefined}
          onClick={() => show(sheet)}
        >
          <Icon name={icon} size={22} />
          <span>
            <strong>{t(name)}</strong>
            <small>{t(help)}</small>
          </span>
        </button>
      ))}
    </nav>
  );
}
