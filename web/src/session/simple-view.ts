/**
 * The simple view, which a new user begins with: what only an expert needs is not shown. The one place that decides this;
 * whoever draws a detail asks here.
 *
 * A switch in the menu View, which this browser remembers. Settings that somebody made before there was one keep the full
 * view. A mission that cannot be understood without the details shows them all, whatever the switch says.
 */
import { create } from "zustand";

import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import type { Mission } from "../model/types";
import { note, useDocument } from "./document";
import { writeStored } from "../ui/browser-storage";

/**
 * `seed`: where chance begins. `ticks`: numbers of ticks, and steps by one. `places`: coordinates, lines of LLL, names of parts
 * in it. `listing`: three-address code and images. `agents`: who runs what. `team`: programs of a team. `threads`: their
 * numbers. `verification`: check, sweep and experiment.
 */
export type Detail = "seed" | "ticks" | "places" | "listing" | "agents" | "team" | "threads" | "verification";

/** Why a mission shows everything. */
export type Need = "team" | "properties" | "failures";

/** Entries of menus that are details, by their ids. */
const ENTRIES: Readonly<Record<string, Detail>> = {
  "run-step": "ticks",
  "run-step-back": "ticks",
  "run-check": "verification",
  "run-sweep": "verification",
  "run-experiment": "verification",
  "file-download-kri": "listing",
  "file-download-kra": "listing",
  "program-team": "agents",
};

/** Tabs behind those of the programs that are details, by their names. */
const TABS: Readonly<Record<string, Detail>> = { team: "agents" };

const KEY = "kitrobot.simple";
/** The secret of a studio is no setting of a person. */
const NO_SETTING = /^kitrobot\.(?:token|simple)/;

/** Whether the view is simple in a browser that keeps this; a new user has nothing there yet. */
export function readSimple(storage: Pick<Storage, "getItem" | "key" | "length">): boolean {
  const kept = storage.getItem(KEY);
  if (kept !== null) return kept === "yes";
  const names = Array.from({ length: storage.length }, (_, at) => storage.key(at) ?? "");
  return !names.some((name) => name.startsWith("kitrobot.") && !NO_SETTING.test(name));
}

function remember(chosen: boolean): void {
  writeStored(KEY, chosen ? "yes" : "no");
}

function begin(): boolean {
  try {
    const chosen = readSimple(localStorage);
    remember(chosen); // Settings that are made from now on say nothing about it.
    return chosen;
  } catch {
    return true;
  }
}

/** `chosen`: what the switch says. */
export const useSimpleView = create<{ chosen: boolean }>(() => ({ chosen: begin() }));

export function chooseSimple(chosen: boolean): void {
  useSimpleView.setState({ chosen });
  remember(chosen);
}

/** Why the mission shows everything; null where it can be understood without. */
export function findNeed(mission: Mission): Need | null {
  const { programs, roles = [], groups = [], works = [], properties = [], failures = [], breakdown, radio } = mission;
  const declared = roles.length + groups.length + works.length > 0;
  if (declared || programs.some(({ robot }) => robot === TEAM_ROBOT)) return "team";
  if (properties.length > 0) return "properties";
  return failures.length > 0 || breakdown != null || radio != null ? "failures" : null;
}

/** Whether a detail is shown. Several robots show who runs what, and nothing more. */
function shows(detail: Detail | undefined, chosen: boolean, mission: Mission): boolean {
  if (detail === undefined || !chosen || findNeed(mission) !== null) return true;
  return detail === "agents" && mission.agents.length > 1;
}

export function isShown(detail: Detail): boolean {
  return shows(detail, useSimpleView.getState().chosen, useStudio.getState().mission);
}

export function useShown(detail: Detail): boolean {
  const chosen = useSimpleView((view) => view.chosen);
  return useStudio(({ mission }) => shows(detail, chosen, mission));
}

/** Says of entries of menus and of features' tabs whether they are shown. */
export function useShownNames(): { entry: (id: string) => boolean; tab: (name: string) => boolean } {
  const chosen = useSimpleView((view) => view.chosen);
  const mission = useStudio((studio) => studio.mission);
  return {
    entry: (id) => shows(ENTRIES[id], chosen, mission),
    tab: (name) => shows(TABS[name], chosen, mission),
  };
}

/** Why the switch has no say over the open mission; null where it has. */
export function useNeed(): Need | null {
  return useStudio(({ mission }) => findNeed(mission));
}

/** Says once, when a mission that shows everything is open first; the returned function ends the watch. */
export function tellNeed(): () => void {
  // An opened mission takes away what was said of the one before: of it is spoken after that.
  const end = useDocument.subscribe(({ ready, banner }) => {
    const need = findNeed(useStudio.getState().mission);
    if (!ready || need === null || banner !== null || !useSimpleView.getState().chosen) return;
    end();
    note(t(`simple.need-${need}`));
  });
  return end;
}
