import { createElement } from "react";
import { expect, test, vi } from "vitest";

import { mount } from "../../testing/hooks";
import { useBoards } from "./boards";
import { Robots } from "./Robots";

vi.mock("./socket", () => ({ connect: () => undefined, send: () => undefined }));
vi.mock("./Team", () => ({ TeamPart: () => null }));

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
