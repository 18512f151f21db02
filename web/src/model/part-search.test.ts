import { describe, expect, it } from "vitest";

import { partsOf } from "./parts";
import { elsewhere, plain, rank } from "./part-search";
import { CARRIER_PARTS as PARTS } from "./testing/missions";
import { PARTS as CATALOGUE } from "./testing/parts";
import type { Catalogue } from "./types";

const words = { "": ["go", "straight on"], fr: ["à gauche"] };

/** The carrier with words for its wheels, and another robot without them. */
function searched(): Catalogue {
  const [carrier] = CATALOGUE.robots.filter(({ name }) => name === "carrier");
  if (carrier === undefined) throw new Error("no carrier");
  const objects = carrier.objects.map((one) => ({
    ...one,
    methods: one.methods.map((method) => (method.name === "Advance" ? { ...method, words } : method)),
  }));
  const bare = { ...carrier, name: "bare", label: { "": "Bare" }, objects: [] };
  return { ...CATALOGUE, robots: [{ ...carrier, label: { "": "Carrier" }, objects }, bare] };
}

describe("rank", () => {
  it("takes words of names in any order and case", () => {
    expect(rank(PARTS.shape("Wheel.Advance"), "adv WHEEL")).toBe(1);
    expect(rank(PARTS.shape("Wheel.Advance"), "adv lamp")).toBeNull();
  });

  it("has the beginning of a name first, then of its words, then the words of its XML, then any letters", () => {
    const advance = partsOf(searched(), "carrier").shape("Wheel.Advance");
    expect(["wheel a", "adv", "straight", "vance"].map((query) => rank(advance, query))).toEqual([0, 0, 2, 3]);
    expect(rank(PARTS.shape("Wheel.Advance"), "straight")).toBeNull();
  });

  it("takes several words at once, the middle of a phrase and a plural, and no middle of a word of the XML", () => {
    const advance = partsOf(searched(), "carrier").shape("Wheel.Advance");
    expect(["go straight", "straight on", "gos", "on"].map((query) => rank(advance, query))).toEqual([2, 2, 2, 2]);
    expect(rank(advance, "traight")).toBeNull();
  });

  it("finds everything by nothing", () => {
    expect(rank(PARTS.shape("Wheel.Advance"), "  ")).toBe(0);
  });
});

describe("plain", () => {
  it("leaves accents and capitals out, and writes Urdu letters one way", () => {
    expect(plain("Éteindre à côté")).toBe("eteindre a cote");
    expect(plain("كي")).toBe(plain("کی"));
  });
});

describe("elsewhere", () => {
  it("names the other robots that can do it, with their parts", () => {
    const catalogue = searched();
    const found = elsewhere(catalogue, partsOf(catalogue, "bare"), "straight");
    expect(found).toEqual([{ robot: "Carrier", parts: ["Wheel Advance"] }]);
  });

  it("is nothing for what no robot can do, for constructors, and for nothing typed", () => {
    const catalogue = searched();
    const bare = partsOf(catalogue, "bare");
    for (const query of ["xyz", "repetition", " "]) expect(elsewhere(catalogue, bare, query)).toEqual([]);
  });
});
