/** Makes the arena large and the program small, and back: at once for the layout, shown as one short movement. */
import { flushSync } from "react-dom";
import { create } from "zustand";

import { useLayout } from "../../../session/layout";
import { openRoom } from "../../../session/narrow";
import { enlargeStage, useStage } from "../../../session/stage";
import { useView } from "../../../session/view";

const MOVE_MS = 140;

/** Shows the program as it was before. */
const useWayBack = create<{ goBack: (() => void) | null }>(() => ({ goBack: null }));

export function toggle(): void {
  const large = !useStage.getState().large;
  const { folded, toggle: fold } = useLayout.getState();
  const before = document.querySelector(".side-frame")?.getBoundingClientRect();
  flushSync(() => {
    // It may have been folded away, or be another room on a phone.
    if (large && folded.arena) fold("arena");
    if (large) openRoom("arena");
    enlargeStage(large);
  });
  const { viewport } = useView.getState();
  if (!large) useWayBack.getState().goBack?.();
  useWayBack.setState({ goBack: large ? (viewport?.whole() ?? null) : null });
  move(before);
}

/** The arena comes from where it was. */
function move(before: DOMRect | undefined): void {
  const frame = document.querySelector<HTMLElement>(".side-frame");
  if (frame === null || before === undefined || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const after = frame.getBoundingClientRect();
  const by = before.left - after.left || before.right - after.right;
  frame.animate([{ transform: `translateX(${String(by)}px)` }, { transform: "none" }], {
    duration: MOVE_MS,
    easing: "ease-out",
  });
}
