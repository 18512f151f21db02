/** The route of a stretch of a run: what happens between two steps of it. */
import type { Mission } from "../model/types";
import { ask } from "./client";
import type { RunStretch, RunStretchAsk } from "./generated";

export type WantedStretch = Omit<RunStretchAsk, "mission"> & { mission: Mission };

export const stretchApi = {
  record: (wanted: WantedStretch) => ask<RunStretch>("run-stretch", { method: "POST", json: wanted }),
};
