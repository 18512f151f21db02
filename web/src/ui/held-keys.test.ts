/** What is pasted while a field is being fetched comes into it, or is forgotten with it; keys need a real browser. */
import { afterEach, expect, it, vi } from "vitest";

import { holdKeys } from "./held-keys";

const insert = vi.fn();

function paste(text: string): boolean {
  const event = Object.assign(new Event("paste", { cancelable: true, bubbles: true }), {
    clipboardData: { getData: () => text },
  });
  document.body.dispatchEvent(event);
  return event.defaultPrevented;
}

afterEach(() => insert.mockClear());

it("text that is pasted meanwhile comes in its order", async () => {
  document.execCommand = insert;
  const release = holdKeys();
  expect([paste("WAIT(7);"), paste("WAIT(8);")]).toEqual([true, true]);
  expect(insert).not.toHaveBeenCalled();
  release(true);
  await vi.waitFor(() => expect(insert).toHaveBeenCalledTimes(2));
  expect(insert.mock.calls.map(([, , text]) => text as string)).toEqual(["WAIT(7);", "WAIT(8);"]);
  await vi.waitFor(() => expect(paste("x")).toBe(false));
});

it("is forgotten where the field does not come, and a picture is none", () => {
  const release = holdKeys();
  expect([paste(""), paste("WAIT(7);")]).toEqual([false, true]);
  release(false);
  expect([insert.mock.calls.length, paste("x")]).toEqual([0, false]);
});
