/** The same switches as a menu, for an arena that is small; and what the pens drew as a file, from any arena. */
import { create } from "zustand";

import { t } from "../../../i18n/words";
import { FloatingMenu } from "../../../ui/FloatingMenu";
import { menuCheck, type MenuEntry, menuItem } from "../../../ui/menu-model";
import { hasDrawn, saveDrawing } from "./save-drawing";
import { flip, SHOWS, useOn } from "./switches";

const useMenuPlace = create<{ at: { x: number; y: number } | null; keep: boolean }>(() => ({ at: null, keep: false }));

export function openShown(x: number, y: number): void {
  useMenuPlace.setState({ at: { x, y }, keep: false });
}

/** The menu with nothing but the ways to keep the drawing. */
export function openKeep(x: number, y: number): void {
  useMenuPlace.setState({ at: { x, y }, keep: true });
}

export function ShownMenu() {
  const { at, keep } = useMenuPlace();
  const on = useOn();
  if (at === null) return null;
  const shows = SHOWS.map(({ id, label }) => menuCheck(`show-${id}`, t(label), on[id], () => flip(id)));
  const none = !hasDrawn();
  const ways: MenuEntry[] = [
    menuItem("drawing", t("arena.keep-drawing"), null, () => saveDrawing(false), none),
    menuItem("drawing-floor", t("arena.keep-with-floor"), null, () => saveDrawing(true), none),
  ];
  const entries = keep ? ways : [...shows, { kind: "line" as const, id: "keep" }, ...ways];
  const close = () => useMenuPlace.setState({ at: null });
  return (
    <FloatingMenu
      id="arena-show"
      label={t("arena.show")}
      at={at}
      entries={entries}
      onLeave={close}
      onClose={() => {
        close();
        const opener = keep ? "[data-testid=arena-keep]" : "[data-testid=arena-show]";
        document.querySelector<HTMLElement>(opener)?.focus();
      }}
    />
  );
}
