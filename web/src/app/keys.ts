/**
 * The keys that hold everywhere on the page. A key that an editor, a field or an open menu has used is left alone.
 */
import { useEffect } from "react";

import { show, useDocument } from "../session/document";
import { chordOf } from "../session/key-table";
import { listen } from "../ui/effects";
import { FEATURES } from "./features";

const PAGE_KEYS = FEATURES.flatMap(({ keys }) => Object.values(keys ?? {}));

function typing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input:not([type=range]), textarea, select"))
  );
}

/** What a key means here, or null. */
export function keyMeaning(event: KeyboardEvent): (() => void) | null {
  const chord = chordOf(event);
  const key = PAGE_KEYS.find(({ chords }) => chords.includes(chord));
  if (key !== undefined) return key.typing !== true && typing(event.target) ? null : key.run;
  if (event.key !== "Escape" || typing(event.target)) return null;
  const close = FEATURES.map(({ escape }) => escape?.() ?? null).find((one) => one !== null);
  return close ?? (useDocument.getState().overlay === null ? null : () => show(null));
}

export function useKeys(): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented) return;
      const meaning = keyMeaning(event);
      if (meaning === null) return;
      event.preventDefault();
      meaning();
    };
    return listen(window, { keydown: onKeyDown });
  }, []);
}
