/**
 * The open document: mission, parts, selection, and the history that undo and redo go through.
 *
 * The one file of the model that knows zustand. Every change of the mission is a `Command` given to `execute`; the history
 * has no limit, and undo gives back exactly what was there. The server's words about the mission (`report`) are kept
 * beside it and may lag behind by one check.
 */
import { create } from "zustand";

import type { Command } from "./command";
import { OWN_WORLD } from "./commands/changeWorld";
import { type Change, follow, type History, historyOf, isUnsaved, type StepDetails } from "./history";
import { catalogueOf } from "./own-parts";
import { teamKey } from "./team-robot";
import type { Catalogue, Mission, MissionFile, Program, Report, World } from "./types";

/** Joining commands further apart than this are steps of their own. */
const JOIN_MS = 1500;

interface File {
  path: string;
  name: string;
  revision: string;
}

export interface StudioState {
  file: File;
  mission: Mission;
  /** The steps that led to the mission, and those that were taken back. */
  history: History;
  /** What the files hold, and the same with what the mission brings along: the one that everybody uses. */
  files: Catalogue;
  catalogue: Catalogue;
  world: World | null;
  /** The name of the world's file that `world` was read for: the mission's, or soon the mission's. */
  worldOf: string;
  activeProgram: string;
  /** Vertex ids of the active program. */
  selection: string[];
  report: Report | null;
  dirty: boolean;
  canUndo: boolean;
  canRedo: boolean;
  /** Labels for the menu: what undo would take back, what redo would do again. */
  undoLabel: string;
  redoLabel: string;
  /** What happened to the document last; a new object each time. */
  change: Change;
  /** Opens a mission, or the work that was left on it: then with its history, whose mission counts. */
  openMission: (file: MissionFile, history?: History) => void;
  execute: (command: Command) => void;
  undo: () => void;
  redo: () => void;
  select: (ids: string[]) => void;
  setActiveProgram: (name: string) => void;
  setReport: (report: Report | null) => void;
  /** `saving` is the mission that was written, in case it has changed meanwhile. */
  markSaved: (path: string, revision: string, name?: string, saving?: Mission) => void;
  /** The parts of the files, which may have changed on disk. */
  loadParts: (files: Catalogue) => void;
  /** The world of that name, as its file says it now; null when there is none. */
  loadWorld: (worldOf: string, world: World | null) => void;
}

const NO_MISSION: Mission = { version: 1, programs: [], agents: [], goals: [], world: "" };
const NO_PARTS: Catalogue = { groups: [], robots: [], problems: [] };

function stillThere(mission: Mission, program: string, ids: string[]): string[] {
  const known = new Set(mission.programs.find((one) => one.name === program)?.vertices.map((vertex) => vertex.id));
  return ids.every((id) => known.has(id)) ? ids : ids.filter((id) => known.has(id));
}

/** The program that stays in view: the same one, or the one that took its place. */
function inView(mission: Mission, name: string, place: number): string {
  if (mission.programs.some((one) => one.name === name)) return name;
  return mission.programs[Math.min(Math.max(place, 0), mission.programs.length - 1)]?.name ?? "";
}

/** A history, and what menus say of it. */
function withHistory(history: History) {
  const { past, future } = history;
  return {
    history,
    dirty: isUnsaved(history),
    canUndo: past.length > 0,
    canRedo: future.length > 0,
    undoLabel: past.at(-1)?.label ?? "",
    redoLabel: future.at(-1)?.label ?? "",
  };
}

export const useStudio = create<StudioState>((set, get) => {
  /** The state after one more change of the document, and what is announced of it. */
  const changed = (change: Change, mission: Mission, details?: StepDetails) => {
    const history = follow(get().history, change, mission, details);
    return { change, ...withHistory(history) };
  };

  /** The catalogue for a mission; the one that is there as long as what the mission brings along is the same. */
  const partsFor = (mission: Mission): { catalogue?: Catalogue } => {
    const { mission: before, files } = get();
    const same =
      before.constructors === mission.constructors &&
      before.variables === mission.variables &&
      teamKey(before) === teamKey(mission);
    return same ? {} : { catalogue: catalogueOf(files, mission) };
  };

  const place = (mission: Mission, wanted: string, selection: string[]) => {
    const before = get();
    const at = before.mission.programs.findIndex((one) => one.name === before.activeProgram);
    const activeProgram = inView(mission, wanted, at);
    return {
      mission,
      ...partsFor(mission),
      activeProgram,
      selection: stillThere(mission, activeProgram, selection),
    };
  };

  return {
    file: { path: "", name: "", revision: "" },
    mission: NO_MISSION,
    files: NO_PARTS,
    catalogue: NO_PARTS,
    world: null,
    worldOf: "",
    activeProgram: "",
    selection: [],
    report: null,
    ...withHistory(historyOf(NO_MISSION)),
    change: { kind: "open", label: "", program: "", saved: 0 },

    openMission: ({ path, name, revision, mission: read, catalogue, world }, history = historyOf(read)) => {
      const { mission, saved } = history;
      set({
        file: { path, name, revision },
        mission,
        files: catalogue,
        catalogue: catalogueOf(catalogue, mission),
        world,
        worldOf: read.own_world == null ? read.world : OWN_WORLD,
        activeProgram: mission.programs[0]?.name ?? "",
        selection: [],
        report: null,
        ...withHistory(history),
        change: { kind: "open", label: "", program: "", saved },
      });
    },

    execute: ({ label, execute, joins, selects, at_ms = Date.now() }) => {
      const { mission, selection, activeProgram: program, history } = get();
      const after = execute(mission);
      if (after === mission) return;
      const { past, future } = history;
      const last = past.at(-1);
      // The state that was saved can be reached by redo only, and there is none after this.
      const saved = history.saved > past.length ? -1 : history.saved;
      const same = joins !== undefined && joins === last?.joins && future.length === 0 && saved !== past.length;
      const join = same && at_ms - (last.at_ms ?? 0) < JOIN_MS;
      const details = { at_ms, selects, joins, ...(join ? {} : { selection }) };
      set({
        ...place(after, program, selects ?? selection),
        ...changed({ kind: join ? "join" : "do", label, program, saved }, after, details),
      });
    },

    undo: () => {
      const { past, saved } = get().history;
      const last = past.at(-1);
      if (last === undefined) return;
      const { before, program, selection = [] } = last;
      set({
        ...place(before, program, selection),
        ...changed({ kind: "undo", label: "", program: "", saved }, before),
      });
    },

    redo: () => {
      const { future, saved } = get().history;
      const next = future.at(-1);
      if (next === undefined) return;
      const { after, program, selects, selection = [] } = next;
      set({
        ...place(after, program, selects ?? selection),
        ...changed({ kind: "redo", label: "", program: "", saved }, after),
      });
    },

    select: (ids) => {
      const { mission, activeProgram, selection } = get();
      const next = stillThere(mission, activeProgram, ids);
      // Who selects the same again is told as for another selection: what was put away for it comes back.
      if (next.length > 0 || selection.length > 0) set({ selection: next });
    },

    setActiveProgram: (name) => {
      if (name === get().activeProgram || !get().mission.programs.some((one) => one.name === name)) return;
      set({ activeProgram: name, selection: [] });
    },

    setReport: (report) => set({ report }),

    markSaved: (path, revision, name, saving) => {
      const { mission, history } = get();
      const saved = saving === undefined || saving === mission ? history.past.length : -1;
      set({
        file: { path, revision, name: name ?? path.split("/").at(-1) ?? path },
        ...changed({ kind: "save", label: "", program: "", saved }, mission),
      });
    },

    loadParts: (files) => set({ files, catalogue: catalogueOf(files, get().mission) }),

    loadWorld: (worldOf, world) => set({ worldOf, world }),
  };
});

/** The program in view, or undefined while nothing is open. */
export function programInView(state: StudioState): Program | undefined {
  return state.mission.programs.find((one) => one.name === state.activeProgram);
}

/** Does a command in the document; says whether there was one. */
export function execute(command: Command | null): boolean {
  if (command === null) return false;
  useStudio.getState().execute(command);
  return true;
}
