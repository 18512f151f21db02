/** Routes of parts: the files beside a mission, and new or changed variables. */
import { languageInUse } from "../i18n/words";
import type { Mission, OwnVariable, OwnWorld, WorldEntry } from "../model/types";
import { ask } from "./client";
import type {
  KitEntry,
  KitFit,
  Parts,
  PartsDifference,
  PartsFile,
  Plan,
  Template,
  Text,
  VariableAsk,
  WorldFile,
} from "./generated";

/** A new or changed variable; `was`: the name of the one that it replaces, "" for a new one. */
export type WantedVariable = Required<Omit<VariableAsk, "path" | "variables">>;

const at = (path: string) => `path=${encodeURIComponent(path)}`;

export const partsApi = {
  catalogue: (path: string, language = languageInUse()) => ask<Parts>(`catalogue?${at(path)}`, { language }),
  world: (path: string, href: string) => ask<WorldFile>(`world?${at(path)}&href=${encodeURIComponent(href)}`),
  /** What a world's file is made of; null when it is not there or has mistakes. */
  plan: (path: string, href: string) => ask<Plan>(`world/plan?${at(path)}&href=${encodeURIComponent(href)}`),
  /** Worlds to begin with; the maze is made from the seed. */
  templates: (seed: number) => ask<Template[]>(`world/templates?seed=${String(seed)}`),
  worldText: async (world: OwnWorld) => (await ask<Text>("world/text", { method: "POST", json: world })).text,
  worlds: (path: string) => ask<WorldEntry[]>(`worlds?${at(path)}`),
  kits: (path: string) => ask<KitEntry[]>(`kits?${at(path)}`),
  /** Whether a program runs as its robot's own file says (the kit ""), and on each kit. */
  fits: (path: string, mission: Mission, program: string) =>
    ask<KitFit[]>("kits/fit", { method: "POST", json: { path, mission, program } }),
  /** `over`: the revision of the file that may be replaced; else a file with something else in it is a refusal, 409. */
  add: (path: string, file: string, bytes: ArrayBuffer, over = "") =>
    ask<PartsFile>(`parts?${at(path)}&file=${encodeURIComponent(file)}&over=${over}`, { method: "POST", bytes }),
  /** What is different from the file that is there, in words; nothing where it is no kit. */
  difference: async (path: string, file: string, bytes: ArrayBuffer) => {
    const where = `parts/difference?${at(path)}&file=${encodeURIComponent(file)}`;
    return (await ask<PartsDifference>(where, { method: "POST", bytes })).changes;
  },
  variable: (path: string, variables: readonly OwnVariable[], wanted: WantedVariable) =>
    ask<OwnVariable>("variable", { method: "POST", json: { path, variables, ...wanted } }),
};
