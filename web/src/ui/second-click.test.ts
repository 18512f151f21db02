import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { guardRemoving } from "./second-click";

const pressed = vi.fn<(name: string) => void>();
let end: () => void;

beforeEach(() => {
  end = guardRemoving();
  for (const name of ["large", "delete", "row", "plain"]) {
    const button = document.createElement("button");
    button.id = name;
    if (name === "delete" || name === "row") button.dataset["removes"] = "";
    button.addEventListener("click", () => pressed(name));
    document.body.append(button);
  }
});
afterEach(() => {
  end();
  pressed.mockClear();
  document.body.replaceChildren();
});

function at(x: number, y: number, detail: number): MouseEventInit {
  return { bubbles: true, cancelable: true, clientX: x, clientY: y, detail };
}
function click(name: string, x = 100, y = 100, detail = 1): void {
  document.getElementById(name)?.dispatchEvent(new MouseEvent("click", at(x, y, detail)));
}
function move(x: number, y: number): void {
  window.dispatchEvent(new MouseEvent("pointermove", at(x, y, 0)));
}
const names = () => pressed.mock.calls.map(([name]) => name);

it("does nothing where what removes has come under the pointer, and the next click removes", () => {
  click("large");
  move(103, 99);
  click("delete", 103, 99, 2);
  expect(names()).toEqual(["large"]);
  click("delete", 103, 99, 3);
  expect(names()).toEqual(["large", "delete"]);
});

it("leaves alone what was there before, what the pointer went to, and what removes nothing", () => {
  click("delete");
  click("large", 300, 100);
  move(200, 100);
  click("delete");
  click("plain");
  click("large");
  expect(names()).toEqual(["delete", "large", "delete", "plain", "large"]);
});

it("removes rows one after another, and whatever a key presses", () => {
  click("row");
  click("delete");
  click("large");
  click("delete", 0, 0, 0);
  expect(names()).toEqual(["row", "delete", "large", "delete"]);
});
