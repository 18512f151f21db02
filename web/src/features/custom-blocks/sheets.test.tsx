/** A selection becomes a part of one's own, which is changed, used and deleted again; what cannot be is told. */
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { catalogueOf, ownConstructors } from "../../model/own-parts";
import { useStudio } from "../../model/studio";
import { CARRIER, missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import type { Constructor, Mission, Program } from "../../model/types";
import { useOwn } from "../../session/custom-blocks";
import { type Graph, leaveGraph, mountGraph } from "../../testing/graph";
import { type TestLine, testLine } from "../../testing/socket";
import { Palette } from "../palette/Palette";
import { CustomBlocks } from ".";

const PART: Constructor = {
  ...{ name: "Lights out", group: "Own", icon: "", colour: "action", label: {}, help: {}, role: "instruction" },
  ...{ adds: null, slots: [], code: "Lamp.LightOff();" },
};
/** The carrier after v20 has become the part. */
const USING: Program = {
  ...CARRIER,
  vertices: CARRIER.vertices.map((one) => (one.id === "v20" ? { ...one, element: PART.name } : one)),
};
const made = { constructor: PART, program: USING, vertex: "v20", lll: "Lamp.LightOff();" };
const OFFERED = { name: "", offers: [], lll: "Lamp.LightOff();" };
const DRAWING: Program = {
  ...{ name: PART.name, robot: "carrier" },
  vertices: ["Start", "Lamp.LightOff", "Stop"].map((element, at) => ({
    id: `d${String(at)}`,
    element,
    settings: {},
    notes: [],
  })),
  arcs: [
    { source: "d0", out: "next", target: "d1", at: "in" },
    { source: "d1", out: "next", target: "d2", at: "in" },
  ],
};

let page: Graph;
let line: TestLine;
const mission = () => useStudio.getState().mission;
const names = () => ownConstructors(mission()).map((one) => one.name);
const count = (element: string) => mission().programs[0]?.vertices.filter((one) => one.element === element).length;
const isDisabled = () => page.find<HTMLButtonElement>("own-save").disabled;
const later = () => act(() => new Promise<void>((done) => setTimeout(done, 200)));

async function show(opened: Mission): Promise<void> {
  page = await mountGraph(
    opened,
    <>
      <Palette />
      <CustomBlocks />
    </>,
    catalogueOf(PARTS, opened),
  );
}
beforeEach(() => {
  line = testLine({
    "api/part/offer": { offered: OFFERED, refused: null },
    "api/part": { part: made, refused: null },
    "api/part/read": (sent: unknown) => {
      const { constructor } = sent as { constructor: Constructor };
      return { constructor, problems: [], lll: constructor.code, drawing: DRAWING };
    },
  });
});
afterEach(() => {
  leaveGraph(page);
  line.end();
  useOwn.setState(useOwn.getInitialState());
});

describe("saving", () => {
  beforeEach(async () => {
    await show(missionOf(CARRIER));
    page.click("vertex-v20");
    await page.key("p");
    await page.until(() => expect(page.has("own-dialog")).toBe(true));
  });

  it("P asks how it is called; the part is in the palette and in the graph; undo takes both back", async () => {
    page.fill("own-name", "Lights out");
    await page.until(() => expect(isDisabled()).toBe(false));
    await later();
    expect(page.find("own-lll").textContent).toContain("Lamp.LightOff");
    page.click("own-save");
    await page.until(() => expect(page.has("own-dialog")).toBe(false));
    expect([names(), count("Lights out"), page.has("part-Lights out")]).toEqual([["Lights out"], 1, true]);
    page.undo();
    expect([names(), mission().programs[0]]).toEqual([[], CARRIER]);
  });

  it.each(["While", "a.b", "Start", "   "])("the name %s is told at once, and is not kept", (name) => {
    page.fill("own-name", name);
    expect(page.place.querySelector(".own-wrong")?.textContent).not.toBe("");
    expect(isDisabled()).toBe(true);
  });
});

it("what cannot be a part is told in the server's words", async () => {
  line.answers["api/part/offer"] = { offered: null, refused: { message: "A test alone cannot be a part.", help: "" } };
  await show(missionOf(CARRIER));
  page.act(() => useStudio.getState().select(["v19"]));
  await page.key("p");
  await page.until(() => expect(page.find("own-failure").textContent).toContain("alone cannot be a part"));
  expect(isDisabled()).toBe(true);
});

describe("a part of one's own", () => {
  beforeEach(() => show({ ...missionOf(USING), constructors: [PART] }));

  async function press(key: string): Promise<void> {
    page.act(() => page.find("part-Lights out").focus());
    await page.key(key);
  }

  it("is used by a click in the palette", () => {
    page.click("vertex-v13");
    page.click("part-Lights out");
    expect(count("Lights out")).toBe(2);
  });

  it("F2 changes its name, wherever it is used; a mistake in its text is told and not kept", async () => {
    await press("F2");
    await page.until(() => expect(page.has("own-dialog")).toBe(true));
    await later();
    await page.until(() => expect(isDisabled()).toBe(false));
    const problem = {
      severity: "error",
      code: "syntax",
      message: "`)` is missing",
      help: "",
      line: 1,
      column: 1,
      end_line: 1,
      end_column: 2,
    };
    line.answers["api/part/read"] = { constructor: null, problems: [problem], lll: "", drawing: null };
    page.fill("own-name", "Dark");
    await later();
    await page.until(() => expect(page.find("own-failure").textContent).toContain("is missing"));
    expect(isDisabled()).toBe(true);
    line.answers["api/part/read"] = {
      constructor: { ...PART, name: "Dark" },
      problems: [],
      lll: PART.code,
      drawing: DRAWING,
    };
    page.fill("own-name", "Dark ");
    await later();
    await page.until(() => expect(isDisabled()).toBe(false));
    page.click("own-save");
    await page.until(() => expect(page.has("own-dialog")).toBe(false));
    expect([names(), count("Dark"), count("Lights out")]).toEqual([["Dark"], 1, 0]);
  });

  it("Delete says where it is used and leads there; its instructions take its place, or its vertices are left", async () => {
    await press("Delete");
    await page.until(() => expect(page.has("own-delete")).toBe(true));
    expect(page.find("own-delete").textContent).toContain("It is used 1 time.");
    page.click("own-use-carrier");
    expect([useStudio.getState().selection, page.has("own-delete")]).toEqual([["v20"], false]);
    await press("Delete");
    page.click("own-dissolve");
    await page.until(() => expect(names()).toEqual([]));
    expect([count("Lights out"), count("Lamp.LightOff")]).toEqual([0, 1]);
    page.undo();
    await press("Delete");
    page.click("own-leave");
    expect([names(), count("Lights out")]).toEqual([[], 1]);
  });

  it("has a menu with all of it by the right button", async () => {
    await page.rightClick("part-Lights out");
    expect(page.all("menu-own-*").map((one) => one.dataset["testid"])).toEqual([
      "menu-own-edit",
      "menu-own-delete",
      "menu-own-share",
    ]);
  });
});
