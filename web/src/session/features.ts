/**
 * What a feature gives the page, as one value: its panels, commands, menu entries and sheets.
 *
 * `app/features.ts` has the only list of features and installs it here. `app` makes menus, keys and layout of it; a feature
 * draws what others give through `components/Slot`, so that none imports another.
 */
import type { ComponentType, ReactNode } from "react";

import type { Key } from "../i18n/words";
import type { Overlays } from "./document";
import type { KeyRow, KeyTable, PageKey } from "./key-table";
import type { Panel } from "./layout";
import type { Lesson } from "./lesson";
import type { MenuEntries } from "./menu-table";

/**
 * Places where parts of several features stand side by side: under the head, in the toolbar, at its end, behind the tabs,
 * above and below the graph, in the bottom bar, over the page, and after the page.
 */
export type SlotName =
  "banner" | "tools" | "status" | "tabs-end" | "above" | "below" | "bottom" | "over-page" | "after-page";

/**
 * Places for one part at a time; `graph` is the centre, `empty-program` lies under a program without parts, `ending` on
 * the card of a run that has ended.
 */
export type PanelPlace = Panel | "graph" | "empty-program" | "ending";

/** A tab behind those of the programs. Its element is `tab-of-NAME`, its panel's is `NAME-panel`. */
export interface FeatureTab {
  name: string;
  icon: string;
  label: Key;
  isOpen: () => boolean;
  open: () => void;
  /** What the tab shows: whether it is open, whether there are errors, and how many agents there are (none: no number). */
  useTab: () => { open: boolean; errors: boolean; count?: number };
  /** Lies over the graph; draws nothing while the tab is not open. */
  Panel: ComponentType;
}

export interface Feature {
  name: string;
  slots?: Partial<Record<SlotName, ComponentType>>;
  /** `children` is what stands there without this feature: it may be drawn or replaced. */
  panels?: Partial<Record<PanelPlace, ComponentType<{ children: ReactNode }>>>;
  tab?: FeatureTab;
  /** Panels below the graph, of which one is open (`session/dock`), by the ids of their elements. */
  docks?: Record<string, ComponentType>;
  /** Keys of the page; each belongs to one feature. */
  keys?: Readonly<Record<string, PageKey>>;
  /** Keys of a place of its own. */
  keyTables?: readonly KeyTable[];
  /** Words of the field for entries of menus, by their ids, as `also` of a key. */
  words?: Readonly<Record<string, Key>>;
  /** What has neither a key nor a menu: its name, where it is, and the words that find it. */
  elsewhere?: readonly { name: Key; says: Key; also: Key }[];
  /** A hook: the entries as they are now. */
  useMenu?: () => MenuEntries;
  /** Each with its name in `Overlays`. */
  sheets?: Partial<Record<keyof Overlays, ComponentType>>;
  /** What Escape closes now, or null. */
  escape?: () => (() => void) | null;
  /** A hook: whether something of it is on that STOP would end now. */
  useOn?: () => boolean;
  /** STOP was pressed. */
  stop?: () => void;
  /** Files were dropped on the page. */
  takeFiles?: (files: File[]) => void;
  /** A component that stands in place of the studio, where the page is for something else. */
  Instead?: ComponentType | null;
  /** What it gives to the path to learn. */
  lessons?: () => Promise<readonly Lesson[]>;
  /** Begins what goes on while the page is there; the returned function ends it. */
  start?: () => () => void;
}

let installed: readonly Feature[] = [];

export function install(features: readonly Feature[]): void {
  installed = features;
}

export function features(): readonly Feature[] {
  return installed;
}

/** The key of STOP. */
export const STOP_KEY: KeyRow = { chords: ["Shift+F5"], says: "help.keys-stop", also: "search.stop", typing: true };

/** STOP: the run, and every real robot. */
export function stopEverything(): void {
  for (const { stop } of installed) stop?.();
}
