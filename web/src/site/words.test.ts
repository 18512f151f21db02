import { afterEach, expect, it, vi } from "vitest";

import { Words } from "./words";

const FILES = { fr: "kitrobot/translation/fr.po" };

async function packed(text: string): Promise<Response> {
  const stream = new CompressionStream("deflate");
  const writer = stream.writable.getWriter();
  const written = writer.write(new TextEncoder().encode(text)).then(() => writer.close());
  const bytes = await new Response(stream.readable).arrayBuffer();
  await written;
  return new Response(bytes);
}

/** What is fetched, by what answers. */
function answering(answer: () => Promise<Response>): string[] {
  const asked: string[] = [];
  vi.stubGlobal("fetch", (address: URL) => {
    asked.push(address.href);
    return answer();
  });
  return asked;
}

afterEach(() => vi.unstubAllGlobals());

it("brings the sentences of a language once, before whoever waits for them goes on", async () => {
  const asked = answering(() => packed("msgid"));
  const written: [string, string][] = [];
  const words = new Words("http://site/", FILES, (name, bytes) =>
    written.push([name, new TextDecoder().decode(bytes)]),
  );
  await Promise.all([words.have("fr"), words.have("fr")]);
  await words.have("fr");
  expect(asked).toEqual(["http://site/words/fr.po.zlib"]);
  expect(written).toEqual([["kitrobot/translation/fr.po", "msgid"]]);
});

it("fetches nothing for English, an unknown language and names of every object", async () => {
  const asked = answering(() => packed(""));
  const words = new Words("http://site/", FILES, () => undefined);
  for (const language of ["en", "xx", "", "constructor"]) await words.have(language);
  expect(asked).toEqual([]);
});

it("goes on in English where they cannot be fetched, and tries again", async () => {
  const warned = vi.spyOn(console, "warn").mockReturnValue();
  const asked = answering(() => Promise.resolve(new Response("", { status: 404 })));
  const words = new Words("http://site/", FILES, () => undefined);
  await words.have("fr");
  await words.have("fr");
  expect(asked.length).toBe(2);
  expect(warned).toHaveBeenCalledTimes(2);
  warned.mockRestore();
});
