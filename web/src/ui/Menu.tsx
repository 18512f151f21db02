/** An open menu: a list to choose from, with the keyboard inside it. */
import { type KeyboardEvent, useEffect, useRef, useState } from "react";

import { Icon } from "../theme";
import { firstItem, isItem, itemByLetter, type MenuEntry, type MenuItem, stepItem } from "./menu-model";

interface MenuProps {
  id: string;
  label: string;
  entries: MenuEntry[];
  /** Called after a choice and on Escape; the opener takes the focus back. */
  onClose: () => void;
  /** Arrow left and right, for a menu that hangs on a bar. */
  onAside?: (by: 1 | -1) => void;
}

const ROLES = { item: "menuitem", radio: "menuitemradio", check: "menuitemcheckbox" } as const;

export function Menu({ id, label, entries, onClose, onAside }: MenuProps) {
  const [at, setAt] = useState(() => firstItem(entries));
  const list = useRef<HTMLUListElement>(null);
  /** The focus is the opener's again: what the pointer passed last does not take it back. */
  const closed = useRef(false);

  useEffect(() => {
    if (closed.current) return;
    list.current?.querySelector<HTMLElement>(`[data-at="${String(at)}"]`)?.focus();
  }, [at]);

  const close = () => {
    closed.current = true;
    onClose();
  };

  const choose = (item: MenuItem) => {
    if (item.disabled === true) return;
    close();
    item.run();
  };

  const onKeyDown = (event: KeyboardEvent) => {
    const entry = entries[at];
    if (event.key === "ArrowDown") setAt(stepItem(entries, at, 1));
    else if (event.key === "ArrowUp") setAt(stepItem(entries, at, -1));
    else if (event.key === "Home") setAt(stepItem(entries, -1, 1));
    else if (event.key === "End") setAt(stepItem(entries, -1, -1));
    else if (event.key === "ArrowLeft" && onAside !== undefined) onAside(-1);
    else if (event.key === "ArrowRight" && onAside !== undefined) onAside(1);
    else if (event.key === "Escape") close();
    else if (event.key === "Tab") {
      close();
      return;
    } else if ((event.key === "Enter" || event.key === " ") && entry !== undefined && isItem(entry)) choose(entry);
    else if (event.key.length === 1 && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const found = itemByLetter(entries, at, event.key);
      if (found >= 0) setAt(found);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <ul className="menu surface scroll" id={id} role="menu" aria-label={label} ref={list} onKeyDown={onKeyDown}>
      {entries.map((entry, index) => {
        if (entry.kind === "line") return <li key={entry.id} role="separator" className="menu-line" />;
        if (entry.kind === "heading") {
          return (
            <li key={entry.id} role="presentation" className="menu-heading muted tiny-text">
              {entry.label}
            </li>
          );
        }
        return (
          <li
            key={entry.id}
            role={ROLES[entry.kind]}
            className="menu-item row nowrap"
            tabIndex={-1}
            data-at={index}
            data-testid={`menu-${entry.id}`}
            aria-disabled={entry.disabled === true}
            {...(entry.kind === "item" ? {} : { "aria-checked": entry.checked === true })}
            onClick={() => choose(entry)}
            onPointerMove={() => setAt(index)}
          >
            <span className="menu-mark rigid">
              {entry.kind !== "item" && entry.checked === true ? <Icon name="check" size={14} /> : null}
            </span>
            {entry.picture === undefined ? null : <span className="menu-picture rigid">{entry.picture}</span>}
            <span className="menu-label grow">{entry.label}</span>
            {entry.keys === undefined ? null : (
              <kbd className="menu-keys muted" aria-hidden="true">
                {entry.keys}
              </kbd>
            )}
          </li>
        );
      })}
    </ul>
  );
}
