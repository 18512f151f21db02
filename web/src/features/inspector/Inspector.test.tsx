/** Where nothing is selected the inspector says what it is for. */
import { afterEach, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { mount, type Mounted } from "../../testing/hooks";
import { Inspector } from "./Inspector";

await moreWords();

let page: Mounted;
afterEach(() => page.end());

it("says what a click does, then what Start and Stop are, then how many are selected", () => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  page = mount(<Inspector />);
  expect(page.place.textContent).toContain("Click a part to set its speed");
  page.act(() => useStudio.getState().select(["start"]));
  expect(page.place.querySelector("h2")?.textContent).toBe("Start");
  page.act(() => useStudio.getState().select(["v8", "v13"]));
  expect(page.place.textContent).toContain("2");
});
