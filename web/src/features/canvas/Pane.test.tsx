import { afterEach, beforeEach, expect, test } from "vitest";

import { follows, useView } from "../../session/view";
import { mount, type Mounted } from "../../testing/hooks";
import { CameraContext, type CanvasCamera, createCamera } from "./camera";
import { Pane, wheelFactor } from "./Pane";

let camera: CanvasCamera;
let page: Mounted;
let presses: number;

beforeEach(() => {
  useView.setState({ following: true, resting: false });
  camera = createCamera({ x: 10, y: 20, zoom: 1 }, { width: 400, height: 300 });
  presses = 0;
  page = mount(
    <CameraContext value={camera}>
      <Pane least={0.1} dots onPress={() => presses++}>
        <div className="canvas-node" />
      </Pane>
    </CameraContext>,
  );
});
afterEach(() => {
  page.end();
});

function find(selector: string): HTMLElement {
  const found = page.place.querySelector<HTMLElement>(selector);
  if (found === null) throw new Error(`no ${selector}`);
  found.setPointerCapture = () => undefined;
  return found;
}

interface Press {
  on?: string;
  button?: number;
  more?: PointerEventInit;
}

/** Presses at (100, 100), moves by so much, lets go, and clicks as a browser does then. */
function drag(dx: number, dy: number, { on = ".canvas-pane", button = 0, more = {} }: Press = {}): void {
  const [pane, target] = [find(".canvas-pane"), find(on)];
  const at = (type: string, x: number, y: number) =>
    new PointerEvent(type, { bubbles: true, isPrimary: true, pointerId: 1, button, clientX: x, clientY: y, ...more });
  page.act(() => {
    target.dispatchEvent(at("pointerdown", 100, 100));
    window.dispatchEvent(at("pointermove", 100 + dx, 100 + dy));
    window.dispatchEvent(at("pointerup", 100 + dx, 100 + dy));
    (dx === 0 ? target : pane).dispatchEvent(new MouseEvent("click", { bubbles: true, button }));
  });
}

function turn(more: WheelEventInit): void {
  page.act(() => {
    find(".canvas-pane").dispatchEvent(
      new WheelEvent("wheel", { cancelable: true, bubbles: true, clientX: 110, clientY: 70, ...more }),
    );
  });
}

test("a drag pans, rests following, and its click selects nothing", () => {
  drag(30, -40);
  expect(camera.now()).toEqual({ x: 40, y: -20, zoom: 1 });
  expect(follows(useView.getState())).toBe(false);
  expect(presses).toBe(0);
  expect(find(".canvas-graph").style.transform).toBe("translate(40px, -20px) scale(1)");
  expect(find(".canvas-pane").dataset["moving"]).toBeUndefined();
});

test("a click beside everything is told, one on a vertex is not", () => {
  drag(0, 0);
  expect([presses, follows(useView.getState())]).toEqual([1, true]);
  drag(0, 0, { on: ".canvas-node" });
  expect(presses).toBe(1);
});

test("a vertex pans with the middle button only", () => {
  drag(30, 30, { on: ".canvas-node" });
  expect(camera.now().x).toBe(10);
  drag(30, 30, { on: ".canvas-node", button: 1 });
  expect(camera.now().x).toBe(40);
});

test("Shift, Ctrl, the right button and a second finger pan nothing", () => {
  for (const more of [{ shiftKey: true }, { ctrlKey: true }, { isPrimary: false }]) drag(30, 30, { more });
  drag(30, 30, { button: 2 });
  expect(camera.now()).toEqual({ x: 10, y: 20, zoom: 1 });
});

test("a second finger ends the pan of the first", () => {
  const pointer = (type: string, more: PointerEventInit) =>
    new PointerEvent(type, { bubbles: true, isPrimary: true, pointerId: 1, clientX: 100, clientY: 100, ...more });
  find(".canvas-pane").dispatchEvent(pointer("pointerdown", {}));
  window.dispatchEvent(pointer("pointermove", { clientX: 120 }));
  find(".canvas-node").dispatchEvent(pointer("pointerdown", { isPrimary: false, pointerId: 2 }));
  window.dispatchEvent(pointer("pointermove", { clientX: 150 }));
  expect(camera.now().x).toBe(30);
});

test("the wheel zooms at the pointer, rests following, and scrolls nothing", () => {
  const under = camera.point({ x: 110, y: 70 }, { left: 0, top: 0 });
  turn({ deltaY: -250 });
  const { zoom } = camera.now();
  expect(zoom).toBeCloseTo(2 ** 0.5);
  const now = camera.point({ x: 110, y: 70 }, { left: 0, top: 0 });
  expect([now.x, now.y]).toEqual([expect.closeTo(under.x), expect.closeTo(under.y)]);
  expect(follows(useView.getState())).toBe(false);
});

test("the wheel stops where the zoom stops", () => {
  turn({ deltaY: -10_000 });
  expect(camera.now().zoom).toBe(2);
  turn({ deltaY: 10_000 });
  expect(camera.now().zoom).toBe(0.1);
});

test("a wheel that counts lines turns as far as one that counts pixels", () => {
  const lines = new WheelEvent("wheel", { deltaY: -2, deltaMode: WheelEvent.DOM_DELTA_LINE });
  expect(wheelFactor(lines)).toBeCloseTo(wheelFactor(new WheelEvent("wheel", { deltaY: -50 })));
});
