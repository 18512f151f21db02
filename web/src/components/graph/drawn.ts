/** Programs drawn for keeping, outside of the page. */
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";

import type { Drawing } from "../../session/drawing";
import { loadIcons } from "../../theme";
import { GraphDrawing } from "./GraphDrawing";
import { inTheme } from "./ink";

/** What an icon looks like whose name is not known yet. */
export const UNKNOWN_ICON = ".lucide-square-dashed";

/** The graph of a program as an `svg` element that stands alone; `inside` is the text that it carries. */
export async function drawn(drawing: Drawing, inside: string): Promise<Element> {
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
  const first = inTheme(draw);
  if (first.querySelector(UNKNOWN_ICON) === null) return first;
  await loadIcons();
  return inTheme(draw);
}
