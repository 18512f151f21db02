import { describe, expect, it } from "vitest";

import { useRun } from "../../session/run";
import { samplesNow, seriesOf, stepsPath, takeSamples } from "./samples";

const agent = (values: Record<string, number>) => ({
  ...{ name: "a", program: "p", robot: "r", number: 1, kind: "robot", active: [], state: "running" as const },
  ...{ inputs: {}, values, fault: 0, forced: [], shown: {}, placed: true },
});

function at(tick: number, count: number, latest = tick) {
  useRun.setState({ tick, latest, agents: [agent({ Count: count })] });
}

describe("samples of a run", () => {
  it("follow the run, and forget a future that is no more", () => {
    const end = takeSamples();
    // Tells those that take samples that another run begins.
    useRun.getState().reset();
    at(1, 5);
    at(2, 6);
    at(3, 7);
    at(1, 5, 3);
    expect(seriesOf(samplesNow(), "a", "Count")).toEqual([
      [1, 5],
      [2, 6],
      [3, 7],
    ]);
    at(2, 9, 2);
    expect(seriesOf(samplesNow(), "a", "Count")).toEqual([
      [1, 5],
      [2, 9],
    ]);
    useRun.getState().reset();
    expect(samplesNow()).toEqual([]);
    end();
  });

  it("are drawn as steps", () => {
    const path = stepsPath(
      [
        [0, 0],
        [5, 10],
      ],
      { width: 100, height: 20 },
      { from: 0, to: 10, least: 0, most: 10 },
    );
    expect(path).toBe("M0.0 20.0H50.0V0.0H100.0");
    expect(stepsPath([], { width: 1, height: 1 }, { from: 0, to: 1, least: 0, most: 1 })).toBe("");
  });
});
