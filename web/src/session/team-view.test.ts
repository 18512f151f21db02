import { afterEach, beforeEach, expect, it } from "vitest";

import { renameDeclared } from "../model/commands/changeDeclared";
import { setBreakpoint } from "../model/commands/changeBreakpoints";
import { setBreakdown, setFailures, setRadio } from "../model/commands/changeTrial";
import { historyOf } from "../model/history";
import { useStudio } from "../model/studio";
import { CARRIER, CARRIER_PARTS, missionOf } from "../model/testing/missions";
import { closeTeam, keepTeamView, openTeam, showSide, useTeam } from "./team-view";

const vertex = CARRIER.vertices[1]?.id ?? "";
let stop = () => {};

beforeEach(() => {
  stop = keepTeamView();
  // A mission as the server sends it, with its empty lists.
  const mission = { ...missionOf(CARRIER), breakpoints: [], failures: [] };
  useStudio.setState({ mission, activeProgram: CARRIER.name, history: historyOf(mission) });
  closeTeam();
});

afterEach(() => stop());

function breakpointSetAndTakenBack(between = () => {}): void {
  const { mission, execute } = useStudio.getState();
  const command = setBreakpoint(CARRIER_PARTS, mission, { program: CARRIER.name, vertex });
  if (command === null) throw new Error("no such vertex");
  execute(command);
  between();
  useStudio.getState().undo();
}

it("leaves the program in view when a breakpoint is taken back", () => {
  breakpointSetAndTakenBack();
  expect(useTeam.getState().open).toBe(false);
});

it("goes back to the program when a breakpoint is taken back", () => {
  breakpointSetAndTakenBack(() => openTeam());
  expect(useTeam.getState().open).toBe(false);
});

it.each([
  ["a failure on schedule", () => setFailures(useStudio.getState().mission, [{ agent: "a", at_s: 3, kind: "fail" }])],
  ["the radio", () => setRadio(useStudio.getState().mission, { range_mm: 500 })],
  ["what becomes of robots that fail", () => setBreakdown(useStudio.getState().mission, { rule: "tow", after_s: 5 })],
])("shows the team when %s is taken back", (_, command) => {
  const made = command();
  if (made === null) throw new Error("nothing to do");
  useStudio.getState().execute(made);
  useStudio.getState().undo();
  expect(useTeam.getState().open).toBe(true);
});

it("shows the side of the team when the name of a work is taken back, which programs have too", () => {
  const { mission, execute, catalogue } = useStudio.getState();
  const added = { ...mission, works: [{ name: "clean", units: 3 }] };
  const command = renameDeclared(added, catalogue, "clean", "tidy");
  if (command === null) throw new Error("no such work");
  useStudio.setState({ mission: added, history: historyOf(added) });
  execute(command);
  showSide("parts");
  useStudio.getState().undo();
  expect(useTeam.getState()).toMatchObject({ side: "team", open: false });
});
