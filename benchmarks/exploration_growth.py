"""Plots how exploration slows with the number of carriers, ours and SPIN:

    python -m benchmarks --json checking > ROWS.json
    python -m benchmarks.exploration_growth ROWS.json FILE.svg

States a second of processor time, logarithmic, from the rows of `benchmarks.subjects.checking`.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from benchmarks.plots import Plot

_OURS, _THEIRS = "#1d6fb8", "#c0392b"


def series(rows: list[dict[str, Any]]) -> dict[str, list[tuple[float, float]]]:
    """By its name each line of the plot: numbers of carriers and states a second."""
    found: dict[str, list[tuple[float, float]]] = {}
    for row in rows:
        if row["unit"] != "states/s":
            continue
        carriers, what, engine = row["what"].split(", ")
        if what not in ("safety", "liveness"):
            continue
        number = float(carriers.split()[0])
        found.setdefault(f"{what}, {engine}", []).append((number, row["ours"]["median"]))
        if row["theirs"] is not None:
            found.setdefault(f"{what}, {row['peer']}", []).append((number, row["theirs"]["median"]))
    return found


def picture(rows: list[dict[str, Any]]) -> str:
    """The plot, as SVG."""
    lines = series(rows)
    told = "; ".join(f"{name}: {', '.join(f'{value:.3g}' for _, value in its)}" for name, its in lines.items())
    places = sorted({place for its in lines.values() for place, _ in its})
    plot = Plot(
        f"States a second by number of carriers: {told}",
        "Exploring every order of events",
        "states a second of processor time; full line: safety, dashed: liveness",
        [value for its in lines.values() for _, value in its],
        "",
        (places[0], places[-1]),
        "carriers",
    )
    for place in places:
        plot.mark(place, f"{place:g}")
    for name, its in lines.items():
        is_theirs = name.endswith("SPIN")
        colour = _THEIRS if is_theirs else _OURS
        plot.line(its, colour, "" if name.startswith("safety") else "5 4")
        # Ours of both kinds lie close together: one name is enough for them.
        if is_theirs or name.startswith("safety"):
            place, value = its[-1]
            plot.text(plot.x(place), plot.y(value) + (20 if is_theirs else -12), name.split(", ")[1], colour, "end")
    return plot.svg()


def main() -> int:
    """Draws the rows of a file."""
    rows = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["rows"]
    Path(sys.argv[2]).write_text(picture(rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
