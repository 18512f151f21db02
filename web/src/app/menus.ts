/**
 * The menus: what the features can do now, in words. What is not built is not here; what cannot be done at this moment is
 * there but cannot be chosen.
 */
import { t } from "../i18n/words";
import { features } from "../session/features";
import { type MenuGroup, MENUS } from "../session/menu-table";
import { useShownNames } from "../session/simple-view";
import type { MenuEntry, MenuPart } from "../ui/menu-model";

/** The sections that have entries, with a line between two of them. */
function divided(id: string, sections: readonly MenuEntry[][]): MenuEntry[] {
  return sections
    .filter((entries) => entries.length > 0)
    .flatMap((entries, at) => (at === 0 ? entries : [{ kind: "line", id: `${id}-line-${String(at)}` }, ...entries]));
}

export function useMenus(): MenuPart[] {
  // The list of features never changes, so neither does the order of their hooks.
  // eslint-disable-next-line react-hooks/rules-of-hooks
  const all = features().map(({ useMenu }) => useMenu?.() ?? {});
  const shown = useShownNames();
  const inGroup = (group: MenuGroup) =>
    all.flatMap((entries) => entries[group] ?? []).filter(({ id }) => shown.entry(id));
  return MENUS.map(({ id, label, sections }) => ({
    id,
    label: t(label),
    entries: divided(
      id,
      sections.map((groups) => groups.flatMap(inGroup)),
    ),
  }));
}
