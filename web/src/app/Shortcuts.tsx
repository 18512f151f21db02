/**
 * The sheet of shortcuts: every row of the table of keys, and for what has no key of its own the way through the menus.
 * A field leaves what holds all words that are typed, in a key, its meaning, a menu, or the words of the field for it.
 */
import { useEffect, useRef, useState } from "react";

import { type Key, t } from "../i18n/words";
import { closeOverlay } from "../session/document";
import { features } from "../session/features";
import { type KeyRow, type KeyTable, WEB_KEYS } from "../session/key-table";
import { holding } from "../ui/matching";
import { isItem, type MenuPart } from "../ui/menu-model";
import { SearchField } from "../ui/SearchField";
import { Sheet } from "../ui/Sheet";
import { useMenus } from "./menus";
import "./shortcuts.css";

/** All keys there are, by where they hold. */
function allTables(): KeyTable[] {
  const ofPage = features().flatMap(({ keys }) => Object.entries(keys ?? {}));
  return [
    { heading: "help.general", rows: Object.fromEntries(ofPage) },
    ...features().flatMap(({ keyTables }) => keyTables ?? []),
    { heading: "help.keys-lists", rows: WEB_KEYS },
  ];
}

/** Rows with one meaning are one line: "W · Shift+W". */
export function linesOf(rows: Record<string, KeyRow>): { says: Key; chords: string[]; also: Key | undefined }[] {
  const lines = new Map<Key, KeyRow[]>();
  for (const row of Object.values(rows)) lines.set(row.says, [...(lines.get(row.says) ?? []), row]);
  return [...lines].map(([says, same]) => ({
    says,
    chords: [...new Set(same.flatMap(({ chords }) => chords))],
    also: same.find(({ also }) => also !== undefined)?.also,
  }));
}

/** What is reached through the menus only: its menu and its words. */
export function menuPaths(menus: readonly MenuPart[]): { id: string; menu: string; label: string }[] {
  return menus.flatMap(({ label: menu, entries }) =>
    entries.flatMap((entry) =>
      isItem(entry) && entry.keys === undefined ? [{ id: entry.id, menu, label: entry.label }] : [],
    ),
  );
}

interface Listed {
  id: string;
  keys: readonly string[];
  says: string;
  /** Other words for it, which are shown where they are why it was found. */
  also?: string;
}

/** What is listed under a heading; `how` says it of all of them. */
interface Section {
  heading: Key;
  how?: Key;
  rows: Listed[];
}

function otherWords(key: Key | undefined): string {
  return key === undefined ? "" : t(key);
}

/** The sections that hold a row with all words of `query`, with those rows only. */
export function foundIn(sections: readonly Section[], query: string): Section[] {
  const holds = holding(query);
  const found = ({ id, keys, says, also = "" }: Listed): Listed[] => {
    if (holds([...keys, says].join(" "))) return [{ id, keys, says }];
    return holds([...keys, says, also].join(" ")) ? [{ id, keys, says, also }] : [];
  };
  return sections
    .map((section) => ({ ...section, rows: section.rows.flatMap(found) }))
    .filter(({ rows }) => rows.length > 0);
}

export function ShortcutsSheet() {
  const menus = useMenus();
  const field = useRef<HTMLInputElement>(null);
  const [query, setQuery] = useState("");
  // After the sheet has kept what to give the focus back to.
  useEffect(() => field.current?.focus(), []);
  const words = new Map(features().flatMap((one) => Object.entries(one.words ?? {})));
  const elsewhere = features().flatMap((one) => one.elsewhere ?? []);
  const sections: Section[] = [
    ...allTables().map(({ heading, rows }) => ({
      heading,
      rows: linesOf(rows).map(({ says, chords, also }) => ({
        id: says,
        keys: chords,
        says: t(says),
        also: otherWords(also),
      })),
    })),
    {
      heading: "help.keys-paths",
      how: "help.keys-paths-how",
      rows: menuPaths(menus).map(({ id, menu, label }) => ({
        id,
        keys: [menu],
        says: label,
        also: otherWords(words.get(id)),
      })),
    },
    {
      heading: "help.keys-elsewhere",
      how: "help.keys-elsewhere-how",
      rows: elsewhere.map(({ name, says, also }) => ({ id: says, keys: [t(name)], says: t(says), also: t(also) })),
    },
  ];
  const found = foundIn(sections, query);
  return (
    <Sheet title={t("help.shortcuts")} testId="shortcuts-dialog" wide onClose={closeOverlay}>
      <SearchField
        className="keys-find"
        label={t("help.keys-search")}
        testId="keys-find"
        field={field}
        value={query}
        set={setQuery}
      />
      <div role="status">
        {found.length === 0 ? <p className="keys-none muted">{t("help.keys-none", { query: query.trim() })}</p> : null}
      </div>
      <div className="keys-columns">
        {found.map(({ heading, how, rows }) => (
          <section key={heading}>
            <h3>{t(heading)}</h3>
            {how === undefined ? null : <p className="keys-how muted small-text">{t(how)}</p>}
            <dl className={how === undefined ? "keys" : "keys keys-paths"}>
              {rows.map(({ id, keys, says, also }) => (
                <div key={id}>
                  <dt>
                    {keys.map((key) => (
                      // What is pressed reads from left to right in every script, the name of a menu as it is written.
                      <kbd key={key} {...(how === undefined ? { dir: "ltr" } : {})}>
                        {key}
                      </kbd>
                    ))}
                  </dt>
                  <dd>
                    {says}
                    {also === undefined ? null : <small className="keys-also muted small-text block">{also}</small>}
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Sheet>
  );
}
