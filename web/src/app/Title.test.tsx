/** The title says whether the mission is on disk as it stands, and never more than is known. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { useDisk } from "../session/disk";
import { useDocument } from "../session/document";
import { useLink } from "../session/journal";
import { handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { Title } from "./Title";

const PATH = "a/blink.krt";
const MISSION = missionOf(CARRIER);
let page: Mounted;

function open(path = PATH): void {
  useStudio.getState().openMission({ ...fileOf(MISSION), path, name: path, revision: "r1" });
}
function edit(): void {
  useStudio.getState().execute({ label: "Edit", execute: (mission) => ({ ...mission, world: "other.world.xml" }) });
}
function reset(): void {
  useLink.setState(useLink.getInitialState());
  useDisk.setState(useDisk.getInitialState());
}
const state = () => handsOn(page).find("saved-state").textContent;

beforeEach(() => {
  reset();
  open();
  useDocument.setState({ ready: true, ahead: false });
  page = mount(<Title />);
});
afterEach(() => {
  page.end();
  reset();
  useDocument.setState({ ready: false });
});

it("is the mission's name without its folders, and the browser's title marks what is not saved", () => {
  expect([page.place.querySelector("h1")?.textContent, state()]).toEqual(["blink.krt", "saved"]);
  expect(document.title).toBe("blink.krt · KitRobot");
  page.act(edit);
  expect([state(), document.title]).toEqual(["not saved", "• blink.krt · KitRobot"]);
  page.act(() => useStudio.getState().undo());
  expect(state()).toBe("saved");
});

it("says of an example and of a new mission that they are in no file", () => {
  page.act(() => open("example:blink/blink.krt"));
  expect(state()).toBe("example");
  page.act(() => open(""));
  expect(state()).toBe("new program");
});

it("claims nothing of its file while the studio does not answer", () => {
  page.act(() => useLink.setState({ connected: false }));
  expect(state()).toBe("no connection to the studio");
  page.act(edit);
  expect(state()).toBe("not saved, not kept: no connection");
});

it("says when the file on disk is another one, and of no other file", () => {
  page.act(() => useDisk.setState({ path: "other.krt", revision: "r2" }));
  expect(state()).toBe("saved");
  page.act(() => useDisk.setState({ path: PATH, revision: "r2" }));
  expect(state()).toBe("changed on disk");
});

it("says while other windows have the same mission open", () => {
  const { has } = handsOn(page);
  page.act(() => useDisk.setState({ path: "other.krt", revision: "r1", others: 1 }));
  expect(has("also-open")).toBe(false);
  page.act(() => useDisk.setState({ path: PATH, revision: "r1", others: 1 }));
  expect(has("also-open")).toBe(true);
  page.act(() => useDisk.setState({ others: 0 }));
  expect(has("also-open")).toBe(false);
});
