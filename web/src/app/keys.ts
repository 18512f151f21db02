/**
 * The keys that hold everywhere on the page. A key that an editor, a field or an open menu has used is left alone.
 */
import { useEffect } from "react";

import { show, useDocument } from "../session/document";
import type { PageCommand } from "../session/features";
import { keyIn, type KeyRow, PAGE_KEYS } from "../session/key-table";
import { FEATURES } from "./features";

function typing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input:not([type=range]), textarea, select"))
  );
}

/** What each key of the page does. */
export function actionOf(id: PageCommand): (() => void) | null {
  return FEATURES.find(({ commands }) => commands?.[id] !== undefined)?.commands?.[id] ?? null;
}

/** What a key means here, or null. */
export function keyMeaning(event: KeyboardEvent): (() => void) | null {
  const id = keyIn(PAGE_KEYS, event);
  if (id !== null) {
    const row: KeyRow = PAGE_KEYS[id];
    return row.typing !== true && typing(event.target) ? null : actionOf(id);
  }
  if (event.key !== "Escape" || typing(event.target)) return null;
  const close = FEATURES.map(({ escape }) => escape?.() ?? null).find((one) => one !== null);
  return close ?? (useDocument.getState().overlay === null ? null : () => show(null));
}

export function useKeys(): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || useDocument.getState().ahead) return;
      const meaning = keyMeaning(event);
      if (meaning === null) return;
      event.preventDefault();
      meaning();
    };
    window.addEventListener("keydown", onKeyDown);
    return () => window.removeEventListener("keydown", onKeyDown);
  }, []);
}
