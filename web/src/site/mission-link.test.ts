/** Links with missions in them: whole, cut, hostile, too large. */
import { expect, test } from "vitest";

import { holdsMission, linkTo, MOST_BYTES, MOST_LETTERS, missionOf } from "./mission-link";

const TEXT = '<kitrobot version="1">…\n  <program name="blink" robot="mini-robot"/>\n</kitrobot>\n';

async function fault(hash: string): Promise<string> {
  return missionOf(hash).then(
    () => "none",
    (cause: unknown) => (cause as { fault?: string }).fault ?? String(cause),
  );
}

test("a mission comes out of a link as it went in, with its name", async () => {
  const link = await linkTo(TEXT, "mein Blinken.krt");
  expect(link).toMatch(/^mission=[\w-]+&name=mein%20Blinken\.krt$/);
  expect(holdsMission(`#${link}`)).toBe(true);
  const { name, bytes } = await missionOf(`#${link}`);
  expect(name).toBe("mein Blinken.krt");
  expect(new TextDecoder().decode(bytes)).toBe(TEXT);
});

test("a name in a link is a file's name and no path", async () => {
  const [mission] = (await linkTo(TEXT, "")).split("&");
  expect((await missionOf(`#${mission}&name=../../etc/<b>x</b>`)).name).toBe("....etcbxb.krt");
  expect((await missionOf(`#${mission}&name=${"n".repeat(5000)}`)).name).toBe(`${"n".repeat(80)}.krt`);
  expect((await missionOf(`#${mission}`)).name).toBe("mission.krt");
});

test("what holds no mission is none", () => {
  expect(holdsMission("")).toBe(false);
  expect(holdsMission("#else")).toBe(false);
});

test("a link that is cut, or no link of ours, is damaged", async () => {
  const link = await linkTo(TEXT.repeat(50), "x");
  const letters = link.slice("mission=".length).replace(/&.*/, "");
  expect(await fault(`#mission=${letters.slice(0, -6)}`)).toBe("site.link-damaged");
  for (const wrong of ["", "%00", "a", "////", "<script>", "A".repeat(999)]) {
    expect(await fault(`#mission=${wrong}`), wrong).toBe("site.link-damaged");
  }
});

/** What `linkTo` makes of a text, however long. */
async function letters(text: string): Promise<string> {
  const packing = new CompressionStream("deflate-raw");
  const writer = packing.writable.getWriter();
  void writer.write(new TextEncoder().encode(text)).then(() => writer.close());
  const bytes = new Uint8Array(await new Response(packing.readable).arrayBuffer());
  return btoa(String.fromCharCode(...bytes))
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replace(/=+$/, "");
}

test("a link of ten megabytes, and one that would unpack to more than a mission, are too long", async () => {
  expect(await fault(`#mission=${"A".repeat(10_000_000)}`)).toBe("site.link-long");
  const spaces = await letters(" ".repeat(MOST_BYTES + 1));
  expect(spaces.length).toBeLessThan(MOST_LETTERS / 10);
  expect(await fault(`#mission=${spaces}&name=bomb`)).toBe("site.link-long");
  // No link is made that could not be opened.
  await expect(linkTo(" ".repeat(MOST_BYTES + 1), "bomb")).rejects.toMatchObject({ fault: "site.link-long" });
  const most = await missionOf(`#${await linkTo(" ".repeat(MOST_BYTES), "most")}`);
  expect(most.bytes.length).toBe(MOST_BYTES);
});
