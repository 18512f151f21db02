// @vitest-environment jsdom
import { afterEach, expect, test, vi } from "vitest";

import { whenThere } from "./when-there";

afterEach(() => {
  document.body.replaceChildren();
});

function draw(): HTMLElement {
  const field = document.createElement("input");
  field.className = "field";
  document.body.append(field);
  return field;
}

const observed = () => new Promise((done) => setTimeout(done));

test("what is there is acted on at once", () => {
  const field = draw();
  const act = vi.fn();
  whenThere(".field", act);
  expect(act).toHaveBeenCalledExactlyOnceWith(field);
});

test("what comes later is acted on once", async () => {
  const act = vi.fn();
  whenThere(".field", act);
  expect(act).not.toHaveBeenCalled();
  const field = draw();
  await observed();
  draw();
  await observed();
  expect(act).toHaveBeenCalledExactlyOnceWith(field);
});

test("a key before that ends the waiting", async () => {
  const act = vi.fn();
  whenThere(".field", act);
  document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "a", bubbles: true }));
  draw();
  await observed();
  expect(act).not.toHaveBeenCalled();
});
