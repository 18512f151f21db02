"""How the cost of a step grows with the number of robots, as a picture: `python -m benchmarks.growth FILE.svg`.

The swarm of `benchmarks.swarm` under Numba, 10 to 100 000 robots; the line beside it is a cost that grows just with
their number. Both axes are logarithmic.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from benchmarks.__main__ import machine
from benchmarks.measurement import in_turns
from benchmarks.plots import BOTTOM, HEIGHT, LEFT, RIGHT, TOP, WIDTH, Plot
from benchmarks.subjects.simulating import go, hurried
from benchmarks.swarm import swarm

ROBOTS = (10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000)
WORK = 600_000
ROUNDS = 5


def measure() -> list[float]:
    """Milliseconds a step, the median, for each of `ROBOTS`."""
    found = []
    for robots in ROBOTS:
        run, steps = hurried(swarm(robots)), max(1, WORK // robots)
        seconds = in_turns({"": lambda run=run, steps=steps: go(run, steps)}, ROUNDS)[""]  # type: ignore[misc]
        found.append(1000 * sorted(seconds)[ROUNDS // 2] / steps)
        print(f"{robots:>7} robots {found[-1]:10.4f} ms a step {1000 * found[-1] / robots:8.3f} µs a robot", flush=True)
    return found


def picture(times: list[float]) -> str:
    """The plot, as SVG."""
    told = ", ".join(f"{robots}: {ms:.3g}" for robots, ms in zip(ROBOTS, times, strict=True))
    plot = Plot(
        f"Milliseconds a step by number of robots: {told}",
        "A step of the simulator",
        "with Numba, on one core; 20 ms of simulated time",
        times,
        " ms",
        (1, 5),
        "robots",
    )
    for power in range(1, 6):
        plot.mark(power, f"{10**power:,}".replace(",", "\u2009"))
    ends = [(robots, times[0] / ROBOTS[0] * robots) for robots in (ROBOTS[0], ROBOTS[-1])]
    plot.line([(math.log10(robots), ms) for robots, ms in ends], "#999999", "5 4", dots=False)
    plot.line([(math.log10(robots), ms) for robots, ms in zip(ROBOTS, times, strict=True)], "#1d6fb8")
    real = plot.y(20)
    if TOP < real < HEIGHT - BOTTOM:
        plot.parts.append(f'<path d="M{LEFT} {real:.1f}H{WIDTH - RIGHT}" stroke="#c0392b" stroke-dasharray="2 3"/>')
        plot.text(LEFT + 8, real - 6, "20 ms: real time", "#c0392b")
    x, y = plot.x(math.log10(ROBOTS[-1])) - 8, plot.y(ends[1][1]) + 150
    plot.text(x, y, "dashed: growing just with the robots", "#777777", "end")
    return plot.svg()


def main() -> int:
    """Measures, and writes the picture where it is told to."""
    times = measure()
    print(machine())
    if len(sys.argv) > 1:
        Path(sys.argv[1]).write_text(picture(times), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
