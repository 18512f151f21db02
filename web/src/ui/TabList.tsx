/**
 * A row of tabs of which one is open; the arrows, Home and End go through them, in the direction of the language.
 *
 * What a tab shows is drawn by the caller, in an element with the id `controls` and the role `tabpanel`.
 */
import { type KeyboardEvent, type ReactNode, useRef } from "react";

import { mirrored } from "../i18n/language";

/** The place that a key leads to from `at`, of `count` places in a circle; null for other keys. */
export function tabAfter({ key }: Pick<KeyboardEvent, "key">, at: number, count: number): number | null {
  const on = mirrored() ? -1 : 1;
  const wanted = { ArrowLeft: at - on, ArrowRight: at + on, Home: 0, End: count - 1 }[key];
  return wanted === undefined ? null : (wanted + count) % count;
}

interface TabListProps<Name extends string> {
  label: string;
  /** A tab has the id and the test id `ID-NAME`. */
  id: string;
  names: readonly Name[];
  open: Name;
  show: (name: Name) => void;
  controls: string;
  className: string;
  tabClass?: string;
  title?: (name: Name) => string;
  children: (name: Name) => ReactNode;
}

export function TabList<Name extends string>(props: TabListProps<Name>) {
  const { label, id, names, open, show, controls, className, tabClass, title, children } = props;
  const row = useRef<HTMLDivElement>(null);
  const onKeyDown = (event: KeyboardEvent) => {
    const at = tabAfter(event, names.indexOf(open), names.length);
    const next = at === null ? undefined : names[at];
    if (at === null || next === undefined) return;
    event.preventDefault();
    show(next);
    row.current?.querySelectorAll<HTMLElement>("[role=tab]")[at]?.focus();
  };
  return (
    <div role="tablist" aria-label={label} className={className} ref={row} onKeyDown={onKeyDown}>
      {names.map((name) => (
        <button
          key={name}
          type="button"
          role="tab"
          className={tabClass}
          id={`${id}-${name}`}
          data-testid={`${id}-${name}`}
          title={title?.(name)}
          aria-selected={name === open}
          aria-controls={controls}
          tabIndex={name === open ? 0 : -1}
          onClick={() => show(name)}
        >
          {children(name)}
        </button>
      ))}
    </div>
  );
}
