/** What a person does to fields and buttons of a tree that is mounted, each found by its test id. */
import type { Mounted } from "./hooks";

export interface Hands {
  find: <T extends HTMLElement = HTMLElement>(testId: string) => T;
  has: (testId: string) => boolean;
  click: (testId: string) => void;
  fill: (testId: string, text: string) => void;
  choose: (testId: string, value: string) => void;
  press: (testId: string, key: string, held?: KeyboardEventInit) => void;
}

/** React keeps the value that its own setter was given: a person's comes through that of the element. */
function put(field: HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement, value: string): void {
  Object.getOwnPropertyDescriptor(Object.getPrototypeOf(field), "value")?.set?.call(field, value);
}

export function handsOn(page: Mounted): Hands {
  const at = (testId: string) => page.place.querySelector<HTMLElement>(`[data-testid="${testId}"]`);
  const find = <T extends HTMLElement>(testId: string) => {
    const found = at(testId);
    if (found === null) throw new Error(`there is no ${testId}`);
    return found as T;
  };
  return {
    find,
    has: (testId) => at(testId) !== null,
    click: (testId) => page.act(() => find(testId).click()),
    fill: (testId, text) => {
      const field = find<HTMLInputElement | HTMLTextAreaElement>(testId);
      page.act(() => {
        put(field, text);
        field.dispatchEvent(new Event("input", { bubbles: true }));
      });
    },
    choose: (testId, value) => {
      const field = find<HTMLSelectElement>(testId);
      page.act(() => {
        put(field, value);
        field.dispatchEvent(new Event("change", { bubbles: true }));
      });
    },
    press: (testId, key, held = {}) => {
      page.act(() =>
        find(testId).dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...held })),
      );
    },
  };
}
