/** What the canvas shows besides the document: the selected arc, the open type-to-add, and the calls of its viewport. */
import { create } from "zustand";

import type { Point } from "../model/layout";
import { useStudio } from "../model/studio";
import type { Place } from "../model/tree";
import { readStored, writeStored } from "../ui/browser-storage";

/** An open type-to-add: the vertex beside which it opens (else the selected arc), and the slot it is for, if any. */
export interface Adding {
  vertex: string | null;
  slot: (Place & { kind: "slot" }) | null;
  /** Whether the part goes around the selection. */
  wrap?: boolean;
}

/** Calls of the viewport, for menus, keys and the canvas's own tools. */
export interface Viewport {
  zoomIn: () => void;
  zoomOut: () => void;
  /** Zoom 1, Start on top. */
  home: () => void;
  fit: () => void;
  /** Shows all of the program from its Start, between half and full size; the returned function goes back. */
  whole: () => () => void;
  /** The selection as large as it is readable; without one, everything. */
  zoomToSelection: () => void;
  /** Scrolls so far that the vertex is in view. */
  reveal: (id: string) => void;
  /** A point of the graph on the canvas, in px from its corner. */
  place: (point: Point) => Point;
  focus: () => void;
}

interface ViewState {
  /** "SOURCE.OUT", or null. A selected arc and selected vertices exclude each other. */
  arc: string | null;
  adding: Adding | null;
  viewport: Viewport | null;
  /** A sentence about what was tried and could not be done; "" for none. */
  said: string;
  /** The vertex whose field is open under it: that of a slot, or with "" the first one; and what was typed to open it. */
  editing: { vertex: string; slot: string; typed: string } | null;
  /** The vertex whose note is being written. */
  noting: string | null;
  /** Whether the canvas moves along with the run. */
  following: boolean;
  /** Whether somebody has moved the canvas by hand since the run began: until the next one it does not move along. */
  resting: boolean;
  minimap: boolean;
  /** Whether chips show what their sensors say while a run exists; remembered in this browser. */
  live: boolean;
  /** Whether the find panel is open. */
  finding: boolean;
  /** Where the menu of the canvas is open, in px of the window. */
  menu: Point | null;
  selectArc: (arc: string | null) => void;
  setAdding: (adding: Adding | null) => void;
}

const LIVE = "kitrobot.live";

export const useView = create<ViewState>((set) => ({
  arc: null,
  adding: null,
  viewport: null,
  said: "",
  noting: null,
  editing: null,
  following: true,
  resting: false,
  minimap: false,
  live: readStored(LIVE) !== "off",
  finding: false,
  menu: null,
  selectArc: (arc) => {
    set({ arc });
    if (arc !== null) useStudio.getState().select([]);
  },
  setAdding: (adding) => set({ adding }),
}));

/** Says what was tried and could not be done; "" for nothing. */
export function sayOnCanvas(said: string): void {
  useView.setState({ said });
}

export function setViewport(viewport: Viewport | null): void {
  useView.setState({ viewport });
}

/** Opens the menu of the canvas, at a point of the window. */
export function openCanvasMenu(menu: Point): void {
  useView.setState({ menu, adding: null });
}

export function closeCanvasMenu(): void {
  useView.setState({ menu: null });
}

export function showNote(vertex: string): void {
  useView.setState({ noting: vertex, adding: null });
}

export function closeNote(): void {
  useView.setState({ noting: null });
}

export function closeField(): void {
  useView.setState({ editing: null });
}

export function closeFind(): void {
  useView.setState({ finding: false });
}

/** No arc is selected, and nothing is being added. */
export function dropArc(): void {
  useView.setState({ arc: null, adding: null });
}

/** A run begins: the canvas may move along again. */
export function resumeFollowing(): void {
  useView.setState({ resting: false });
}

/** Opens the find panel; what was typed in an open one is there to be typed over. */
export function openFind(): void {
  useView.setState({ finding: true });
  document.querySelector<HTMLInputElement>(".find input")?.select();
}

/** Whether the canvas moves along with the run now. */
export function follows({ following, resting }: Pick<ViewState, "following" | "resting">): boolean {
  return following && !resting;
}

export function toggleFollowing(): void {
  useView.setState({ following: !follows(useView.getState()), resting: false });
}

/** The canvas was moved by hand: it stays where it was put. */
export function restFollowing(): void {
  useView.setState({ resting: true });
}

export function toggleMinimap(): void {
  useView.setState({ minimap: !useView.getState().minimap });
}

export function toggleLive(): void {
  const live = !useView.getState().live;
  useView.setState({ live });
  writeStored(LIVE, live ? "on" : "off");
}

let still = false;

/** Does what a pointer selects by: it is in view already, so the canvas does not move for it. */
export function holdingStill(act: () => void): void {
  still = true;
  try {
    act();
  } finally {
    still = false;
  }
}

export function standsStill(): boolean {
  return still;
}

useStudio.subscribe((state, before) => {
  if (state.activeProgram !== before.activeProgram)
    useView.setState({ arc: null, adding: null, menu: null, noting: null, editing: null });
  else if (state.selection !== before.selection && state.selection.length > 0) useView.setState({ arc: null });
});

/** Opens a field under a vertex; `typed` is what is in it at first. */
export function openField(vertex: string, slot: string, typed = ""): void {
  useView.setState({ editing: { vertex, slot, typed }, adding: null });
}

/** Puts the focus into the first field of what is selected; false when it has none. */
export function editSelected(): boolean {
  const field = document.querySelector<HTMLElement>("[data-inspector-field]");
  field?.focus();
  return field !== null;
}

/** Opens type-to-add behind what is selected. */
export function openAdding(): boolean {
  useView.getState().setAdding({ vertex: useStudio.getState().selection.at(-1) ?? null, slot: null });
  return true;
}
