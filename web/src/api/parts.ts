/** The server's doors about parts: the files beside a mission, and variables that a person wants. */
import { ask } from "./client";
import type { Catalogue, OwnVariable, OwnWorld, Problem, World, WorldEntry } from "./types";

/** What the files around a mission hold, and the name of their state. */
export interface PartsNow {
  stamp: string;
  catalogue: Catalogue;
}

/** A file that was put beside a mission; `known`: the very same was there already. */
export interface PartsFile {
  file: string;
  kind: "robot" | "constructors" | "world";
  names: string[];
  known: boolean;
}

/** A variable as a person wants it; `was`: the one in whose place it comes, "" for a new one. */
export interface WantedVariable {
  robot: string;
  was: string;
  name: string;
  type: "integer" | "boolean";
  min: number;
  max: number;
  initial: number;
  shared: boolean;
}

const at = (path: string) => `path=${encodeURIComponent(path)}`;

export const partsApi = {
  catalogue: (path: string) => ask<PartsNow>(`catalogue?${at(path)}`),
  world: (path: string, href: string) =>
    ask<{ world: World | null }>(`world?${at(path)}&href=${encodeURIComponent(href)}`),
  /** What a world's file is made of; null when it is not there or has mistakes. */
  plan: (path: string, href: string) =>
    ask<{ world: OwnWorld | null; problems: Problem[] }>(`world/plan?${at(path)}&href=${encodeURIComponent(href)}`),
  worldText: async (world: OwnWorld) =>
    (await ask<{ text: string }>("world/text", { method: "POST", json: world })).text,
  worlds: (path: string) => ask<WorldEntry[]>(`worlds?${at(path)}`),
  /** `over`: the revision of the file that may be replaced; else a file with something else in it is a refusal, 409. */
  add: (path: string, file: string, bytes: ArrayBuffer, over = "") =>
    ask<PartsFile>(`parts?${at(path)}&file=${encodeURIComponent(file)}&over=${over}`, { method: "POST", bytes }),
  variable: (path: string, variables: readonly OwnVariable[], wanted: WantedVariable) =>
    ask<OwnVariable>("variable", { method: "POST", json: { path, variables, ...wanted } }),
};
