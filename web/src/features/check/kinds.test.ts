import { beforeAll, expect, test } from "vitest";

import { moreWords } from "../../i18n/words";
import { kindChoices, kindsOf, USUAL, valueOf, withKinds } from "./kinds";

beforeAll(moreWords);

test("a failure is one of the usual kinds unless another is chosen, and then it says which", () => {
  expect(kindChoices()[0]).toEqual([valueOf(USUAL), "fails or stalls"]);
  for (const [value] of kindChoices()) expect(valueOf(kindsOf(value))).toBe(value);
  expect(kindsOf("rust")).toBe(USUAL);
  expect(withKinds("1 failure", USUAL)).toBe("1 failure");
  expect(withKinds("1 failure", ["mute"])).toBe("1 failure: loses its radio");
});
