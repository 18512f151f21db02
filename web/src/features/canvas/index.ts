/** The graph of the program in view. */
import type { Feature } from "../../session/features";
import { GRAPH_KEYS } from "../../session/key-table";
import { Canvas } from "./Canvas";
import { KEYS, useCanvasMenu } from "./menu";

export const canvas: Feature = {
  name: "canvas",
  panels: { graph: Canvas },
  keys: KEYS,
  keyTables: [{ heading: "app.canvas", rows: GRAPH_KEYS }],
  words: { "view-live": "search.live" },
  useMenu: useCanvasMenu,
};
