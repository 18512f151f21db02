/** Programs drawn for keeping, outside of the page. */
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";

import type { Drawing } from "../../session/drawing";
import { loadIcons } from "../../theme";
import { GraphDrawing } from "./GraphDrawing";
import { inTheme, onPaper } from "./ink";

/** What an icon looks like whose name is not known yet. */
export const UNKNOWN_ICON = ".lucide-square-dashed";

interface Wanted {
  /** The text that the drawing carries. */
  inside?: string;
  /** In light colours, whatever the theme. */
  paper?: boolean;
}

/** The graph of a program as an `svg` element that stands alone. */
export async function drawn(drawing: Drawing, { inside = "", paper = false }: Wanted = {}): Promise<Element> {
  const draw = () => {
    const place = document.createElement("div");
    const root = createRoot(place);
    flushSync(() => {
      root.render(createElement(GraphDrawing, { layout: drawing.layout, title: drawing.program.name, inside }));
    });
    const picture = place.firstElementChild?.cloneNode(true) as Element | undefined;
    root.unmount();
    if (picture === undefined) throw new Error("the graph was not drawn");
    return picture;
  };
  const now = () => (paper ? onPaper(draw) : inTheme(draw));
  const first = now();
  if (first.querySelector(UNKNOWN_ICON) === null) return first;
  await loadIcons();
  return now();
}
