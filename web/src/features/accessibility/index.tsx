/** Announcements, the outline, help for a part, and the page on a phone. */
import "./panels.css";
import "./touch.css";
import "./narrow.css";
import "./low.css";

import { t } from "../../i18n/words";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { later } from "../../ui/later";
import { menuCheck, menuItem } from "../../ui/menu-model";
import { Announcer } from "./Announcer";
import { NarrowTabs } from "./Narrow";
import { closeHelp, explain, toggleOutline, useAccessibility } from "./state";

// In this order: rules for a narrow page win over those for fingers.

const KEYS = {
  outline: { chords: ["F4"], says: "help.keys-outline", also: "search.structure", typing: true, run: toggleOutline },
  part: { chords: ["F1"], says: "help.keys-part", typing: true, run: explain },
} satisfies Record<string, PageKey>;

function useMenu(): MenuEntries {
  const outline = useAccessibility((state) => state.outline);
  return {
    outline: [menuCheck("view-outline", t("outline.title"), outline, toggleOutline, keyFor.page(KEYS.outline))],
    part: [menuItem("help-part", t("help.part"), keyFor.page(KEYS.part), explain)],
  };
}

const Outline = later(() => import("./Outline").then((chunk) => chunk.Outline), reportError);
const PartHelp = later(() => import("./PartHelp").then((chunk) => chunk.PartHelp), reportError);

/** What makes the studio reachable for everyone, beside the page itself: announcements, the outline, help for a part. */
function Panels() {
  const outline = useAccessibility((state) => state.outline);
  const explained = useAccessibility((state) => state.explained !== null);
  return (
    <>
      <Announcer />
      {outline ? <Outline /> : null}
      {explained ? <PartHelp /> : null}
    </>
  );
}

export const accessibility: Feature = {
  name: "accessibility",
  slots: { "over-page": NarrowTabs, "after-page": Panels },
  keys: KEYS,
  useMenu,
  escape: () => (useAccessibility.getState().explained === null ? null : closeHelp),
};
