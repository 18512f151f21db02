/** What a new mission can begin with. */
import type { MissionFile } from "../model/types";
import { ask } from "./client";
import type { Beginnings, Preview } from "./generated";

const query = (values: Record<string, string>) => new URLSearchParams(values).toString();

export const beginningsApi = {
  all: () => ask<Beginnings>("beginnings"),
  previews: (kit: string, place: string) => ask<Preview[]>(`beginnings/previews?${query({ kit, place })}`),
  mission: (kit: string, place: string, starter: string) =>
    ask<MissionFile>(`mission/begin?${query({ kit, place, starter })}`),
};
