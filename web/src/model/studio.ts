/**
 * The open document: mission, parts, selection, and the undo and redo stacks.
 *
 * The one file of the model that knows zustand. Every change of the mission is a `Command` given to `execute`; the stacks
 * have no limit, and undo gives back exactly what was there. The server's words about the mission (`report`) are kept
 * beside it and may lag behind by one check.
 */
import { create } from "zustand";

import type { Command } from "./command";
import type { Change, History, Step } from "./history";
import { OWN_WORLD } from "./commands/changeWorld";
import { catalogueOf } from "./own";
import type { Catalogue, Mission, MissionFile, Program, Report, World } from "./types";

interface Done {
  command: Command;
  /** The selection and the program in view before the command, for undo. */
  selection: string[];
  program: string;
  at_ms: number;
}

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

/** A step of a journal as something that can be taken back. */
function doneBefore({ label, program, before, after }: Step): Done {
  const command = { label, execute: () => after, revert: () => before };
  return { command, selection: [], program, at_ms: 0 };
}

/** The program that stays in view: the same one, or the one that took its place. */
function inView(mission: Mission, name: string, place: number): string {
  if (mission.programs.some((one) => one.name === name)) return name;
  return mission.programs[Math.min(Math.max(place, 0), mission.programs.length - 1)]?.name ?? "";
}

export const useStudio = create<StudioState>((set, get) => {
  let past: Done[] = [];
  let future: Done[] = [];
  /** The depth of `past` at which the file on disk was written; -1 when that state cannot be reached any more. */
  let saved = 0;

  const stacks = () => ({
    dirty: past.length !== saved,
    canUndo: past.length > 0,
    canRedo: future.length > 0,
    undoLabel: past.at(-1)?.command.label ?? "",
    redoLabel: future.at(-1)?.command.label ?? "",
  });

  const told = (kind: Change["kind"], label = "", program = ""): { change: Change } => ({
    change: { kind, label, program, saved },
  });

  /** The catalogue for a mission; the one that is there as long as what the mission brings along is the same. */
  const partsFor = (mission: Mission): { catalogue?: Catalogue } => {
    const { mission: before, files } = get();
    const same = before.constructors === mission.constructors && before.variables === mission.variables;
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
      ...stacks(),
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
    dirty: false,
    canUndo: false,
    canRedo: false,
    undoLabel: "",
    redoLabel: "",
    change: { kind: "open", label: "", program: "", saved: 0 },

    openMission: ({ path, name, revision, mission: read, catalogue, world }, history) => {
      past = history?.past.map(doneBefore) ?? [];
      future = history?.future.map(doneBefore) ?? [];
      saved = history?.saved ?? 0;
      const mission = history?.mission ?? read;
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
        ...stacks(),
        ...told("open"),
      });
    },

    execute: (command) => {
      const { mission, selection, activeProgram } = get();
      const after = command.execute(mission);
      if (after === mission) return;
      if (saved > past.length) saved = -1;
      const now = Date.now();
      const depth = past.length;
      const last = past.at(-1);
      const joins = command.joins !== undefined && command.joins === last?.command.joins && future.length === 0;
      if (joins && saved !== past.length && now - last.at_ms < JOIN_MS) {
        past[past.length - 1] = { ...last, command: { ...command, revert: last.command.revert }, at_ms: now };
      } else {
        past.push({ command, selection, program: activeProgram, at_ms: now });
      }
      future = [];
      const kind = past.length > depth ? "do" : "join";
      set({
        ...place(after, activeProgram, command.selects ?? selection),
        ...told(kind, command.label, activeProgram),
      });
    },

    undo: () => {
      const last = past.pop();
      if (last === undefined) return;
      future.push(last);
      set({ ...place(last.command.revert(get().mission), last.program, last.selection), ...told("undo") });
    },

    redo: () => {
      const next = future.pop();
      if (next === undefined) return;
      past.push(next);
      const after = next.command.execute(get().mission);
      set({ ...place(after, next.program, next.command.selects ?? next.selection), ...told("redo") });
    },

    select: (ids) => {
      const { mission, activeProgram, selection } = get();
      const next = stillThere(mission, activeProgram, ids);
      if (next.length === selection.length && next.every((id, at) => id === selection[at])) return;
      set({ selection: next });
    },

    setActiveProgram: (name) => {
      if (name === get().activeProgram || !get().mission.programs.some((one) => one.name === name)) return;
      set({ activeProgram: name, selection: [] });
    },

    setReport: (report) => {
      set({ report });
    },

    markSaved: (path, revision, name, saving) => {
      saved = saving === undefined || saving === get().mission ? past.length : -1;
      set({ file: { path, revision, name: name ?? path.split("/").at(-1) ?? path }, ...stacks(), ...told("save") });
    },

    loadParts: (files) => {
      set({ files, catalogue: catalogueOf(files, get().mission) });
    },

    loadWorld: (worldOf, world) => {
      set({ worldOf, world });
    },
  };
});

/** The program in view, or undefined while nothing is open. */
export function programInView(state: StudioState): Program | undefined {
  return state.mission.programs.find((one) => one.name === state.activeProgram);
}
