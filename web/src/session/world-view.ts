/**
 * What is being done to the mission's world: the tool in hand, what is chosen, and the world as it is while something is
 * dragged. The document only changes when a drag ends, so that each is one step of undo.
 */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import type { OwnWorld } from "../model/types";
import { type Kind, partOf, type PartReference } from "../model/world/part-reference";
import { showWorld } from "./team-view";

interface WorldState {
  /** What a press on the world puts there; null takes hold of what is there. */
  tool: Kind | null;
  chosen: PartReference[];
  /** The world during a drag. */
  draft: OwnWorld | null;
  /** What was done last, for screen readers. */
  said: string;
}

export const useWorld = create<WorldState>(() => ({ tool: null, chosen: [], draft: null, said: "" }));

/** The mission's own world, or null while it takes place in that of a file. */
export function ownWorld(): OwnWorld | null {
  return useStudio.getState().mission.own_world ?? null;
}

export function choose(chosen: PartReference[]): void {
  useWorld.setState({ chosen });
}

export function say(said: string): void {
  useWorld.setState({ said });
}

/** These things are chosen, and nothing is in hand. */
export function startWith(chosen: PartReference[]): void {
  useWorld.setState({ chosen, tool: null, draft: null });
}

export function takeTool(tool: Kind | null): void {
  useWorld.setState({ tool });
}

/** The world as it is during a drag; null after it. */
export function setDraft(draft: OwnWorld | null): void {
  useWorld.setState({ draft });
}

/** Nothing is in hand. */
export function putDown(): void {
  useWorld.setState({ draft: null, tool: null });
}

/** Shows the world, with these things chosen. */
export function openWorld(chosen: PartReference[] = []): void {
  startWith(chosen);
  showWorld();
}

/** Shows the world with that tool in hand. */
export function openWorldWith(tool: Kind): void {
  openWorld();
  takeTool(tool);
}

/** What is chosen and still there. */
export function chosenIn(world: OwnWorld | null, chosen: readonly PartReference[]): PartReference[] {
  return world === null ? [] : chosen.filter((thing) => partOf(world, thing) !== undefined);
}
