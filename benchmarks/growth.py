"""How the cost of a step grows with the number of robots, as a picture: `python -m benchmarks.growth FILE.svg`.

The swarm of `benchmarks.swarm` under Numba, 10 to 100 000 robots; the line beside it is a cost that grows just with
their number. Both axes are logarithmic.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from benchmarks.__main__ import machine
from benchmarks.measuring import in_turns
from benchmarks.subjects.simulating import go, hurried
from benchmarks.swarm import swarm

ROBOTS = (10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000)
WORK = 600_000
ROUNDS = 5
WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 70, 36, 48, 60


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
    """The plot, as SVG that is readable on light and dark paper."""
    low, high = math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))

    def x(robots: float) -> float:
        return LEFT + (math.log10(robots) - 1) / 4 * (WIDTH - LEFT - RIGHT)

    def y(ms: float) -> float:
        return HEIGHT - BOTTOM - (math.log10(ms) - low) / (high - low) * (HEIGHT - TOP - BOTTOM)

    told = ", ".join(f"{robots}: {ms:.3g}" for robots, ms in zip(ROBOTS, times, strict=True))
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
        'font-size="13">',
        f"<title>Milliseconds a step by number of robots: {told}</title>",
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
        f'<text x="{LEFT}" y="22" font-size="15" font-weight="600" fill="#222222">A step of the simulator</text>',
        f'<text x="{LEFT}" y="39" fill="#555555">with Numba, on one core; 20 ms of simulated time</text>',
    ]
    for power in range(low, high + 1):
        at = y(10**power)
        parts.append(f'<path d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}" stroke="#dddddd"/>')
        parts.append(
            f'<text x="{LEFT - 8}" y="{at + 4:.1f}" text-anchor="end" fill="#555555">{10.0**power:g} ms</text>'
        )
    for power in range(1, 6):
        at = x(10**power)
        parts.append(f'<path d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#dddddd"/>')
        shown = f"{10**power:,}".replace(",", " ")
        parts.append(
            f'<text x="{at:.1f}" y="{HEIGHT - BOTTOM + 20}" text-anchor="middle" fill="#555555">{shown}</text>'
        )
    parts.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 14}" text-anchor="middle" fill="#555555">robots</text>'
    )
    ends = [(robots, times[0] / ROBOTS[0] * robots) for robots in (ROBOTS[0], ROBOTS[-1])]
    straight = " ".join(f"{x(robots):.1f},{y(ms):.1f}" for robots, ms in ends)
    parts.append(f'<polyline points="{straight}" fill="none" stroke="#999999" stroke-dasharray="5 4"/>')
    points = [(x(robots), y(ms)) for robots, ms in zip(ROBOTS, times, strict=True)]
    line = " ".join(f"{px:.1f},{py:.1f}" for px, py in points)
    parts.append(f'<polyline points="{line}" fill="none" stroke="#1d6fb8" stroke-width="2.5"/>')
    parts += [f'<circle cx="{px:.1f}" cy="{py:.1f}" r="4" fill="#1d6fb8"/>' for px, py in points]
    real = y(20)
    if TOP < real < HEIGHT - BOTTOM:
        parts.append(f'<path d="M{LEFT} {real:.1f}H{WIDTH - RIGHT}" stroke="#c0392b" stroke-dasharray="2 3"/>')
        parts.append(f'<text x="{LEFT + 8}" y="{real - 6:.1f}" fill="#c0392b">20 ms: real time</text>')
    parts.append(
        f'<text x="{x(ROBOTS[-1]) - 8:.1f}" y="{y(ends[1][1]) + 150:.1f}" text-anchor="end" fill="#777777">'
        "dashed: growing just with the robots</text>"
    )
    return "\n".join([*parts, "</svg>"]) + "\n"


def main() -> int:
    """Measures, and writes the picture where it is told to."""
    times = measure()
    print(machine())
    if len(sys.argv) > 1:
        Path(sys.argv[1]).write_text(picture(times), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
