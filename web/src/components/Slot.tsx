/** Places of the page that features fill; see `session/features`. */
import type { ReactNode } from "react";

import { useDock } from "../session/dock";
import { features, type PanelPlace, type SlotName } from "../session/features";

/** The parts of all features side by side, in the order of the list of features. */
export function Slot({ name }: { name: SlotName }) {
  return features().map(({ name: feature, slots }) => {
    const Part = slots?.[name];
    return Part === undefined ? null : <Part key={feature} />;
  });
}

/** The panel that is open below the graph. */
export function Dock() {
  const open = useDock((dock) => dock.open);
  return features().map(({ name, docks }) => {
    const Panel = open === null ? undefined : docks?.[open];
    return Panel === undefined ? null : <Panel key={name} />;
  });
}

/** The part of the last feature that has one; it gets those before it as its children. */
export function PanelSlot({ place }: { place: PanelPlace }) {
  return features().reduce<ReactNode>((under, { panels }) => {
    const Part = panels?.[place];
    return Part === undefined ? under : <Part>{under}</Part>;
  }, null);
}
