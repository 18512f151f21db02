/** Under a new program stands what to do first, with parts to begin with; beside it the code and the inspector say so too. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { emptyProgram } from "../../model/commands/changePrograms";
import { useStudio } from "../../model/studio";
import { fileOf, missionOf } from "../../model/testing/missions";
import { useDrawing } from "../../session/drawing";
import { mount, type Mounted } from "../../testing/hooks";
import { FirstSteps } from "./FirstSteps";

await moreWords();

let page: Mounted;

function Teaching() {
  const drawing = useDrawing();
  return drawing === null ? null : <FirstSteps drawing={drawing} />;
}

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(emptyProgram("p", "carrier"))));
  page = mount(<Teaching />);
});
afterEach(() => page.end());

it("says what to do, and each part that it offers becomes the first one", () => {
  expect(page.place.textContent).toContain("Give the robot its first step");
  const parts = [...page.place.querySelectorAll<HTMLElement>(".teaching-parts button")];
  expect(parts.length).toBeGreaterThan(1);
  const element = parts[0]?.dataset["testid"]?.replace("first-", "");
  page.act(() => parts[0]?.click());
  const [program] = useStudio.getState().mission.programs;
  const added = program?.vertices.find((one) => one.element === element);
  expect(program?.arcs.some(({ source, target }) => source === "start" && target === added?.id)).toBe(true);
});
