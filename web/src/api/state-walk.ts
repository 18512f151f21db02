/** The route of a walk by hand through the states of a mission. */
import type { Mission } from "../model/types";
import { ask } from "./client";
import type { StateWalk, StateWalkAsk } from "./generated";

/** The steps that were taken, from the first state of the mission on. */
export type WantedWalk = Omit<StateWalkAsk, "mission"> & { mission: Mission };

export const walkApi = {
  walk: (wanted: WantedWalk) => ask<StateWalk>("walk", { method: "POST", json: wanted }),
};
