/** STOP is quiet until something runs, and can be pressed at any time. */
import { afterEach, expect, it, vi } from "vitest";

import { type Feature, features, install } from "../session/features";
import { handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { TeamStop } from "./Toolbar";

const before = features();
let page: Mounted;
afterEach(() => {
  page.end();
  install(before);
});

const stop = vi.fn();
const one = (name: string, on?: boolean): Feature => ({ name, stop, ...(on === undefined ? {} : { useOn: () => on }) });

it.each([
  [[undefined, false, false], "false"],
  [[undefined, true, false], "true"],
  [[undefined, false, true], "true"],
] as const)("of features of which on are %j it says %s, and it stops all of them", (on, said) => {
  stop.mockClear();
  install(on.map((is, at) => one(String(at), is)));
  page = mount(<TeamStop />);
  const hands = handsOn(page);
  const button = hands.find<HTMLButtonElement>("team-stop");
  expect([button.dataset["on"], button.disabled]).toEqual([said, false]);
  hands.click("team-stop");
  expect(stop).toHaveBeenCalledTimes(3);
});
