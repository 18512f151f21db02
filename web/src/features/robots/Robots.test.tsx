import { createElement } from "react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { mount } from "../../testing/hooks";
import { useBoards } from "./boards";
import { BoardCard } from "./BoardCard";
import { Robots } from "./Robots";
import * as socket from "./socket";
import * as Team from "./Team";
import type { Board } from "./wire";

beforeEach(() => {
  vi.spyOn(socket, "connect").mockImplementation(() => undefined);
  vi.spyOn(socket, "send").mockImplementation(() => undefined);
  vi.spyOn(Team, "TeamPart").mockReturnValue(null);
});
afterEach(() => {
  vi.restoreAllMocks();
  useBoards.setState(useBoards.getInitialState());
});

test("what stands under the list of robots appears with it, and is not moved by it", () => {
  useBoards.setState({ ports: null });
  const { place, act, end } = mount(createElement(Robots));
  const network = () => place.querySelector('[data-testid="robots-address"]');
  expect(place.querySelector(".robots-note")).not.toBeNull();
  expect(network()).toBeNull();
  act(() => useBoards.setState({ ports: [] }));
  expect(place.querySelector('[data-testid="robots-empty"]')).not.toBeNull();
  expect(network()).not.toBeNull();
  end();
});

test("a robot that is greeted has the lines and the buttons that it had before, which wait", () => {
  const place = { address: "/dev/ttyACM0", name: "micro:bit", description: "", firmware: "" };
  const rows = (board: Board | null) => {
    const mounted = mount(createElement(BoardCard, { place: { ...place, board } }));
    const acts = mounted.place.querySelector<HTMLFieldSetElement>("fieldset.robot-acts");
    const found = {
      lines: mounted.place.querySelectorAll(".robot-stands").length,
      buttons: [...(acts?.querySelectorAll("button") ?? [])].map((one) => one.dataset["testid"]),
    };
    mounted.end();
    return { ...found, waits: acts?.disabled };
  };
  useBoards.setState({ you: "me" });
  const before = rows(null);
  const greeted = rows({
    address: place.address,
    phase: "connecting",
    state: "none",
    holder: "me",
    message: "",
    fault: null,
  } as Board);
  expect(before).toMatchObject({ lines: 1, waits: false });
  expect(before.buttons.length).toBeGreaterThan(2);
  expect(greeted).toEqual({ ...before, waits: true });
});
