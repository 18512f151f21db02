/** The graph of the program in view. */
import type { Feature } from "../../session/features";
import { openFind } from "../../session/view";
import { Canvas } from "./Canvas";
import { useCanvasMenu } from "./menu";

export const canvas: Feature = {
  name: "canvas",
  panels: { graph: Canvas },
  commands: { find: openFind },
  useMenu: useCanvasMenu,
};
