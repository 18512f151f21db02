/** Where the files of a static site are kept in the browser. */
import { expect, test } from "vitest";

import { homeOf } from "./home";

test("each site of one address has a place of its own, and in a class each pupil", () => {
  const base = "http://127.0.0.1:8000/school/kit/";
  const places = [
    homeOf(base, ""),
    homeOf("http://127.0.0.1:8000/school/kit2/", ""),
    homeOf(base, "Ada"),
    homeOf(base, "Ben"),
  ];
  expect(new Set(places).size).toBe(places.length);
  expect(homeOf(base, "Ada")).toBe(places[2]);
  // One folder each, whatever the path.
  for (const place of places) expect(place).toMatch(/^\/home\/[^/]+$/u);
});
