/**
 * How the page is divided: sizes of the panels in px, which of them are folded away; remembered in this browser.
 *
 * The right column holds inspector, code and arena one above the other; the arena takes what the other two leave. The
 * inspector is as tall as its content until somebody gives it a height.
 */
import { create } from "zustand";
import { parseStored, readStored, writeStored } from "../ui/browser-storage";

export type Panel = "palette" | "inspector" | "code" | "arena";
export type Edge = "palette" | "side" | "inspector" | "code";

export interface Sizes {
  palette: number;
  side: number;
  /** 0: as tall as its content. */
  inspector: number;
  code: number;
}

export const USUAL: Sizes = { palette: 216, side: 480, inspector: 0, code: 304 };
export const LEAST: Sizes = { palette: 168, side: 300, inspector: 96, code: 96 };
export const MOST: Sizes = { palette: 400, side: 900, inspector: 520, code: 800 };

interface LayoutState {
  sizes: Sizes;
  folded: Record<Panel, boolean>;
  resize: (edge: Edge, size: number) => void;
  toggle: (panel: Panel) => void;
}

const KEY = "kitrobot.columns";
const OPEN: Record<Panel, boolean> = { palette: false, inspector: false, code: false, arena: false };

function within(edge: Edge, size: number): number {
  return size === USUAL[edge] ? size : Math.round(Math.min(Math.max(size, LEAST[edge]), MOST[edge]));
}

/** What was remembered, as far as it makes sense. */
export function readLayout(text: string | null): { sizes: Sizes; folded: Record<Panel, boolean> } {
  const layout = { sizes: { ...USUAL }, folded: { ...OPEN } };
  const found = parseStored(text);
  if (typeof found !== "object" || found === null) return layout;
  const { sizes, folded } = found as { sizes?: Record<string, unknown>; folded?: Record<string, unknown> };
  for (const edge of Object.keys(USUAL) as Edge[]) {
    const size = sizes?.[edge];
    if (typeof size === "number" && Number.isFinite(size)) layout.sizes[edge] = within(edge, size);
  }
  for (const panel of Object.keys(OPEN) as Panel[]) layout.folded[panel] = folded?.[panel] === true;
  return layout;
}

export const useLayout = create<LayoutState>((set) => ({
  ...readLayout(readStored(KEY)),
  resize: (edge, size) => set(({ sizes }) => ({ sizes: { ...sizes, [edge]: within(edge, size) } })),
  toggle: (panel) => set(({ folded }) => ({ folded: { ...folded, [panel]: !folded[panel] } })),
}));

useLayout.subscribe(({ sizes, folded }) => {
  writeStored(KEY, JSON.stringify({ sizes, folded }));
});
