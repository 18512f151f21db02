/**
 * What of the open mission is marked to vary in an experiment: addresses, each with its values as a text.
 *
 * A text that is empty stands for the values that the server proposes. Another mission that is opened begins with none.
 * Left to others: what the addresses of a mission are (the server), and the runs (`features/experiment`).
 */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import { openDock } from "./dock";
import { currentDrawing } from "./drawing";

/** The panel of the experiment, among those below the graph. */
export const EXPERIMENT = "experiment-panel";

export interface VariedAxis {
  address: string;
  values: string;
}

export const useVaried = create<{ axes: readonly VariedAxis[] }>(() => ({ axes: [] }));

/** The address of a number that is typed into a part of a program. */
export function addressOf(program: string, vertex: string, field: string): string {
  return `${program}.${vertex}.${field}`;
}

export function isVaried(axes: readonly VariedAxis[], address: string): boolean {
  return axes.some((one) => one.address === address);
}

/** Marks it, with its values, and shows the panel; one that is marked gets the values, where there are some. */
export function vary(address: string, values = ""): void {
  const { axes } = useVaried.getState();
  if (!isVaried(axes, address)) useVaried.setState({ axes: [...axes, { address, values }] });
  else if (values !== "") setValues(address, values);
  openDock(EXPERIMENT);
}

export function setValues(address: string, values: string): void {
  useVaried.setState(({ axes }) => ({
    axes: axes.map((one) => (one.address === address ? { address, values } : one)),
  }));
}

export function varyNoMore(address: string): void {
  useVaried.setState(({ axes }) => ({ axes: axes.filter((one) => one.address !== address) }));
}

export function toggleVaried(address: string): void {
  if (isVaried(useVaried.getState().axes, address)) varyNoMore(address);
  else vary(address);
}

/** The addresses of the numbers that are typed into the one part that is selected. */
function selectedAddresses(): string[] {
  const drawing = currentDrawing();
  const { selection } = useStudio.getState();
  const vertex = selection.length === 1 ? drawing?.program.vertices.find(({ id }) => id === selection[0]) : undefined;
  if (drawing === null || vertex === undefined) return [];
  const { fields } = drawing.parts.shape(vertex.element);
  return fields.flatMap(({ kind, name }) =>
    kind === "integer" ? [addressOf(drawing.program.name, vertex.id, name)] : [],
  );
}

/** Whether the one part that is selected has a number. */
export function canVarySelected(): boolean {
  return selectedAddresses().length > 0;
}

/** Marks the next number of the selected part, or none of them any more where all are marked. False without a number. */
export function varySelected(): boolean {
  const addresses = selectedAddresses();
  if (addresses.length === 0) return false;
  const next = addresses.find((one) => !isVaried(useVaried.getState().axes, one));
  if (next === undefined) addresses.forEach(varyNoMore);
  else vary(next);
  return true;
}

useStudio.subscribe((studio, before) => {
  if (studio.change !== before.change && studio.change.kind === "open") useVaried.setState({ axes: [] });
});
