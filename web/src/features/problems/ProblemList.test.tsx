/** The list of problems comes a piece at a time, and a problem without one right answer offers none. */
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, growProgram, missionOf } from "../../model/testing/missions";
import type { Fix, Problem } from "../../model/types";
import { standAt, walkProblems } from "../../session/problem-walk";
import { ProblemList } from "./ProblemList";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
const shown = vi.fn();
const place = document.createElement("div");
let root: Root;
const rows = () => [...place.querySelectorAll<HTMLElement>(".problem-row")];

function problem(message: string, fix: Fix | null = null): Problem {
  const where = { file: "a.krt", line: 1, column: 1, end_line: 1, end_column: 2 };
  return { ...where, severity: "error", code: "c", message, help: "", program: "", vertices: [], arcs: [], fix };
}

async function list(...problems: Problem[]): Promise<void> {
  await moreWords();
  const mission = missionOf(growProgram(1, 3, true));
  useStudio.getState().openMission({ ...fileOf(mission), problems: [] });
  useStudio.getState().setReport({ programs: [], problems });
  standAt(-1);
  root = createRoot(place);
  act(() => root.render(<ProblemList />));
}

beforeEach(() => {
  // jsdom lays nothing out, so it has no such method.
  Element.prototype.scrollIntoView = shown;
  shown.mockClear();
  document.body.append(place);
});

afterEach(() => {
  act(() => root.unmount());
  document.body.replaceChildren();
});

test("a long list comes 200 rows at a time, and the one that is walked to is there and in view", async () => {
  await list(...Array.from({ length: 450 }, (_, number) => problem(`m${String(number)}`)));
  expect(rows()).toHaveLength(200);
  const more = () => place.querySelector<HTMLElement>(".problem-more");
  expect(more()?.textContent).toContain("Show 200 more");
  act(() => more()?.click());
  expect(rows()).toHaveLength(400);
  act(() => walkProblems(-1));
  expect(rows()).toHaveLength(450);
  expect(more()).toBeNull();
  const last = rows().at(-1)?.querySelector(".problem");
  expect(last?.getAttribute("aria-current")).toBe("true");
  expect(shown.mock.contexts.at(-1)).toBe(last);
});

test("a problem without one right answer offers none", async () => {
  await list(problem("no such method"));
  expect(rows()).toHaveLength(1);
  expect(place.querySelector(".problem-fix")).toBeNull();
});

test("where nothing is wrong it says what to do", async () => {
  await list();
  expect(place.textContent).toContain("Press Run to see the program at work.");
});

test("a problem with one right answer is mended by its button, and undo brings it back", async () => {
  const mission = missionOf({
    ...CARRIER,
    vertices: CARRIER.vertices.map((one) => (one.id === "v20" ? { ...one, element: "Lamp.LihgtOff" } : one)),
  });
  const wrong = problem("no such method", { kind: "element", name: "Lamp.LightOff", text: "" });
  await list({ ...wrong, program: "carrier", vertices: ["v20"] });
  act(() => {
    useStudio.getState().openMission(fileOf(mission));
    useStudio.getState().setReport({ programs: [], problems: [{ ...wrong, program: "carrier", vertices: ["v20"] }] });
  });
  const element = () => useStudio.getState().mission.programs[0]?.vertices.find((one) => one.id === "v20")?.element;
  act(() => place.querySelector<HTMLElement>('[data-testid="fix-1"]')?.click());
  expect(element()).toBe("Lamp.LightOff");
  act(() => useStudio.getState().undo());
  expect(element()).toBe("Lamp.LihgtOff");
});
