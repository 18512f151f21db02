/**
 * Which tabs of a row that can be scrolled are in view.
 *
 * A tab that is in view in part is not shown (`data-cut`), so that no name is cut in the middle; it and those out of view
 * are counted. `--room` is the width that the row has for one tab: a name that is longer ends in an ellipsis. An element
 * with `data-folded` in the bar around the row is there only while the tabs do not all fit.
 */
import { type RefObject, useLayoutEffect, useState } from "react";

import { endAll, listen } from "./effects";
import { watchLayout } from "./watch-layout";

const TOLERANCE_PX = 1;

function showActive(row: HTMLElement): void {
  row.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest", inline: "nearest" });
}

/** Marks what is cut; returns how many tabs are not in view. */
function mark(row: HTMLElement): number {
  const { left, right } = row.getBoundingClientRect();
  const tabs = [...row.querySelectorAll<HTMLElement>("[role=tab]")];
  const boxes = tabs.map((tab) => tab.getBoundingClientRect());
  const cut = boxes.map((box) => box.left < left - TOLERANCE_PX || box.right > right + TOLERANCE_PX);
  tabs.forEach((tab, index) => tab.toggleAttribute("data-cut", cut[index]));
  return cut.filter(Boolean).length;
}

function measure(row: HTMLElement): number {
  const way = row.parentElement?.querySelector<HTMLElement>(":scope > [data-folded]");
  row.style.removeProperty("--room");
  way?.toggleAttribute("hidden", true);
  if (row.scrollWidth > row.clientWidth) {
    way?.toggleAttribute("hidden", false);
    row.style.setProperty("--room", `${String(row.clientWidth)}px`);
  }
  showActive(row);
  return mark(row);
}

/** How many tabs of the row are not in view. The active one always is. */
export function useInView(row: RefObject<HTMLElement | null>): number {
  const [hidden, setHidden] = useState(0);
  useLayoutEffect(() => {
    const element = row.current;
    if (element === null) return;
    const scrolled = () => setHidden(mark(element));
    return endAll(
      listen(element, { scroll: scrolled }, { passive: true }),
      watchLayout(element, () => setHidden(measure(element)), ["aria-selected"]),
    );
  }, [row]);
  return hidden;
}
