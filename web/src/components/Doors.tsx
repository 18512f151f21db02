/** Three ways to begin, at the top of each of them: learn on a path, make something new, look at what is there. */
import GraduationCap from "lucide-react/icons/graduation-cap";
import Images from "lucide-react/icons/images";
import Pencil from "lucide-react/icons/pencil";

import { type Key, t } from "../i18n/words";
import { type Overlay, show, useDocument } from "../session/document";
import "./doors.css";

const DOORS: readonly { sheet: Exclude<Overlay, null>; Sign: typeof Images; name: Key; help: Key }[] = [
  { sheet: "learn", Sign: GraduationCap, name: "door.learn", help: "door.learn-help" },
  { sheet: "new", Sign: Pencil, name: "door.make", help: "door.make-help" },
  { sheet: "open", Sign: Images, name: "door.look", help: "door.look-help" },
];

export function Doors() {
  const open = useDocument(({ overlay }) => overlay);
  return (
    <nav className="doors" aria-label={t("door.ways")}>
      {DOORS.map(({ sheet, Sign, name, help }) => (
        <button
          key={sheet}
          type="button"
          className="door row start-text hover framed"
          data-testid={`door-${sheet}`}
          aria-current={open === sheet ? "page" : undefined}
          onClick={() => show(sheet)}
        >
          <Sign size={22} aria-hidden="true" />
          <span>
            <strong>{t(name)}</strong>
            <small>{t(help)}</small>
          </span>
        </button>
      ))}
    </nav>
  );
}
