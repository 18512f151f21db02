/** An arena that shows nothing says why, and what to do about it. */
import { afterEach, beforeEach, expect, it } from "vitest";

import type { Scene } from "../../components/scene/scene";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { EmptyArena } from "./EmptyArena";

await moreWords();

let page: Mounted;
beforeEach(() => useStudio.getState().openMission(fileOf(missionOf(CARRIER))));
afterEach(() => page.end());

function open(scene: Partial<Scene> | null) {
  page = mount(<EmptyArena scene={scene as Scene | null} />);
  return handsOn(page);
}

it("without robots, and without a world", () => {
  expect(open({ actors: [], real: false }).find("arena-empty").textContent).toContain("No robot is here yet.");
  page.end();
  expect(open(null).find("arena-empty").textContent).toContain("There is no world to show.");
});

it("real robots tell no places, and where robots are nothing is said", () => {
  expect(open({ actors: [], real: true }).find("arena-real").textContent).toContain("do not tell where they are");
  page.end();
  expect(open({ actors: [{}] as unknown as Scene["actors"], real: false }).has("arena-empty")).toBe(false);
});
