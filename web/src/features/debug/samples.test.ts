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
    expect(path).toBe("M0 20.0H50V0.0H100");
    expect(stepsPath([], { width: 1, height: 1 }, { from: 0, to: 1, least: 0, most: 1 })).toBe("");
  });

  it("are a path no longer than the box is wide, that reaches as far and ends where they do", () => {
    const series = Array.from({ length: 20_000 }, (_, tick): [number, number] => [tick, (tick * 7919) % 101]);
    const span = { from: 0, to: 20_000, least: 0, most: 100 };
    const path = stepsPath(series, { width: 72, height: 100 }, span);
    expect(path.length).toBeLessThan(72 * 2 * 80);
    const levels = Array.from(path.matchAll(/V([\d.]+)/g), ([, level]) => Number(level));
    expect([Math.min(...levels), Math.max(...levels)]).toEqual([0, 100]);
    expect(levels.at(-1)).toBe(100 - (series.at(-1)?.[1] ?? 0));
    expect(path.endsWith("H72")).toBe(true);
  });

  it("say nothing anew where nothing changes, and keep where a column ends", () => {
    const box = { width: 10, height: 10 };
    const flat = Array.from({ length: 1000 }, (_, tick): [number, number] => [tick, 3]);
    expect(stepsPath(flat, box, { from: 0, to: 1000, least: 3, most: 3 })).toBe("M0 5.0H10");
    const spike: [number, number][] = [
      [0, 0],
      [500, 10],
      [501, 5],
      [900, 10],
    ];
    expect(stepsPath(spike, box, { from: 0, to: 1000, least: 0, most: 10 })).toBe("M0 10.0H5V0.0V5.0H9V0.0H10");
  });
});
