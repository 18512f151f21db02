/** The listing is of the program in view: that of another one, in view before, is never shown for it. */
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { api } from "../../api/client";
import { useStudio } from "../../model/studio";
import { fileOf, growProgram, missionOf } from "../../model/testing/missions";
import { useListing } from "./Code";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
const place = document.createElement("div");
const one = growProgram(1, 3, true);
const two = { ...growProgram(2, 3, true), name: "two" };
let root: Root;

function Shown({ looks }: { looks: boolean }) {
  return <p>{useListing(looks)}</p>;
}

const image = (name: string) => Promise.resolve({ listing: `of ${name}` } as Awaited<ReturnType<typeof api.image>>);

async function show(name: string, looks = true): Promise<void> {
  await act(async () => {
    useStudio.setState({ activeProgram: name });
    root.render(<Shown looks={looks} />);
    await Promise.resolve();
  });
}

beforeEach(() => {
  const mission = missionOf(one);
  useStudio.getState().openMission({ ...fileOf({ ...mission, programs: [one, two] }), problems: [] });
  const report = (name: string) => ({ name, lll: "", spans: [], instructions: 3 });
  useStudio.getState().setReport({ programs: [report(one.name), report("two")], problems: [] });
  root = createRoot(place);
});

afterEach(() => {
  act(() => root.unmount());
  vi.restoreAllMocks();
});

test("it is asked for while somebody looks, and of the program in view", async () => {
  const asked = vi.spyOn(api, "image").mockImplementation((_, __, name) => image(name));
  await show(one.name, false);
  expect(asked).not.toHaveBeenCalled();
  await show(one.name);
  expect(place.textContent).toBe(`of ${one.name}`);
  await show("two");
  expect(place.textContent).toBe("of two");
});

test("another program shows nothing until its own is there, also where that does not come", async () => {
  vi.spyOn(api, "image").mockImplementation((_, __, name) =>
    name === "two" ? Promise.reject(new Error()) : image(name),
  );
  await show(one.name);
  expect(place.textContent).toBe(`of ${one.name}`);
  await show("two");
  expect(place.textContent).toBe("");
});
