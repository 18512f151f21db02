/** Which sheet about parts of one's own is open, and the menu of one of them. */
import { create } from "zustand";

import { removeConstructor, usesOfConstructor } from "../model/commands/changeOwn";
import { OWN_GROUP, ownConstructors } from "../model/own-parts";
import type { Shape } from "../model/parts";
import { execute, useStudio } from "../model/studio";
import { currentDrawing } from "./drawing";

export type OwnSheet =
  | { kind: "save"; program: string; vertices: string[] }
  | { kind: "edit"; name: string }
  | { kind: "delete"; name: string };

interface OwnState {
  sheet: OwnSheet | null;
  menu: { name: string; x: number; y: number } | null;
}

export const useOwn = create<OwnState>(() => ({ sheet: null, menu: null }));

export function closeSheet(): void {
  useOwn.setState({ sheet: null });
}

export function closeMenu(): void {
  useOwn.setState({ menu: null });
}

/** Whether a part is one that the mission brings along. */
export function isOwn(shape: Shape): boolean {
  return shape.constructor_?.group === OWN_GROUP && isThere(shape.element);
}

function isThere(name: string): boolean {
  return ownConstructors(useStudio.getState().mission).some((one) => one.name === name);
}

/** Whether something is selected that could be saved as a part. */
export function canSave(): boolean {
  const drawing = currentDrawing();
  const { selection } = useStudio.getState();
  const elements = new Set(["Start", "Stop"]);
  return drawing?.program.vertices.some((one) => selection.includes(one.id) && !elements.has(one.element)) ?? false;
}

/** Asks how the selection is to be saved as a part. */
export function openSave(): boolean {
  if (!canSave()) return false;
  const { activeProgram, selection } = useStudio.getState();
  useOwn.setState({ sheet: { kind: "save", program: activeProgram, vertices: [...selection] }, menu: null });
  return true;
}

export function openEdit(name: string): void {
  if (isThere(name)) useOwn.setState({ sheet: { kind: "edit", name }, menu: null });
}

/** Deletes a part that is not used; asks what becomes of its vertices otherwise. */
export function openDelete(name: string): void {
  const { mission } = useStudio.getState();
  if (!isThere(name)) return;
  const isGone = usesOfConstructor(mission, name).length === 0 && execute(removeConstructor(mission, name));
  useOwn.setState({ sheet: isGone ? null : { kind: "delete", name }, menu: null });
}

/** Opens the menu of a part at a place of the window. */
export function openPartMenu(name: string, x: number, y: number): void {
  if (isThere(name)) useOwn.setState({ menu: { name, x, y } });
}
