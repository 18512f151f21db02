/** Packed files: whole, empty, cut off anywhere, damaged. */
import { expect, test } from "vitest";

import { unpacked } from "./unpacking";

/** `KitRobot ` four thousand times, as Python's `lzma` packs it. */
const PACKED =
  "/Td6WFoAAAFpIt42AgAhARwAAAAQz1jM4IyfAE5dACWaSoUrfdddrmgODv1nhlALVTzLu8JYQ2T3RCbWrq7qBq212+VvOZJL2QkIO6uqmol5dPP5Pl8qSaaP" +
  "6/H/ugALOlPprgKMfxCEdpYAAAAAAMENQ8IAAWagmQIAAEzdE64+MA2LAgAAAAABWVo=";

const whole = Uint8Array.from(atob(PACKED), (letter) => letter.charCodeAt(0));

/** As a network hands it out. */
function stream(bytes: Uint8Array<ArrayBuffer>, size: number): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new ReadableStream({
    start(controller) {
      for (let at = 0; at < bytes.length; at += size) controller.enqueue(bytes.slice(at, at + size));
      controller.close();
    },
  });
}

test.each([1, 7, 1000])("is unpacked from pieces of %d bytes", async (size) => {
  const made = await unpacked(stream(whole, size));
  expect(new TextDecoder().decode(made)).toBe("KitRobot ".repeat(4000));
});

test("is refused wherever it is cut off", async () => {
  for (let length = 0; length < whole.length; length += 5) {
    await expect(unpacked(stream(whole.slice(0, length), 50)), String(length)).rejects.toThrow();
  }
});

test("gives nothing else where a bit is another one", async () => {
  let refused = 0;
  for (let at = 0; at < whole.length; at++) {
    const damaged = whole.slice();
    damaged[at] = (damaged[at] ?? 0) ^ 4;
    const made = await unpacked(stream(damaged, 50)).catch(() => null);
    if (made === null) refused += 1;
    else expect(new TextDecoder().decode(made), String(at)).toBe("KitRobot ".repeat(4000));
  }
  // One byte of a block says nothing.
  expect(refused).toBe(whole.length - 1);
});

test("a connection that breaks off is no end", async () => {
  const broken = new ReadableStream<Uint8Array<ArrayBuffer>>({
    start(controller) {
      controller.enqueue(whole.slice(0, 40));
    },
    pull(controller) {
      controller.error(new TypeError("gone"));
    },
  });
  await expect(unpacked(broken)).rejects.toThrow("gone");
  await expect(unpacked(stream(whole, 50))).resolves.toHaveLength(36_000);
});
