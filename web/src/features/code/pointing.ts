/**
 * What the pointer is over, on either side: a line's vertex is outlined in the graph, a vertex's line in the text.
 *
 * The graph's nodes carry their vertex as `data-id`; the outline is one rule of a style sheet, so that no node is drawn anew.
 */
import { create } from "zustand";

/** The vertex under the pointer in the graph; the text shows its lines. */
export const usePointed = create<{ vertex: string | null }>(() => ({ vertex: null }));

function ownSheet(): () => CSSStyleSheet {
  let sheet: CSSStyleSheet | null = null;
  return () => {
    if (sheet === null) {
      sheet = new CSSStyleSheet();
      document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
    }
    return sheet;
  };
}

const outlineSheet = ownSheet();

/** Outlines a vertex of the graph, or none. */
export function outlineVertex(vertex: string | null): void {
  if (typeof CSSStyleSheet.prototype.replaceSync !== "function") return;
  const sheet = outlineSheet();
  const rule = "{ filter: drop-shadow(0 0 0 var(--ink)) drop-shadow(0 0 1.5px var(--ink)); }";
  sheet.replaceSync(vertex === null ? "" : `.canvas-node[data-id="${CSS.escape(vertex)}"] ${rule}`);
}

/** Watches the pointer over the graph; the returned function ends that. */
export function watchGraph(): () => void {
  const onOver = (event: PointerEvent) => {
    const target = event.target instanceof Element ? event.target : null;
    const part = target?.closest<HTMLElement>(".canvas-node[data-id]");
    const vertex = part?.dataset["id"] ?? null;
    if (vertex !== usePointed.getState().vertex) usePointed.setState({ vertex });
  };
  document.addEventListener("pointerover", onOver, { passive: true });
  return () => {
    document.removeEventListener("pointerover", onOver);
    usePointed.setState({ vertex: null });
  };
}
