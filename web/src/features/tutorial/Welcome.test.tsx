/** The first visit offers a tutorial, once, and only above what is no mission of the folder. */
import { afterEach, beforeEach, expect, it } from "vitest";

import type { Tutorial } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDocument } from "../../session/document";
import { handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { isWelcomed } from "./progress";
import { setTutorials, useTutorial } from "./state";
import { Welcome } from "./Tutorials";

await moreWords();

let page: Mounted;
const open = (path: string) => useStudio.getState().openMission({ ...fileOf(missionOf(CARRIER)), path });
const isThere = () => handsOn(page).has("welcome");

beforeEach(() => {
  localStorage.clear();
  useTutorial.setState({ ...useTutorial.getInitialState(), welcomed: isWelcomed() });
  useDocument.setState({ ready: true });
  open("");
  setTutorials([{ name: "t", label: { "": "First steps" }, steps: [{}] } as unknown as Tutorial]);
  page = mount(<Welcome />);
});
afterEach(() => {
  page.end();
  localStorage.clear();
  useTutorial.setState({ ...useTutorial.getInitialState(), welcomed: false });
});

it("greets a newcomer above a new mission or an example, not above a file, and never again once it was closed", () => {
  const hands = handsOn(page);
  expect(hands.find("welcome").textContent).toContain("New here?");
  expect(hands.find("welcome-tutorial").textContent).toBe("First steps");
  page.act(() => open("mine.krt"));
  expect(isThere()).toBe(false);
  page.act(() => open("example:a.krt"));
  expect(isThere()).toBe(true);
  hands.click("welcome-close");
  expect([isThere(), isWelcomed()]).toEqual([false, true]);
});

it("is not there where no tutorial can be used", () => {
  page.act(() => setTutorials([{ name: "t", label: {}, steps: [] } as unknown as Tutorial]));
  expect(isThere()).toBe(false);
});
