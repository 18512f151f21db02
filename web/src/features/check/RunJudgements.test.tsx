/** What the card of a run says of the mission's own properties. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { Judgement } from "../../api/generated";
import { traceApi } from "../../api/traces";
import { moreWords } from "../../i18n/words";
import { useRun } from "../../session/run";
import { missionOf } from "../../model/testing/missions";
import { handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { RunJudgements } from "./RunJudgements";

const begun = useRun.getState();
const asked = vi.spyOn(traceApi, "judgements");
let page: Mounted;

function judged(name: string, ruling: Judgement["ruling"], tick: number | null = null): Judgement {
  return { name, ruling, tick, sentence: `never ${name}`, reason: `because of ${name}` };
}

async function show(answer: Promise<Judgement[]>, count = 1): Promise<string> {
  asked.mockReset();
  asked.mockReturnValue(answer);
  const properties = Array.from({ length: count }, (_, at) => ({
    name: String(at),
    form: "never" as const,
    first: "any a (B.IsTrue())",
  }));
  useRun.setState({
    name: "run-1",
    status: "done",
    tickMs: 20,
    abilities: ["seek"],
    mission: { ...missionOf(), properties },
  });
  page = mount(<RunJudgements>{null}</RunJudgements>);
  await vi.waitFor(() => expect(page.place.textContent).not.toBe(properties.length > 0 ? "" : null));
  return page.place.textContent;
}

beforeEach(async () => {
  await moreWords();
});
afterEach(() => {
  page.end();
  useRun.setState(begun);
});

it("names what broke, with its moment, what is not decided, and counts what is kept", async () => {
  const said = await show(
    Promise.resolve([
      judged("both", "broken", 160),
      judged("x", "kept"),
      judged("y", "kept"),
      judged("z", "not decided"),
    ]),
    4,
  );
  expect(said).toContain("Broken after 3.2 s: never both");
  expect(said).toContain("Not decided: z. because of z");
  expect(said).toContain("2 properties are kept.");
});

it("leads to the moment at which a property broke", async () => {
  const seek = vi.fn();
  useRun.setState({ seek });
  await show(Promise.resolve([judged("both", "broken", 160)]));
  handsOn(page).click("judgement-both");
  expect(seek).toHaveBeenCalledExactlyOnceWith(160);
});

it("asks nothing of a mission without properties", async () => {
  expect(await show(Promise.resolve([]), 0)).toBe("");
  expect(asked).not.toHaveBeenCalled();
});

it("says why nothing is known", async () => {
  expect(await show(Promise.reject(new Error("There is no such run any more.")))).toBe(
    "There is no such run any more.",
  );
});
