import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords, speak, t } from "../../i18n/words";
import type { Field } from "../../model/parts";
import { mount, type Mounted } from "../../testing/hooks";
import { Choices } from "./Choices";
import { Piano } from "./Piano";

const set = vi.fn<(value: number) => void>();
const tones: number[] = [];

/** Keeps the tones that it is asked for: jsdom has no sound. */
class Speaker {
  currentTime = 0;
  destination = {};
  createGain() {
    return { gain: { setValueAtTime: () => 0, setTargetAtTime: () => 0 }, connect: () => 0 };
  }
  createOscillator() {
    const frequency = { setValueAtTime: (hz: number) => tones.push(hz) };
    return { type: "", frequency, connect: () => this.createGain(), start: () => 0, stop: () => 0 };
  }
}

let page: Mounted;
beforeEach(async () => {
  vi.stubGlobal("AudioContext", Speaker);
  await speak("en");
  await moreWords();
});
afterEach(() => {
  page.end();
  set.mockClear();
  tones.length = 0;
  vi.unstubAllGlobals();
});

const control = (field: Partial<Field>, value: number) => ({
  ...{ field: { name: "f", kind: "integer", scale: 1, unit: "", ...field } as Field, value, label: "Value" },
  ...{ set, leave: () => false, onFocus: () => undefined },
});
const radios = () => [...page.place.querySelectorAll<HTMLElement>('[role="radio"]')];
const checked = () => radios().filter((one) => one.getAttribute("aria-checked") === "true");
const named = (name: string) => radios().find((one) => one.getAttribute("aria-label") === name);
function press(on: HTMLElement | undefined, key: string): void {
  page.act(() => on?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));
}

describe("the piano", () => {
  const piano = (value: number) => (page = mount(<Piano {...control({ min: 0, max: 10_000 }, value)} />));

  it("has the keys of an octave and a half by name, and the chosen note is pressed", () => {
    piano(440);
    expect(radios().map((one) => one.getAttribute("aria-label"))).toEqual(
      "C C♯ D D♯ E F F♯ G G♯ A A♯ B".split(" ").concat("C 5,C♯ 5,D 5,D♯ 5,E 5".split(",")),
    );
    expect(checked()).toEqual([named("A")]);
  });

  it("chooses the note of a key that is clicked, and it sounds", () => {
    piano(440);
    page.act(() => named("C")?.click());
    expect(set).toHaveBeenLastCalledWith(262);
    expect(tones).toEqual([262]);
  });

  it("goes a semitone up and down with the arrows, and to its ends", () => {
    piano(440);
    const notes = ["ArrowRight", "ArrowLeft", "Home", "End"].map((key) => {
      press(named("A"), key);
      return set.mock.lastCall?.[0];
    });
    expect(notes).toEqual([466, 415, 262, 659]);
  });

  it("takes the note into another octave", () => {
    piano(440);
    page.act(() => page.place.querySelector<HTMLElement>(`[aria-label="${t("fields.higher")}"]`)?.click());
    expect(set).toHaveBeenLastCalledWith(880);
    expect(page.place.querySelector(".piano-octave")?.textContent).toContain("5");
  });
});

describe("pictures of five by five lights", () => {
  const choices = [
    { value: 0, label: { "": "heart" }, lights: "09090 99999 99999 09990 00900" },
    { value: 1, label: { "": "dot" }, lights: "00000 00000 00900 00000 00000" },
  ];
  const lights = (value: number) =>
    (page = mount(
      <Choices {...control({ min: 0, max: 1, meaning: { choices } }, value)} testid="lights" focused={false} />,
    ));
  /** Column and row of each light of a picture that is on. */
  const on = (path: Element | null | undefined) =>
    [...(path?.getAttribute("d") ?? "").matchAll(/M(\d) (\d)/g)].map(([, x, y]) => `${x ?? ""}${y ?? ""}`);

  it("are named, show their lights, and the chosen one stands beside them large", () => {
    lights(1);
    expect(radios().map((one) => one.getAttribute("aria-label"))).toEqual(["heart", "dot"]);
    expect(on(named("heart")?.querySelector("path"))).toHaveLength(16);
    expect(on(named("dot")?.querySelector("path"))).toEqual(["22"]);
    expect(checked()).toEqual([named("dot")]);
    expect(on(page.place.querySelector(".choices-large .lights-on"))).toEqual(["22"]);
    expect(on(page.place.querySelector(".choices-large .lights-off"))).toHaveLength(25);
  });

  it("are chosen with a click and with the arrows, round the end", () => {
    lights(1);
    page.act(() => named("heart")?.click());
    expect(set).toHaveBeenLastCalledWith(0);
    set.mockClear();
    press(named("dot"), "ArrowRight");
    expect(set).toHaveBeenLastCalledWith(0);
    expect(document.activeElement).toBe(named("heart"));
  });
});
