import { expect, it } from "vitest";

import { MENUS } from "../session/menu-table";
import { renderHook } from "../testing/hooks";
import { isItem } from "../ui/menu-model";
import { useMenus } from "./menus";
import { FEATURES } from "./features";

const hook = renderHook(useMenus);
const menus = hook.value();
hook.end();

it("are those of the table, in its order, each with entries", () => {
  expect(menus.map(({ id }) => id)).toEqual(MENUS.map(({ id }) => id));
  for (const { id, entries } of menus) expect(entries.some(isItem), id).toBe(true);
});

it("name each entry once, and have a line between two sections only", () => {
  for (const { entries } of menus) {
    const ids = entries.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    const kinds = entries.map(({ kind }) => kind);
    expect([kinds[0], kinds.at(-1)]).not.toContain("line");
    expect(kinds.some((kind, at) => kind === "line" && kinds[at + 1] === "line")).toBe(false);
  }
});

it("have every entry that a feature names words for, so that none is lost when one is renamed", () => {
  const listed = new Set(menus.flatMap(({ entries }) => entries.map(({ id }) => id)));
  const named = FEATURES.flatMap(({ words }) => Object.keys(words ?? {}));
  expect(named.length).toBeGreaterThan(10);
  expect(named.filter((id) => !listed.has(id))).toEqual([]);
});
