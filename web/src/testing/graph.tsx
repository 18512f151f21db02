/**
 * The graph of an open mission with the keys of the page, as a person works on it: real stores and components.
 *
 * jsdom lays nothing out: the canvas is as large as before its panel is there, and what is dragged onto a slot needs a
 * place that the test gives it.
 */
import { act, type ReactNode } from "react";
import { expect, onTestFinished, vi } from "vitest";

import { useKeys } from "../app/keys";
import { Canvas } from "../features/canvas/Canvas";
import { moreWords } from "../i18n/words";
import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import type { Point } from "../model/layout";
import { PARTS } from "../model/testing/parts";
import type { Catalogue, Mission } from "../model/types";
import { currentDrawing } from "../session/drawing";
import { useView } from "../session/view";
import { type Hands, handsOn } from "./hands";
import { mount, type Mounted } from "./hooks";

export interface Graph extends Mounted, Hands {
  /** Elements of that test id on the page, menus over it too; of all that begin with it where it ends in "*". */
  all: (testId: string) => HTMLElement[];
  /** A key where the focus is, and what is fetched for it. */
  key: (key: string, held?: KeyboardEventInit) => Promise<void>;
  /** Letters into the field that has the focus, over what is selected in it. */
  type: (text: string) => Promise<void>;
  /** Waits until that holds: for what is fetched, or drawn a moment later. */
  until: (fact: () => void) => Promise<void>;
  undo: () => void;
  /** The secondary button on something. */
  rightClick: (testId: string) => Promise<void>;
  /** Takes something with the mouse to a point of the window, which is one of the canvas. */
  carry: (from: Element, to: Point, held?: PointerEventInit) => Promise<void>;
  /** Lets go of it there. */
  drop: (to: Point, held?: PointerEventInit) => Promise<void>;
}

const [WIDTH, HEIGHT] = [904, 840];
const NOWHERE = { x: 0, y: 0, left: -9999, right: -9999, top: -9999, bottom: -9999, width: 0, height: 0 } as DOMRect;

/** What jsdom has not. */
export function furnish(): void {
  const none = () => undefined;
  class Observer {
    observe = none;
    unobserve = none;
    disconnect = none;
  }
  const usual = globalThis.matchMedia;
  // The text editor asks in the old way.
  if (!("addListener" in usual("print")))
    globalThis.matchMedia = (media) => Object.assign(usual(media), { addListener: none, removeListener: none });
  vi.stubGlobal("ResizeObserver", Observer);
  const fonts = Object.assign(new EventTarget(), { ready: Promise.resolve() });
  Object.defineProperty(document, "fonts", { value: fonts, configurable: true });
  // Elsewhere nothing is measured where there is no such thing.
  onTestFinished(() => {
    vi.unstubAllGlobals();
    Reflect.deleteProperty(document, "fonts");
  });
  for (const name of ["scrollIntoView", "setPointerCapture", "scrollTo"])
    if (!(name in Element.prototype)) Object.defineProperty(Element.prototype, name, { value: none, writable: true });
}

let opened = 0;

function Keys(): null {
  useKeys();
  return null;
}

/** Opens a mission and shows its first program, with other parts of the page beside it. */
export async function mountGraph(
  mission: Mission = missionOf(CARRIER),
  beside: ReactNode = null,
  catalogue: Catalogue = PARTS,
): Promise<Graph> {
  furnish();
  await moreWords();
  document.body.replaceChildren();
  document.getSelection()?.removeAllRanges();
  // Another file each time: programs of one file are seen again where they were left.
  useStudio.getState().openMission({ ...fileOf(mission), path: `test-${String(++opened)}.krt`, catalogue });
  vi.spyOn(Element.prototype, "getBoundingClientRect").mockImplementation(function (this: Element) {
    return this.classList.contains("canvas") ? new DOMRect(0, 0, WIDTH, HEIGHT) : NOWHERE;
  });
  vi.spyOn(HTMLElement.prototype, "clientWidth", "get").mockReturnValue(WIDTH);
  vi.spyOn(HTMLElement.prototype, "clientHeight", "get").mockReturnValue(HEIGHT);
  const page = mount(
    <>
      <Keys />
      {beside}
      <Canvas />
    </>,
  );
  return { ...page, ...graphHands(page) };
}

function pointer(kind: string, { x, y }: Point, held: PointerEventInit = {}): PointerEvent {
  const mouse = { pointerId: 1, pointerType: "mouse", isPrimary: true, button: 0, bubbles: true, cancelable: true };
  return new PointerEvent(kind, { ...mouse, clientX: x, clientY: y, ...held });
}

function carry(from: Element, to: Point, held?: PointerEventInit): void {
  from.dispatchEvent(pointer("pointerdown", { x: to.x - 200, y: to.y - 100 }, held));
  for (const step of [0.9, 0.5, 0]) {
    window.dispatchEvent(pointer("pointermove", { x: to.x - 200 * step, y: to.y - 100 * step }, held));
  }
}

/** Where a point of the graph is in the window. */
export function onScreen(point: Point): Point {
  return useView.getState().viewport?.place(point) ?? point;
}

/** Where the middle of a vertex is in the window; `down` px lower. */
export function middleOf(id: string, down = 0): Point {
  const node = currentDrawing()?.nodes.get(id);
  if (node === undefined) throw new Error(`no ${id}`);
  return onScreen({ x: node.x + node.w / 2, y: node.y + node.h / 2 + down });
}

/** Where the middle of an arc is in the window. */
export function middleOfArc(id: string): Point {
  const arc = currentDrawing()?.layout.arcs.find((one) => one.id === id);
  const [from, to] = [arc?.points[0], arc?.points[1]];
  if (from === undefined || to === undefined) throw new Error(`no arc ${id}`);
  return onScreen({ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 });
}

export function graphHands(page: Mounted): Omit<Graph, keyof Mounted> {
  const settle = () => act(() => new Promise<void>((done) => setTimeout(done)));
  const until = (fact: () => void) =>
    vi.waitFor(
      async () => {
        await settle();
        fact();
      },
      { timeout: 20_000, interval: 2 },
    );
  const all = (testId: string) => {
    const how = testId.endsWith("*") ? `^="${testId.slice(0, -1)}"` : `="${testId}"`;
    return [...document.querySelectorAll<HTMLElement>(`[data-testid${how}]`)];
  };
  return {
    ...handsOn({ ...page, place: document.body }),
    all,
    until,
    key: async (key, held = {}) => {
      const at = document.activeElement ?? document.body;
      page.act(() => at.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...held })));
      await settle();
    },
    type: async (text) => {
      const field = document.activeElement;
      if (!(field instanceof HTMLInputElement || field instanceof HTMLTextAreaElement)) throw new Error("no field");
      page.act(() => {
        Object.getOwnPropertyDescriptor(Object.getPrototypeOf(field), "value")?.set?.call(field, text);
        field.dispatchEvent(new Event("input", { bubbles: true }));
      });
      await settle();
    },
    undo: () => page.act(() => useStudio.getState().undo()),
    rightClick: async (testId) => {
      const [at] = all(testId);
      page.act(() => at?.dispatchEvent(new MouseEvent("contextmenu", { bubbles: true, cancelable: true })));
      await until(() => expect(document.querySelector("[role=menu]")).not.toBeNull());
    },
    carry: async (from, to, held) => {
      page.act(() => carry(from, to, held));
      await settle();
    },
    drop: async (to, held) => {
      page.act(() => window.dispatchEvent(pointer("pointerup", to, held)));
      // The click that a browser makes of it.
      page.act(() => document.body.click());
      await settle();
    },
  };
}

/** Elements of the program in view, in the order of reading. */
export function elements(): string[] {
  return (currentDrawing()?.program.vertices ?? []).map(({ element }) => element);
}

/** Ends what a test opened on the canvas. */
export function leaveGraph(page: Graph): void {
  page.end();
  vi.restoreAllMocks();
  useView.setState(useView.getInitialState());
}
