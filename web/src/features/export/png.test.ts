import { expect, it } from "vitest";

import { withText } from "./pictures";

it("puts a text behind the head of a PNG, with its length and check sum", () => {
  const png = Uint8Array.from({ length: 45 }, (_, index) => index);
  const made = withText(png, "k", "é");
  expect([...made.subarray(0, 33)]).toEqual([...png.subarray(0, 33)]);
  expect([...made.subarray(-12)]).toEqual([...png.subarray(33)]);
  const chunk = made.subarray(33, -12);
  expect([...chunk.subarray(0, 8)]).toEqual([0, 0, 0, 8, ...new TextEncoder().encode("iTXt")]);
  expect([...chunk.subarray(8, -4)]).toEqual([0x6b, 0, 0, 0, 0, 0, 0xc3, 0xa9]);
  // As zlib counts it.
  expect(new DataView(made.buffer).getUint32(made.length - 16)).toBe(0xc3994919);
});
