import { beforeEach, expect, test } from "vitest";

import { follows, toggleFollowing, useView } from "../../session/view";
import { moved } from "./viewport";

beforeEach(() => {
  useView.setState({ following: true, resting: false });
});

test("a move by hand rests following, a move of the program does not", () => {
  moved(null);
  expect(follows(useView.getState())).toBe(true);
  moved(new WheelEvent("wheel"));
  expect(follows(useView.getState())).toBe(false);
});

test("the event of a wheel that comes again with a move of the program is not a second move by hand", () => {
  const wheel = new WheelEvent("wheel");
  moved(wheel);
  toggleFollowing();
  moved(wheel);
  expect(follows(useView.getState())).toBe(true);
  moved(new WheelEvent("wheel"));
  expect(follows(useView.getState())).toBe(false);
});
