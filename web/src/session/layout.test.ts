import { describe, expect, it } from "vitest";

import { readLayout, USUAL } from "./layout";

describe("the layout", () => {
  it("is the usual one without a memory, or with a broken one", () => {
    expect(readLayout(null).sizes).toEqual(USUAL);
    expect(readLayout("{broken").sizes).toEqual(USUAL);
    expect(readLayout('"a word"').sizes).toEqual(USUAL);
  });

  it("keeps remembered sizes within their limits", () => {
    const { sizes, folded } = readLayout('{"sizes":{"palette":9999,"side":"wide","code":250},"folded":{"arena":true}}');
    expect(sizes).toEqual({ ...USUAL, palette: 400, code: 250 });
    expect(folded).toMatchObject({ arena: true, palette: false });
  });
});
