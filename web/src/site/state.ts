/** How far the studio of a static site is, and what a person should know of it. */
import { create } from "zustand";

import type { Keeping } from "./messages";

export type Phase = "other-tab" | "fetching" | "starting" | "ready" | "broken" | "unfetched";

interface SiteState {
  phase: Phase;
  /** From 0 to 1. */
  fetched: number;
  /** What broke, as the browser says it. */
  reason: string;
  keeping: Keeping;
  /** Loads the new version that is there, or null. */
  renew: (() => void) | null;
  /** The new version takes over: the page is loaded again when the browser lets it. */
  renewing: boolean;
}

export const useSite = create<SiteState>(() => ({
  phase: "fetching",
  fetched: 0,
  reason: "",
  keeping: "kept",
  renew: null,
  renewing: false,
}));

export function setSite(news: Partial<SiteState>): void {
  useSite.setState(news);
}
