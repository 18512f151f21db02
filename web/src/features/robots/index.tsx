/** Real robots: their panel in the place of the arena, sending to them, and STOP. The panel is fetched when it is opened. */
import type { ReactNode } from "react";

import { moreWords, t } from "../../i18n/words";
import { reportError } from "../../session/document";
import { type Feature, STOP_KEY, stopEverything } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { menuCheck, menuItem } from "../../ui/menu-model";
import { showRobots, useRobotsPanel } from "./state";

const Robots = later(
  () => import("./Robots").then((chunk) => chunk.Robots),
  (cause) => {
    showRobots(false);
    reportError(cause);
  },
);

/** The arena comes back when the panel is closed. */
function RobotsOrArena({ children }: { children: ReactNode }) {
  return useRobotsPanel((state) => state.open) ? <Robots /> : children;
}

const KEYS = {
  runOnRobot: { chords: ["Ctrl+F5"], says: "boards.run", also: "search.deploy", typing: true, run: runOnRobots },
  robots: {
    chords: ["Alt+R"],
    says: "boards.panel",
    also: "search.connect",
    typing: true,
    run: () => showRobots(!useRobotsPanel.getState().open),
  },
} satisfies Record<string, PageKey>;

function RunOnRobots() {
  return (
    <>
      <span className="tool-line rigid" data-fold={5} />
      <button
        type="button"
        className="tool tool-named rigid nowrap medium gap-m relative"
        data-testid="run-on-robot"
        data-fold={5}
        aria-label={t("boards.run")}
        title={`${t("boards.run")} (${keyFor.page(KEYS.runOnRobot)})`}
        onClick={runOnRobots}
      >
        <Icon name="upload" size={18} />
        <span data-fold={1}>{t("boards.run")}</span>
      </button>
    </>
  );
}

function useMenu(): MenuEntries {
  const { open, running } = useRobotsPanel();
  return {
    "robots-panel": [
      menuCheck("robots-panel", t("boards.panel"), open, () => showRobots(!open), keyFor.page(KEYS.robots)),
    ],
    robots: [
      menuItem("robots-run", t("boards.run"), keyFor.page(KEYS.runOnRobot), runOnRobots),
      menuItem("robots-file", t("boards.file"), null, saveFileForBoard),
      menuItem("robots-stop", t("boards.stop-all"), keyFor.page(STOP_KEY), stopEverything, running === 0),
    ],
  };
}

/** Asks in the panel what the robot is built of, and saves the file for a board's drive. */
function saveFileForBoard(): void {
  showRobots();
  Promise.all([import("./board-file"), moreWords()]).then(([{ saveBoardFile }]) => {
    saveBoardFile();
  }, reportError);
}

/** Sends to every robot that is connected, and runs; where none is, the panel says what to do. */
function runOnRobots(): void {
  showRobots();
  Promise.all([import("./actions"), moreWords()]).then(([{ runOnAll }]) => runOnAll(), reportError);
}

export const robots: Feature = {
  name: "robots",
  panels: { arena: RobotsOrArena },
  slots: { tools: RunOnRobots },
  keys: KEYS,
  words: { "robots-file": "search.board-file" },
  useMenu,
  useOn: () => useRobotsPanel(({ running }) => running > 0),
  stop: () => useRobotsPanel.getState().stopAll?.(),
};
