/** The same switches as a menu, for an arena that is small. */
import { create } from "zustand";

import { t } from "../../../i18n/words";
import { FloatingMenu } from "../../../ui/FloatingMenu";
import type { MenuEntry } from "../../../ui/menu-model";
import { flip, SHOWS, useOn } from "./switches";

const useMenuPlace = create<{ at: { x: number; y: number } | null }>(() => ({ at: null }));

export function openShown(x: number, y: number): void {
  useMenuPlace.setState({ at: { x, y } });
}

export function ShownMenu() {
  const at = useMenuPlace((state) => state.at);
  const on = useOn();
  if (at === null) return null;
  const entries: MenuEntry[] = SHOWS.map(({ id, label }) => ({
    kind: "check",
    id: `show-${id}`,
    label: t(label),
    checked: on[id],
    run: () => flip(id),
  }));
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
        document.querySelector<HTMLElement>("[data-testid=arena-show]")?.focus();
      }}
    />
  );
}
