/** When the first mission is drawn before Python is there, and when not. */
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import { useDocument } from "../session/document";
import { drawFirst, untilDrawn } from "./first";

const BASE = "http://localhost/school/";

const file = (path: string): MissionFile => ({
  path,
  name: path,
  revision: "1",
  mission: { version: 1, programs: [], agents: [], goals: [], world: "" },
  problems: [],
  world: null,
  catalogue: { groups: [], robots: [], problems: [] },
});

const asked = vi.fn(() => Promise.resolve(Response.json(file("example:a.krt"))));

beforeEach(() => {
  asked.mockClear();
  vi.stubGlobal("fetch", asked);
  useDocument.setState({ ready: false, ahead: false });
  localStorage.clear();
});

afterEach(() => {
  vi.unstubAllGlobals();
  window.history.replaceState(null, "", "/");
  useDocument.setState({ ready: false, ahead: false });
  localStorage.clear();
});

const isDrawn = () => useDocument.getState().ahead;

test("is drawn in a browser in which nothing was done yet, also when the page is loaded again", async () => {
  expect(await drawFirst(BASE)).toBe(true);
  const address = new URL("http://localhost/school/first/en.json");
  expect(asked).toHaveBeenCalledWith(address, { signal: expect.any(AbortSignal) as AbortSignal });
  expect(isDrawn()).toBe(true);
  expect(useStudio.getState().file.path).toBe("example:a.krt");
  useDocument.setState({ ready: false, ahead: false });
  // The same mission opens when Python is there.
  useStudio.getState().openMission(file("example:a.krt"));
  await drawFirst(BASE);
  expect(isDrawn()).toBe(true);
});

const change = (world: string) =>
  useStudio.getState().execute({ label: "world", execute: (mission) => ({ ...mission, world }) });

test.each([
  ["another mission was opened", () => useStudio.getState().openMission(file("mine.krt"))],
  ["it was changed", () => change("other")],
])("is not drawn once Python was there and %s", async (_, act) => {
  await drawFirst(BASE);
  useDocument.setState({ ready: true, ahead: false });
  act();
  useDocument.setState({ ready: false, ahead: false });
  await drawFirst(BASE);
  expect(isDrawn()).toBe(false);
});

test("is drawn as it was changed, until Python has it", async () => {
  await drawFirst(BASE);
  change("other");
  useDocument.setState({ ready: false, ahead: false });
  await drawFirst(BASE);
  expect([isDrawn(), useStudio.getState().mission.world]).toEqual([true, "other"]);
  // A link leads elsewhere meanwhile, and takes nothing away.
  window.history.replaceState(null, "", "/#mission=abc&name=x");
  useDocument.setState({ ready: false, ahead: false });
  await drawFirst(BASE);
  window.history.replaceState(null, "", "/");
  await drawFirst(BASE);
  expect([isDrawn(), useStudio.getState().mission.world]).toEqual([true, "other"]);
});

test.each(["/#mission=abc&name=x", "/?open=mine.krt"])("is not drawn at %s, and not later", async (address) => {
  window.history.replaceState(null, "", address);
  await drawFirst(BASE);
  window.history.replaceState(null, "", "/");
  await drawFirst(BASE);
  expect(asked).not.toHaveBeenCalled();
  expect(isDrawn()).toBe(false);
});

test("is not drawn over what is open already", async () => {
  useStudio.getState().openMission(file("example:b.krt"));
  useDocument.setState({ ready: true });
  await drawFirst(BASE);
  expect(isDrawn()).toBe(false);
  expect(useStudio.getState().file.path).toBe("example:b.krt");
});

test("a site without it waits for Python", async () => {
  asked.mockResolvedValueOnce(new Response(null, { status: 404 }));
  expect(await drawFirst(BASE)).toBe(false);
  expect(isDrawn()).toBe(false);
});

test("a site whose server sends it too slowly waits for Python, too", async () => {
  vi.spyOn(AbortSignal, "timeout").mockReturnValueOnce(AbortSignal.abort());
  vi.stubGlobal("fetch", (_: URL, { signal }: { signal: AbortSignal }) => Promise.reject(signal.reason as Error));
  expect(await drawFirst(BASE)).toBe(false);
  expect(isDrawn()).toBe(false);
});

test("what waits for it begins when the page has nothing more to draw, and at once where it is not drawn", async () => {
  const idle: (() => void)[] = [];
  vi.stubGlobal("requestIdleCallback", (call: () => void) => idle.push(call));
  const begin = vi.fn();
  const begun = untilDrawn(drawFirst(BASE)).then(begin);
  await vi.waitFor(() => expect(idle).toHaveLength(1));
  expect(begin).not.toHaveBeenCalled();
  idle[0]?.();
  await begun;
  expect(begin).toHaveBeenCalledOnce();
  asked.mockResolvedValueOnce(new Response(null, { status: 404 }));
  await untilDrawn(drawFirst(BASE));
  expect(idle).toHaveLength(1);
});
