/** Why a property broke: the sentences, the moment in the run, and what plays from there. */
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import type { CheckedProperty } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { drawnWorld } from "../../model/world/drawing";
import { useRun } from "../../session/run";
import { BrokenRun } from "./BrokenRun";
import { useCheck } from "./check-session";
import { answeredWith, BROKEN, CONFIRMED, WHY, WORLD } from "./testing/broken-property";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
const place = document.createElement("div");
let root: Root;

async function shown(answer: CheckedProperty): Promise<void> {
  await moreWords();
  useCheck.setState(answeredWith(answer));
  act(() => root.render(<BrokenRun cell={{ row: 0, column: 0 }} />));
}

const all = (name: string) => [...place.querySelectorAll<HTMLElement>(`[data-testid="${name}"]`)];
const text = (name: string) => all(name)[0]?.textContent ?? "";
const press = (name: string) => act(() => all(name)[0]?.click());

beforeEach(() => {
  Element.prototype.scrollIntoView = () => undefined;
  document.body.append(place);
  root = createRoot(place);
  useStudio.setState({ world: drawnWorld(WORLD) });
});

afterEach(() => {
  act(() => root.unmount());
  useCheck.setState(useCheck.getInitialState());
  useRun.setState(useRun.getInitialState());
  document.body.replaceChildren();
  vi.restoreAllMocks();
});

test("three sentences say why, and the deciding event is marked in the run", async () => {
  await shown(BROKEN);
  expect(text("check-why")).toContain("This decides it: a stands.");
  expect(all("check-why")[0]?.querySelectorAll("li")).toHaveLength(3);
  expect(text("check-why")).toContain("4 events were left out");
  const marked = [...place.querySelectorAll('[data-decided="true"]')].map((one) => one.textContent);
  expect(marked).toEqual(["2a stands.This decides it"]);
});

test("the run of the simulator is played from the moment that decided it", async () => {
  const start = vi.fn();
  useRun.setState({ start });
  await shown(BROKEN);
  press("check-play-moment");
  expect(useCheck.getState().played).toEqual({ ...CONFIRMED, tick: 40, seconds: 0.8 });
  expect(start).toHaveBeenCalledOnce();
  expect(all("check-play-kept")).toHaveLength(0);
});

test("without the failure it is played up to where that would have come", async () => {
  const kept = { seed: 3, tick: 41, seconds: 0.82, failures: [], delayed: "", delay_s: 0, ends_well: true };
  useRun.setState({ start: vi.fn() });
  await shown({ ...BROKEN, why: { ...WHY, kept } });
  press("check-play-kept");
  expect(useCheck.getState().played).toEqual(kept);
});

test("a moment that the simulator does not tell has no button", async () => {
  await shown({ ...BROKEN, why: { ...WHY, tick: -1 } });
  expect(all("check-play-moment")).toHaveLength(0);
});

test("a run that only the model has seen goes to the deciding step", async () => {
  await shown({ ...BROKEN, confirmed: null });
  expect(all("check-steps")[0]?.dataset["step"]).toBe("0");
  press("check-to-moment");
  expect(all("check-steps")[0]?.dataset["step"]).toBe("1");
});

test("before it is known why, nothing is said of it", async () => {
  await shown({ ...BROKEN, why: null });
  expect(all("check-why")).toHaveLength(0);
  expect(place.querySelectorAll("[data-decided]")).toHaveLength(0);
});
