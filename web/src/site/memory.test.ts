/** Python's memory between two visits: what comes back, and what is as if it were not there. */
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { forgetMemory, KeptMemory } from "./memory";

const BASE = "http://127.0.0.1:8000/kit/";
const memory = () => ({ bytes: new Uint8Array([1, 2, 3, 4]), table: 77 });
const places = new Map<string, Map<string, Response>>();
let free = 1000;

/** As the browser's caches; `match` gives a response that can be read once more. */
const caches = {
  open: (name: string) => {
    const place = places.get(name) ?? new Map<string, Response>();
    places.set(name, place);
    return Promise.resolve({
      match: (asked: URL) => Promise.resolve(place.get(asked.href)?.clone()),
      put: async (asked: URL, response: Response) => {
        const { headers } = response;
        place.set(asked.href, new Response(await response.arrayBuffer(), { headers }));
      },
    });
  },
  delete: (name: string) => Promise.resolve(places.delete(name)),
};

beforeEach(() => {
  places.clear();
  free = 1000;
  vi.stubGlobal("caches", caches);
  Object.defineProperty(navigator, "storage", {
    value: { estimate: () => Promise.resolve({ quota: free, usage: 0 }) },
    configurable: true,
  });
});
afterEach(() => vi.unstubAllGlobals());

test("it comes back as it was, for the same version, and not for another", async () => {
  await new KeptMemory(BASE, "1").keep(memory());
  expect(await new KeptMemory(BASE, "1").find()).toEqual(memory());
  expect(await new KeptMemory(BASE, "2").find()).toBeNull();
  expect(await new KeptMemory(`${BASE}other/`, "1").find()).toBeNull();
});

test("one of a new version takes the place of the old one, and each can be thrown away", async () => {
  await new KeptMemory(BASE, "1").keep(memory());
  await new KeptMemory(BASE, "2").keep(memory());
  expect(await new KeptMemory(BASE, "1").find()).toBeNull();
  expect(await new KeptMemory(BASE, "2").find()).toEqual(memory());
  expect(await forgetMemory(BASE)).toBe(true);
  expect(await forgetMemory(BASE)).toBe(false);
  expect(await new KeptMemory(BASE, "2").find()).toBeNull();
});

test("a large one comes back whole", async () => {
  free = 20_000_000;
  const bytes = Uint8Array.from({ length: 2_500_001 }, (_, at) => at % 251);
  await new KeptMemory(BASE, "1").keep({ bytes: bytes.slice(), table: 7 });
  expect((await new KeptMemory(BASE, "1").find())?.bytes).toEqual(bytes);
});

test("its bytes are given back, whether it is kept or not", async () => {
  for (free of [1000, 15]) {
    const made = memory();
    await new KeptMemory(BASE, "1").keep(made);
    expect(made.bytes).toHaveLength(0);
  }
});

test("one that is cut off is none", async () => {
  await new KeptMemory(BASE, "1").keep(memory());
  for (const place of places.values()) {
    for (const [address, { headers }] of place) place.set(address, new Response(memory().bytes.slice(1), { headers }));
  }
  expect(await new KeptMemory(BASE, "1").find()).toBeNull();
});

test("where there is little room, or no place at all, none is kept", async () => {
  free = 15;
  await new KeptMemory(BASE, "1").keep(memory());
  expect(await new KeptMemory(BASE, "1").find()).toBeNull();
  vi.unstubAllGlobals();
  await new KeptMemory(BASE, "1").keep(memory());
  expect(await new KeptMemory(BASE, "1").find()).toBeNull();
  expect(await forgetMemory(BASE)).toBe(false);
});
