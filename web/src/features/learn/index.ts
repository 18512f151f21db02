/** The path to learn: tutorials and exercises in one order, as a sheet and under an empty program. */
import { t } from "../../i18n/words";
import { reportError, show } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const LearnSheet = later(
  () => import("./LearnSheet").then((chunk) => chunk.LearnSheet),
  (cause) => {
    show(null);
    reportError(cause);
  },
);
const Invitation = later(() => import("./LearnSheet").then((chunk) => chunk.Invitation), reportError, { words: false });

declare module "../../session/document" {
  interface Overlays {
    learn: true;
  }
}

function showPath(): void {
  show("learn");
}

const KEYS = {
  learn: { chords: ["Alt+L"], says: "learn.open", typing: true, run: showPath },
} satisfies Record<string, PageKey>;

function useMenu(): MenuEntries {
  return { tutorials: [menuItem("help-learn", t("learn.open"), keyFor.page(KEYS.learn), showPath)] };
}

export const learn: Feature = {
  name: "learn",
  panels: { "empty-program": Invitation },
  sheets: { learn: LearnSheet },
  keys: KEYS,
  useMenu,
};
