import { afterEach, expect, it, vi } from "vitest";

import { useLanguage } from "../i18n/language";
import { useStudio } from "../model/studio";
import { type TestLine, testLine } from "../testing/socket";
import { holdParts } from "./world-files";

let line: TestLine;

afterEach(async () => {
  await useLanguage.getState().choose("en");
  line.end();
});

it("fetches the parts anew when the page speaks another language, as they come with the words of one", async () => {
  const robots = [{ name: "crane", label: { "": "Crane", es: "Grúa" }, objects: [] }];
  line = testLine({
    "api/catalogue": { stamp: "b", catalogue: { groups: [], robots, problems: [] } },
    "api/world": { world: null },
  });
  holdParts("a");
  const asked = () => line.asked.filter(([address]) => address.startsWith("api/catalogue")).length;
  await useLanguage.getState().choose("es");
  await vi.waitFor(() => expect(useStudio.getState().catalogue.robots[0]?.label).toEqual({ "": "Crane", es: "Grúa" }));
  expect(asked()).toBe(1);
});
