import { afterEach, expect, it } from "vitest";

import { useLanguage } from "../i18n/language";
import { useStudio } from "../model/studio";
import { type TestLine, testLine } from "../testing/socket";
import { holdParts } from "./world-files";

let line: TestLine;

afterEach(async () => {
  await useLanguage.getState().choose("en");
  line.end();
});

const robots = [{ name: "crane", label: { "": "Crane", es: "Grúa" }, objects: [] }];
const label = () => useStudio.getState().catalogue.robots[0]?.label;

it("has the parts in another language before the page speaks it, as they come with the words of one", async () => {
  line = testLine({
    "api/catalogue": { stamp: "b", catalogue: { groups: [], robots, problems: [] } },
    "api/world": { world: null },
  });
  holdParts("a");
  const seen: unknown[] = [];
  const end = useLanguage.subscribe(({ language }) => seen.push(language, line.asked.length));
  await useLanguage.getState().choose("es");
  end();
  expect(seen).toEqual(["es", 2]);
  expect(label()).toEqual({ "": "Crane", es: "Grúa" });
  expect(line.asked.filter(([address]) => address.startsWith("api/catalogue"))).toHaveLength(1);
});

it("speaks another language though the parts cannot be had", async () => {
  line = testLine({ "api/catalogue": new Response("{}", { status: 503 }) });
  holdParts("a");
  await useLanguage.getState().choose("es");
  expect(useLanguage.getState().language).toBe("es");
});
