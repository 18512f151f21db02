/** The way to a new program: one for each robot there is; one of the team only where details are shown. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { moreWords } from "../i18n/words";
import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { chooseSimple } from "../session/simple-view";
import { handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { AddProgram } from "./AddProgram";

await moreWords();

let page: Mounted;
beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  page = mount(<AddProgram />);
});
afterEach(() => {
  page.end();
  chooseSimple(false);
});

const entries = () =>
  [...document.querySelectorAll<HTMLElement>('[role="menuitem"]')].map(({ dataset }) => dataset["testid"]);

it("a robot of the team, and in the simple view robots alone", () => {
  handsOn(page).click("add-program");
  expect(entries()).toEqual(["menu-add-carrier", "menu-add-team-program"]);
  page.act(() => chooseSimple(true));
  expect(entries()).toEqual(["menu-add-carrier"]);
});
