/**
 * The sheet of shortcuts: every row of the table of keys, and for what has no key of its own the way through the menus.
 * Nothing is listed here by hand.
 */
import { type Key, t } from "../i18n/words";
import { closeOverlay } from "../session/document";
import { ARENA_KEYS, GRAPH_KEYS, type KeyRow, PAGE_KEYS, WEB_KEYS, WORLD_KEYS } from "../session/key-table";
import { isItem, type MenuPart } from "../ui/menu-model";
import { Sheet } from "../ui/Sheet";
import { useMenus } from "./menus";

const TABLES: readonly [Key, Record<string, KeyRow>][] = [
  ["help.general", PAGE_KEYS],
  ["app.canvas", GRAPH_KEYS],
  ["view.arena", ARENA_KEYS],
  ["world.tab", WORLD_KEYS],
  ["help.keys-lists", WEB_KEYS],
];

/** Rows with one meaning are one line: "W · Shift+W". */
export function linesOf(rows: Record<string, KeyRow>): { says: Key; chords: string[] }[] {
  const lines = new Map<Key, string[]>();
  for (const { says, chords } of Object.values(rows)) lines.set(says, [...(lines.get(says) ?? []), ...chords]);
  return [...lines].map(([says, chords]) => ({ says, chords: [...new Set(chords)] }));
}

/** What is reached through the menus only: its menu and its words. */
export function menuPaths(menus: readonly MenuPart[]): { id: string; menu: string; label: string }[] {
  return menus.flatMap(({ label: menu, entries }) =>
    entries.flatMap((entry) =>
      isItem(entry) && entry.keys === undefined ? [{ id: entry.id, menu, label: entry.label }] : [],
    ),
  );
}

export function ShortcutsSheet() {
  const menus = useMenus();
  return (
    <Sheet title={t("help.shortcuts")} testId="shortcuts-dialog" wide onClose={closeOverlay}>
      <div className="keys-columns">
        {TABLES.map(([heading, rows]) => (
          <section key={heading}>
            <h3>{t(heading)}</h3>
            <dl className="keys">
              {linesOf(rows).map(({ says, chords }) => (
                <div key={says}>
                  <dt>
                    {chords.map((chord) => (
                      <kbd key={chord} dir="ltr">
                        {chord}
                      </kbd>
                    ))}
                  </dt>
                  <dd>{t(says)}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section>
          <h3>{t("help.keys-paths")}</h3>
          <p className="keys-how">{t("help.keys-paths-how")}</p>
          <dl className="keys keys-paths">
            {menuPaths(menus).map(({ id, menu, label }) => (
              <div key={id}>
                <dt>
                  <kbd>{menu}</kbd>
                </dt>
                <dd>{label}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Sheet>
  );
}
