/**
 * The menu of what is under the pointer: opened by the right button, by Shift+F10 or the menu key, by a finger that rests.
 *
 * What is under the pointer is selected first, unless it is part of the selection already; the menu then works on the
 * selection, as its keys do.
 */
import { type RefObject, useEffect } from "react";

import type { Point } from "../../model/layout";
import { useStudio } from "../../model/studio";
import { cancelDrag } from "../../session/drag";
import { currentDrawing } from "../../session/drawing";
import { holdingStill, useView } from "../../session/view";
import { anchorOf } from "./viewport";

const REST_MS = 550;
const STILL_PX = 8;

/** The vertex under the pointer: a chip stands for what fills it. */
function vertexAt(element: Element): string | null {
  const drawing = currentDrawing();
  const chip = element.closest<HTMLElement>(".chip");
  const { vertex, slot } = chip?.dataset ?? {};
  const filler = drawing?.program.arcs.find((arc) => slot !== "" && arc.target === vertex && arc.at === slot);
  if (filler !== undefined) return filler.source;
  const node = element.closest<HTMLElement>(".canvas-node")?.dataset["id"];
  const found = node === undefined ? "" : (drawing?.nodes.get(node)?.vertex ?? "");
  return found === "" ? null : found;
}

/** Opens the menu of an element of the canvas at a point of the window. */
function openAt(element: Element, at: Point): void {
  const { selection, select } = useStudio.getState();
  const vertex = vertexAt(element);
  const arc = element.closest<HTMLElement>("[data-arc]")?.dataset["arc"] ?? null;
  if (vertex !== null) {
    if (!selection.includes(vertex)) {
      holdingStill(() => {
        select([vertex]);
      });
    }
  } else {
    select([]);
    useView.getState().selectArc(arc);
  }
  useView.setState({ menu: at, adding: null });
}

/** Opens the menu of the selection, from the keyboard. */
export function openContextMenu(): boolean {
  const { arc, viewport } = useView.getState();
  const last = useStudio.getState().selection.at(-1) ?? null;
  const box = document.querySelector(".canvas")?.getBoundingClientRect();
  if (viewport === null || box === undefined) return false;
  if (last !== null) viewport.reveal(last);
  const anchor = last === null && arc === null ? { x: box.width / 2, y: box.height / 3 } : anchorOf(last, arc);
  const { x, y } = anchor ?? { x: box.width / 2, y: box.height / 3 };
  useView.setState({ menu: { x: x + box.left, y: y + box.top }, adding: null });
  return true;
}

/** The click that ends a long press means nothing. */
function swallowClick(): void {
  const swallow = (event: Event) => {
    event.stopPropagation();
    event.preventDefault();
  };
  window.addEventListener("click", swallow, { capture: true, once: true });
  window.addEventListener(
    "pointerup",
    () => {
      setTimeout(() => {
        window.removeEventListener("click", swallow, true);
      }, 60);
    },
    { once: true },
  );
}

export function useContextMenu(root: RefObject<HTMLDivElement | null>): void {
  useEffect(() => {
    const canvas = root.current;
    if (canvas === null) return;
    let rest: ReturnType<typeof setTimeout> | undefined;
    let from: Point = { x: 0, y: 0 };
    const fitting = (target: EventTarget | null): target is Element =>
      target instanceof Element && target.closest("input, [role=dialog], .zoom, .find") === null;

    const onContextMenu = (event: MouseEvent) => {
      if (!fitting(event.target)) return;
      event.preventDefault();
      clearTimeout(rest);
      if (useView.getState().menu !== null) return;
      // From the keyboard it comes to the canvas as a whole.
      if (event.target === canvas) openContextMenu();
      else openAt(event.target, { x: event.clientX, y: event.clientY });
    };
    const onDown = (event: PointerEvent) => {
      clearTimeout(rest);
      const { target } = event;
      if (event.pointerType !== "touch" || !event.isPrimary || !fitting(target)) return;
      from = { x: event.clientX, y: event.clientY };
      rest = setTimeout(() => {
        cancelDrag();
        swallowClick();
        openAt(target, from);
      }, REST_MS);
    };
    const onMove = (event: PointerEvent) => {
      if (Math.hypot(event.clientX - from.x, event.clientY - from.y) > STILL_PX) clearTimeout(rest);
    };
    const onEnd = () => {
      clearTimeout(rest);
    };
    canvas.addEventListener("contextmenu", onContextMenu);
    canvas.addEventListener("pointerdown", onDown, true);
    window.addEventListener("pointermove", onMove, true);
    window.addEventListener("pointerup", onEnd, true);
    window.addEventListener("pointercancel", onEnd, true);
    return () => {
      clearTimeout(rest);
      canvas.removeEventListener("contextmenu", onContextMenu);
      canvas.removeEventListener("pointerdown", onDown, true);
      window.removeEventListener("pointermove", onMove, true);
      window.removeEventListener("pointerup", onEnd, true);
      window.removeEventListener("pointercancel", onEnd, true);
    };
  }, [root]);
}
