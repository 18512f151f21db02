/** Announcements, the outline, help for a part, and the page on a phone. */
// In this order: rules for a narrow page win over those for fingers.
import "./panels.css";
import "./touch.css";
import "./narrow.css";
import "./low.css";

import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { menuItem } from "../../ui/menu-model";
import { NarrowTabs } from "./Narrow";
import { Panels } from "./Panels";
import { closeHelp, explain, toggleOutline, useAccessibility } from "./state";

const KEYS = {
  outline: { chords: ["F4"], says: "help.keys-outline", also: "search.structure", typing: true, run: toggleOutline },
  part: { chords: ["F1"], says: "help.keys-part", typing: true, run: explain },
} satisfies Record<string, PageKey>;

function useMenu(): MenuEntries {
  const outline = useAccessibility((state) => state.outline);
  return {
    outline: [
      {
        kind: "check",
        id: "view-outline",
        label: t("outline.title"),
        keys: keyFor.page(KEYS.outline),
        checked: outline,
        run: toggleOutline,
      },
    ],
    part: [menuItem("help-part", t("help.part"), keyFor.page(KEYS.part), explain)],
  };
}

export const accessibility: Feature = {
  name: "accessibility",
  slots: { "over-page": NarrowTabs, "after-page": Panels },
  keys: KEYS,
  useMenu,
  escape: () => (useAccessibility.getState().explained === null ? null : closeHelp),
};
