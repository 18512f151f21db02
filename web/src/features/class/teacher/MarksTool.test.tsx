/** The button of marks: a form is chosen, the file is saved, and the notice says what the gradebook will not find. */
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

import { classApi, GRADEBOOKS } from "../../../api/class";
import { moreWords } from "../../../i18n/words";
import { handsOn } from "../../../testing/hands";
import { mount, type Mounted } from "../../../testing/hooks";
import * as files from "../../../ui/download";
import { MarksTool } from "./Head";
import { useDesk } from "./store";

await moreWords();

let page: Mounted;
afterEach(() => {
  page.end();
  vi.restoreAllMocks();
});

async function choose(one: (typeof GRADEBOOKS)[number], made: object) {
  const saved = vi.spyOn(files, "download").mockImplementation(() => undefined);
  const asked = vi.spyOn(classApi, "marks").mockResolvedValue({
    name: `marks-${one}.csv`,
    text: "\ufeffName",
    exercises: 1,
    listed: false,
    unlisted: [],
    ...made,
  });
  page = mount(<MarksTool />);
  const hands = handsOn(page);
  hands.click("class-marks");
  await act(async () => {
    document.querySelector<HTMLElement>(`[data-testid="menu-marks-${one}"]`)?.click();
    await Promise.resolve();
  });
  expect(asked).toHaveBeenCalledWith(one);
  return { saved, said: useDesk.getState().said };
}

it.each(GRADEBOOKS)("marks for %s are saved as they came, with their byte order mark", async (one) => {
  const { saved, said } = await choose(one, {});
  expect(saved).toHaveBeenCalledWith(`marks-${one}.csv`, "\ufeffName", "text/csv");
  expect(said?.help.includes("gradebook.csv")).toBe(one !== "sheet");
});

it("who is not in the list of the gradebook is named", async () => {
  const { said } = await choose("canvas", { listed: true, unlisted: ["Ada, K", "Ben"] });
  expect(said?.help).toContain("Ada, K, Ben");
});

it("without marks nothing is saved, and the notice says what comes first", async () => {
  const { saved, said } = await choose("moodle", { exercises: 0 });
  expect(saved).not.toHaveBeenCalled();
  expect(said?.words).toBe("There are no marks yet.");
});
