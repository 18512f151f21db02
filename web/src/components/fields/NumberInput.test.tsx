import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords, speak } from "../../i18n/words";
import { mount, type Mounted } from "../../testing/hooks";
import { NumberInput } from "./NumberInput";

const keep = vi.fn<(value: number | null, stepped: boolean) => void>();
let page: Mounted;

beforeEach(async () => {
  await speak("en");
  await moreWords();
});
afterEach(() => {
  page.end();
  keep.mockClear();
});

const field = () => page.place.querySelector("input") as HTMLInputElement;
const why = () => page.place.querySelector("[role=alert]")?.textContent ?? "";

function type(text: string): void {
  page.act(() => {
    // As a person types: React keeps the value that its own setter was given.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field(), text);
    field().dispatchEvent(new Event("input", { bubbles: true }));
  });
}
function press(key: string, held: KeyboardEventInit = {}): void {
  page.act(() =>
    field().dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...held })),
  );
}

describe("a number that is typed", () => {
  it.each([
    ["۲٫۵", "Enter", 2.5],
    ["٩", "Enter", 9],
    ["7,25", "F5", 7.25],
    ["7", "s", 7],
    ["101", "Enter", 100],
    ["-۱", "Enter", 0],
  ])("%s and %s stores %d", (typed, key, number) => {
    page = mount(<NumberInput testId="n" min={0} max={100} value={50} keep={keep} />);
    type(typed);
    expect(keep).not.toHaveBeenCalled();
    press(key, { ctrlKey: key === "s" });
    expect(keep.mock.calls).toEqual([[number, false]]);
  });

  it("that is none is told from what it was, and taken back", () => {
    page = mount(<NumberInput testId="n" min={0} max={100} value={50} keep={keep} />);
    for (const typed of ["0x10", "1e1", "much", ""]) {
      type(typed);
      expect([field().getAttribute("aria-invalid"), why()]).toEqual(["true", "Type a number from 0 to 100."]);
      press("Enter");
      expect([field().value, why()]).toEqual(["50", ""]);
    }
    expect(keep).not.toHaveBeenCalled();
  });

  it("out of the range says what Enter stores, and Escape goes back", () => {
    page = mount(<NumberInput testId="n" min={0} max={100} value={50} whole keep={keep} />);
    type("۱۰۱");
    expect(why()).toBe("At most 100. Enter keeps 100.");
    type("2.5");
    expect(why()).toBe("Type a whole number from 0 to 100.");
    press("Escape");
    expect(field().value).toBe("50");
    expect(keep).not.toHaveBeenCalled();
  });

  it("is stepped by the arrows from what was typed, and stays in the range", () => {
    page = mount(<NumberInput testId="n" min={0} max={100} step={5} value={90} keep={keep} />);
    press("ArrowDown");
    type("۲۰");
    press("ArrowUp");
    press("ArrowUp", { shiftKey: true });
    expect(keep.mock.calls).toEqual([
      [85, true],
      [25, true],
      [100, true],
    ]);
  });

  it("may be left empty where it is optional", () => {
    page = mount(<NumberInput testId="n" min={1} max={100} optional value={50} keep={keep} />);
    type("");
    expect(why()).toBe("");
    press("Enter");
    expect(keep.mock.calls).toEqual([[null, false]]);
  });
});
