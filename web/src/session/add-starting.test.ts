import { afterEach, expect, it, vi } from "vitest";

import { partsApi } from "../api/parts";
import { addAgent } from "../model/commands/changeAgents";
import { startOf } from "../model/starts";
import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import held from "../model/testing/worlds.json";
import type { Mission, OwnWorld } from "../model/types";
import { addStarting } from "./world-edits";

const ring = (held as unknown as { own: OwnWorld }[]).find(({ own }) => own.name === "ring")?.own as OwnWorld;
const road = ring.starts.filter(({ at }) => at === "road").map(({ name }) => name);

function open(mission: Partial<Mission>): void {
  useStudio.getState().openMission(fileOf({ ...missionOf(CARRIER), ...mission }));
}
const add = (before: Mission, start: string) =>
  addAgent(before, `r${String(before.agents.length)}`, CARRIER.name, start);
const now = () => useStudio.getState().mission;

afterEach(() => void vi.restoreAllMocks());

it("puts one more robot where a start of its kind is free, and changes no world", async () => {
  const [first = "", ...others] = road;
  open({ own_world: ring, agents: [{ name: first, program: CARRIER.name, start: "" }] });
  expect(await addStarting(first, add)).toBe(true);
  expect(others).toContain(startOf(now().agents[1] as Mission["agents"][number]));
  expect(now().own_world).toBe(ring);
});

it("makes a start on the road where none is free, copies a world of a file for it, and undo takes both back", async () => {
  open({ world: "ring.world.xml", agents: road.map((name) => ({ name, program: CARRIER.name, start: "" })) });
  vi.spyOn(partsApi, "plan").mockResolvedValue({ world: ring, problems: [] });
  const before = now();
  expect(await addStarting(road[0] ?? "", add)).toBe(true);
  const start = now().own_world?.starts.at(-1);
  expect([start?.at, start?.name]).toEqual(["road", startOf(now().agents.at(-1) as Mission["agents"][number])]);
  expect(now().world).toBe("");
  useStudio.getState().undo();
  expect(now()).toBe(before);
});

it("does nothing where the world is full", async () => {
  open({ own_world: { ...ring, starts: [], roads: [], width_mm: 100, height_mm: 100 }, agents: [] });
  expect(await addStarting("", add)).toBe(false);
});
