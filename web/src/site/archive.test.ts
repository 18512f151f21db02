/** The archive of packages: long names, files of any length, and one that is cut. */
import { expect, test } from "vitest";

import { filesOf } from "./archive";

const BLOCK = 512;

function header(name: string, size: number, prefix = "", kind = "0"): Uint8Array<ArrayBuffer> {
  const block = new Uint8Array(BLOCK);
  const put = (text: string, at: number) => block.set(new TextEncoder().encode(text), at);
  put(name, 0);
  put(`${size.toString(8).padStart(11, "0")}\0`, 124);
  put(kind, 156);
  put(prefix, 345);
  return block;
}

function archive(...blocks: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(blocks.reduce((sum, one) => sum + Math.ceil(one.length / BLOCK) * BLOCK, 0));
  let at = 0;
  for (const block of blocks) {
    whole.set(block, at);
    at += Math.ceil(block.length / BLOCK) * BLOCK;
  }
  return whole;
}

const end = new Uint8Array(2 * BLOCK);
const long = "n".repeat(100);

test("files come out as they went in, whatever their names and lengths; folders are none", () => {
  const exact = new Uint8Array(BLOCK).fill(7);
  const made = archive(
    header("a/é.py", 3),
    new Uint8Array([1, 2, 3]),
    header(long, 0, "deep/er"),
    header("folder/", 0, "", "5"),
    header("exact", BLOCK),
    exact,
    end,
  );
  expect([...filesOf(made)]).toEqual([
    ["a/é.py", new Uint8Array([1, 2, 3])],
    [`deep/er/${long}`, new Uint8Array()],
    ["exact", exact],
  ]);
});

test("an archive that is cut or no archive is told", () => {
  const made = archive(header("a", BLOCK + 1), new Uint8Array(BLOCK + 1));
  expect([...filesOf(made)]).toHaveLength(1);
  expect(() => [...filesOf(made.slice(0, 2 * BLOCK))]).toThrow("damaged");
  expect(() => [...filesOf(new Uint8Array(BLOCK).fill(65))]).toThrow("damaged");
});
