import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { moreWords, speak } from "../../i18n/words";
import type { RobotObject } from "../../model/types";
import { useRun } from "../../session/run";
import { mount, type Mounted } from "../../testing/hooks";
import { Plot } from "./Plot";
import { takeSamples } from "./samples";

const DISTANCE = {
  ...{ name: "Captor", label: { "": "Distance" }, help: {}, category: "sensor", type: "integer", min: 0, max: 1000 },
  ...{ unit: "mm", meaning: { scale: "0.1", units: { "": "cm", ur: "سم" } } },
} as unknown as RobotObject;
const AHEAD = { ...DISTANCE, name: "Ahead", type: "boolean", unit: "", meaning: null } as RobotObject;

let end: () => void;
let page: Mounted | null = null;
beforeEach(async () => {
  await speak("en");
  await moreWords();
  end = takeSamples();
  // Tells those that take samples that another run begins.
  useRun.getState().reset();
});
afterEach(() => {
  page?.end();
  page = null;
  end();
});

function measured(name: string, ...values: number[]): void {
  values.forEach((value, at) => {
    const agent = {
      ...{ name: "a", program: "p", robot: "r", number: 1, kind: "robot", active: [], state: "running" as const },
      ...{ inputs: { [name]: value }, values: {}, fault: 0, forced: [], shown: {}, placed: true },
    };
    useRun.setState({ tick: at + 1, latest: at + 1, agents: [agent] });
  });
}

function drawn(object: RobotObject, value: number) {
  page = mount(<Plot agent="a" object={object} label="Distance" value={value} />);
  return {
    figures: [...page.place.querySelectorAll(".watch-figures > span")].map((one) => one.textContent),
    now: [...page.place.querySelectorAll('.watch-figures > [data-now="true"]')].map((one) => one.textContent).join(""),
    said: page.place.querySelector('[role="img"]')?.getAttribute("aria-label"),
    line: page.place.querySelector(".watch-line")?.getAttribute("d"),
  };
}

describe("the plot of a value", () => {
  it("says the most, the present and the least value with their unit, scaled to what was seen", () => {
    measured("Captor", 300, 705, 400);
    expect(drawn(DISTANCE, 400)).toEqual({
      figures: ["70.5 cm", "40 cm", "30 cm"],
      now: "40 cm",
      said: "Distance over time: at least 30 cm, at most 70.5 cm, now 40 cm",
      line: "M0 32.0H36V0.0H72V24.1H72",
    });
  });

  it("says a value once: where it is the most or the least, and where it never changed", () => {
    measured("Captor", 300, 705);
    expect(drawn(DISTANCE, 705)).toMatchObject({ figures: ["70.5 cm", "", "30 cm"], now: "70.5 cm" });
    page?.end();
    useRun.getState().reset();
    measured("Captor", 300, 300);
    expect(drawn(DISTANCE, 300)).toMatchObject({ figures: ["", "30 cm", ""], line: "M0 16.0H72" });
  });

  it("says what is true or false in the words of the graph", () => {
    measured("Ahead", 0, 1);
    expect(drawn(AHEAD, 1).figures).toEqual(["true", "", "false"]);
  });

  it("speaks the reader's language", async () => {
    await speak("ur");
    await moreWords();
    measured("Captor", 300, 705, 400);
    expect(drawn(DISTANCE, 400).figures).toEqual(["70.5 سم", "40 سم", "30 سم"]);
  });
});
