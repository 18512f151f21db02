/**
 * Rows whose parts give way, one after another, where there is no room for all of them.
 *
 * An element with `data-fold="1"` is hidden first, those with `data-fold="2"` next, until the row's children fit into it;
 * an element with `data-folded="2"` is there only while what is hidden reaches that number (1 unless told): the way to it. What fits depends on language,
 * fonts, zoom and fingers, so it is measured, again whenever the row or what stands in it changes.
 *
 * Invariant: nothing that gives way takes the focus with it; that goes to the way to it.
 */
import { type RefObject, useLayoutEffect, useState } from "react";

import { watchLayout } from "./watch-layout";

const TOLERANCE_PX = 0.5;

function order(part: HTMLElement): number {
  return Number(part.dataset["fold"]);
}

/** Whether the children of the row reach over its edges. Menus that hang on them do not count. */
export function fits(row: HTMLElement): boolean {
  const boxes = [...row.children].map((child) => child.getBoundingClientRect()).filter(({ width }) => width > 0);
  if (boxes.length === 0) return true;
  const wanted = Math.max(...boxes.map(({ right }) => right)) - Math.min(...boxes.map(({ left }) => left));
  const { paddingInlineStart, paddingInlineEnd } = getComputedStyle(row);
  const padding = (parseFloat(paddingInlineStart) || 0) + (parseFloat(paddingInlineEnd) || 0);
  return wanted <= row.getBoundingClientRect().width - padding + TOLERANCE_PX;
}

/** Hides as many parts as it takes; returns the highest number that is hidden, 0 for none. */
export function fold(row: HTMLElement): number {
  const parts = [...row.querySelectorAll<HTMLElement>("[data-fold]")];
  const ways = [...row.querySelectorAll<HTMLElement>("[data-folded]")];
  const before = document.activeElement;
  const show = (level: number) => {
    for (const part of parts) part.hidden = order(part) <= level;
    for (const way of ways) way.hidden = level < (Number(way.dataset["folded"]) || 1);
  };
  let level = 0;
  show(0);
  for (const next of [...new Set(parts.map(order))].sort((a, b) => a - b)) {
    if (fits(row)) break;
    level = next;
    show(level);
  }
  if (before instanceof HTMLElement && row.contains(before)) {
    const gone = before.closest("[hidden]") !== null;
    const heir = ways.find((way) => !way.hidden);
    if (gone && heir !== undefined) (heir.matches("button") ? heir : heir.querySelector("button"))?.focus();
    else if (!gone && document.activeElement !== before) before.focus();
  }
  return level;
}

/** Folds a row as long as it stands there, and says up to which number it is folded. */
export function useFolding(row: RefObject<HTMLElement | null>): number {
  const [level, setLevel] = useState(0);
  useLayoutEffect(() => {
    const element = row.current;
    return element === null ? undefined : watchLayout(element, () => setLevel(fold(element)));
  }, [row]);
  return level;
}
