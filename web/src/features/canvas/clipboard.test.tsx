/** The clipboard holds LLL, and pasted text comes in as parts or is refused with a sentence. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { api } from "../../api/client";
import { emptyProgram } from "../../model/commands/changePrograms";
import { CARRIER, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import { type Graph, leaveGraph, mountGraph } from "../../testing/graph";

/** What the browser hands over with its event; jsdom has none. */
class Clipboard {
  files: File[] = [];
  held = new Map<string, string>();
  setData(kind: string, text: string): void {
    this.held.set(kind, text);
  }
  getData(kind: string): string {
    return this.held.get(kind) ?? "";
  }
}

let page: Graph;
let clipboard: Clipboard;
const inView = () =>
  useStudio.getState().mission.programs.find((one) => one.name === useStudio.getState().activeProgram);
const count = (element: string) => inView()?.vertices.filter((one) => one.element === element).length;
const said = () => page.find("said").textContent;

beforeEach(async () => {
  clipboard = new Clipboard();
  page = await mountGraph(missionOf(CARRIER, emptyProgram("other", "carrier")));
});
afterEach(() => leaveGraph(page));

async function send(kind: "copy" | "cut" | "paste"): Promise<void> {
  const event = Object.assign(new Event(kind, { bubbles: true, cancelable: true }), { clipboardData: clipboard });
  page.act(() => document.activeElement?.dispatchEvent(event));
  await page.until(() => expect(event.defaultPrevented).toBe(true));
}

function other(text: string): void {
  clipboard.held = new Map([["text/plain", text]]);
}

it("what is copied is LLL, and is pasted into another program; undo takes it away", async () => {
  page.click("vertex-v20");
  await send("copy");
  expect(clipboard.getData("text/plain")).toBe("Lamp.LightOff();\n");
  page.act(() => useStudio.getState().setActiveProgram("other"));
  page.click("vertex-start");
  await send("paste");
  expect(count("Lamp.LightOff")).toBe(1);
  page.undo();
  expect(count("Lamp.LightOff")).toBe(0);
});

it("cut takes away, and paste puts back", async () => {
  page.click("vertex-v20");
  await send("cut");
  expect(count("Lamp.LightOff")).toBe(0);
  await send("paste");
  expect(count("Lamp.LightOff")).toBe(1);
});

it("a text of elsewhere is read by the server, and comes in as parts", async () => {
  const piece = {
    ...emptyProgram("piece", "carrier"),
    vertices: [{ id: "v1", element: "Lamp.LightOn", settings: {}, notes: [] }],
  };
  const read = vi.spyOn(api, "fragment").mockResolvedValue({ program: { ...piece, arcs: [] }, problems: [] });
  other("Lamp.LightOn();");
  page.click("vertex-start");
  await send("paste");
  await page.until(() => expect(count("Lamp.LightOn")).toBe(2));
  expect(read.mock.calls[0]?.slice(0, 2)).toEqual(["Lamp.LightOn();", "carrier"]);
});

it("rubbish is told with what the server says of it, and changes nothing", async () => {
  const where = {
    file: "",
    line: 1,
    column: 1,
    end_line: 1,
    end_column: 2,
    program: "",
    vertices: [],
    arcs: [],
    fix: null,
  };
  const problem = { ...where, severity: "error" as const, code: "syntax", message: "expected `(`", help: "" };
  vi.spyOn(api, "fragment").mockResolvedValue({ program: null, problems: [problem] });
  page.click("vertex-start");
  other("Dear all, please find attached");
  await send("paste");
  await page.until(() => expect(said()).toContain("no program text"));
  expect(said()).toContain("Expected `(`");
  other("   ");
  await send("paste");
  await page.until(() => expect(said()).not.toContain("no program text"));
  vi.spyOn(api, "fragment").mockRejectedValue(new Error("Nobody answers."));
  other("WAIT(1);");
  await send("paste");
  await page.until(() => expect(said()).toBe("Nobody answers."));
  expect(useStudio.getState().dirty).toBe(false);
});

it("text that is selected, or a field, keeps its own clipboard", () => {
  page.click("vertex-v20");
  page.act(() => document.body.append(Object.assign(document.createElement("input"), { id: "field" })));
  const event = Object.assign(new Event("copy", { bubbles: true, cancelable: true }), { clipboardData: clipboard });
  document.getElementById("field")?.dispatchEvent(event);
  expect(event.defaultPrevented).toBe(false);
  document.getElementById("field")?.remove();
});
