// @vitest-environment jsdom
import { beforeEach, expect, test, vi } from "vitest";

import { useBoards } from "./boards";
import { askKit, chooseKit, dropKitQuestion, useKitQuestion, withKit } from "./kits";

beforeEach(() => {
  useBoards.setState({ kits: {} });
  dropKitQuestion();
});

const asked = () => useKitQuestion.getState().asking?.address;

test("what is sent first waits until it was said what the robot is built of, and is then not asked again", () => {
  const go = vi.fn();
  withKit("a", go);
  expect(asked()).toBe("a");
  expect(go).not.toHaveBeenCalled();
  chooseKit("a", "xrp");
  expect(go).toHaveBeenCalledOnce();
  withKit("a", go);
  withKit("b", go);
  expect(go).toHaveBeenCalledTimes(3);
  expect(asked()).toBeUndefined();
});

test("that a robot is built as its own file says is an answer too", () => {
  const go = vi.fn();
  chooseKit("a", "");
  withKit("a", go);
  expect(go).toHaveBeenCalledOnce();
});

test("several robots at once are one question, and all of them wait for its answer", () => {
  const [one, other] = [vi.fn(), vi.fn()];
  withKit("a", one);
  withKit("b", other);
  expect(asked()).toBe("a");
  chooseKit("a", "pico");
  expect(one).toHaveBeenCalledOnce();
  expect(other).toHaveBeenCalledOnce();
});

test("a question that is dropped sends nothing, and neither does another choice later", () => {
  const go = vi.fn();
  withKit("a", go);
  dropKitQuestion();
  askKit("a");
  chooseKit("a", "alvik");
  expect(go).not.toHaveBeenCalled();
  expect(useBoards.getState().kits).toEqual({ a: "alvik", "": "alvik" });
});
