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
import { holdingStill, openCanvasMenu, useView } from "../../session/view";
import { endAll, listen } from "../../ui/effects";
import { onLongPress } from "../../ui/long-press";
import { anchorOf } from "./viewport";

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
  openCanvasMenu(at);
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
  openCanvasMenu({ x: x + box.left, y: y + box.top });
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
    let endRest = () => {};
    const fitting = (target: EventTarget | null): target is Element =>
      target instanceof Element && target.closest("input, [role=dialog], .zoom, .find") === null;

    const onContextMenu = (event: MouseEvent) => {
      if (!fitting(event.target)) return;
      event.preventDefault();
      endRest();
      if (useView.getState().menu !== null) return;
      // From the keyboard it comes to the canvas as a whole.
      if (event.target === canvas) openContextMenu();
      else openAt(event.target, { x: event.clientX, y: event.clientY });
    };
    const onDown = (event: PointerEvent) => {
      endRest();
      const { target } = event;
      if (event.pointerType !== "touch" || !event.isPrimary || !fitting(target)) return;
      endRest = onLongPress(event, (x, y) => {
        cancelDrag();
        swallowClick();
        openAt(target, { x, y });
      });
    };
    return endAll(
      () => endRest(),
      listen(canvas, { contextmenu: onContextMenu }),
      listen(canvas, { pointerdown: onDown }, { capture: true }),
    );
  }, [root]);
}
