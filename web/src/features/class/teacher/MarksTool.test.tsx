/** The button of marks: a form is chosen, the file is saved, and the notice says what the gradebook will not find. */
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

import { classApi, GRADEBOOKS } from "../../../api/class";
import { ApiError } from "../../../api/client";
import { moreWords } from "../../../i18n/words";
import { handsOn } from "../../../testing/hands";
import { mount, type Mounted } from "../../../testing/hooks";
import * as files from "../../../ui/download";
import { MarksTool, takeList } from "./MarksTool";
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
  expect(said?.help.includes("list")).toBe(one !== "sheet");
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

async function take(files: readonly File[]) {
  await act(async () => {
    takeList(files);
    await settled();
  });
  return useDesk.getState().said;
}

/** Once the file is read and the class has answered. */
async function settled() {
  for (let turn = 0; turn < 5; turn++) await new Promise((done) => setTimeout(done));
}

it("the list of a gradebook is kept, and who is not in it is named", async () => {
  const kept = vi.spyOn(classApi, "keepGradebook").mockResolvedValue({ pupils: 2, unlisted: ["Ben"] });
  page = mount(<MarksTool />);
  const said = await take([new File(["Name\nAda\nEve\n"], "list.csv")]);
  expect(kept.mock.calls[0]?.[0].byteLength).toBe(13);
  expect(said?.words).toBe("The list of the gradebook has 2 pupils.");
  expect(said?.help).toContain("Ben");
});

it("a list that is refused says why, and two at once are none", async () => {
  page = mount(<MarksTool />);
  vi.spyOn(classApi, "keepGradebook").mockRejectedValue(new ApiError("this file is a spreadsheet", "choose another"));
  expect((await take([new File(["PK"], "list.xlsx")]))?.words).toContain("spreadsheet");
  const two = [new File([], "a.csv"), new File([], "b.csv")];
  expect((await take(two))?.words).toBe("Drop one file here: the CSV list of your gradebook.");
});
