import { describe, expect, it } from "vitest";

import { ARENA_KEYS } from "../features/arena/keys";
import { chordOf, GRAPH_KEYS, keyIn, type KeyRow } from "../session/key-table";
import { FEATURES } from "./features";
import { keyMeaning } from "./keys";
import { KEYS as PAGE_KEYS } from "./page-keys";
import { linesOf } from "./Shortcuts";

const press = (key: string, more: KeyboardEventInit = {}) => new KeyboardEvent("keydown", { key, ...more });

describe("the table of keys", () => {
  it("writes a press as the table does", () => {
    expect(chordOf(press("S", { ctrlKey: true, shiftKey: true }))).toBe("Ctrl+Shift+S");
    expect(chordOf(press("s", { metaKey: true }))).toBe("Ctrl+S");
    expect(chordOf(press("?", { shiftKey: true }))).toBe("?");
    expect(chordOf(press("ArrowUp", { altKey: true }))).toBe("Alt+↑");
    expect(chordOf(press("PageDown", { altKey: true, shiftKey: true }))).toBe("Alt+Shift+PageDown");
  });

  it("goes by the key's place where a keyboard writes another script", () => {
    expect(keyIn(GRAPH_KEYS, press("ص", { code: "KeyW" }))).toBe("wrap");
    expect(keyIn(GRAPH_KEYS, press("ظ", { code: "KeyZ", shiftKey: true }))).toBe("fit");
    expect(keyIn(PAGE_KEYS, press("؟", { code: "Slash", shiftKey: true }))).toBe("shortcuts");
    expect(keyIn(PAGE_KEYS, press("س", { code: "KeyS", ctrlKey: true }))).toBe("save");
    // A French keyboard has other letters in those places, and is believed.
    expect(keyIn(GRAPH_KEYS, press("z", { code: "KeyW" }))).toBe("zoomSelection");
  });

  it("has no key twice where both would hold", () => {
    const chordsOf = (...tables: Record<string, KeyRow>[]) =>
      tables.flatMap((rows) => Object.values(rows).flatMap((row) => row.chords));
    const ofPage = FEATURES.map(({ keys }) => keys ?? {});
    expect(chordsOf(...ofPage).length).toBeGreaterThan(30);
    for (const chords of [chordsOf(...ofPage, GRAPH_KEYS), chordsOf(...ofPage, ARENA_KEYS)])
      expect(chords.filter((chord, at) => chords.indexOf(chord) !== at)).toEqual([]);
  });

  it("has each key of the page under one name, by one feature", () => {
    const rows = FEATURES.flatMap(({ keys }) => Object.entries<KeyRow>(keys ?? {}));
    for (const [id, row] of rows) expect(row.chords.length, id).toBeGreaterThan(0);
    expect(new Set(rows.map(([id]) => id)).size).toBe(rows.length);
  });

  it("leaves fields their own", () => {
    expect(keyMeaning(press("F5"))).not.toBeNull();
    const field = document.createElement("input");
    document.body.append(field);
    const typed = (event: KeyboardEvent) => {
      let meaning: ReturnType<typeof keyMeaning> = null;
      field.addEventListener("keydown", (one) => (meaning = keyMeaning(one)), { once: true });
      field.dispatchEvent(event);
      return meaning;
    };
    expect(typed(press("z", { ctrlKey: true }))).toBeNull();
    expect(typed(press("?"))).toBeNull();
    expect(typed(press("s", { ctrlKey: true }))).not.toBeNull();
    field.remove();
  });

  it("makes one line of rows with one meaning", () => {
    const wrap = linesOf(GRAPH_KEYS).find((line) => line.says === "help.keys-wrap");
    expect(wrap?.chords).toEqual(["W", "Shift+W"]);
  });
});
