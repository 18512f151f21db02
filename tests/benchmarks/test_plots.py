"""Plots of benchmarks: what is measured is in them, each number where it belongs."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from typing import Any

from benchmarks.exploration_growth import picture, series
from benchmarks.growth import ROBOTS
from benchmarks.growth import picture as steps_by_robots

SVG = "{http://www.w3.org/2000/svg}"


def row(what: str, unit: str, ours: float, theirs: float | None = None) -> dict[str, Any]:
    """A row as `python -m benchmarks --json` writes it."""
    beside = None if theirs is None else {"median": theirs}
    return {"what": what, "unit": unit, "ours": {"median": ours}, "peer": "SPIN", "theirs": beside}


ROWS = [
    row("2 carriers, safety, plain", "states/s", 1000.0),
    row("2 carriers, safety, Numba", "states/s", 100_000.0, 10_000.0),
    row("2 carriers, safety, Numba", "bytes/state", 22.0, 66.0),
    row("3 carriers, safety, plain", "states/s", 900.0),
    row("3 carriers, safety, Numba", "states/s", 90_000.0, 5_000.0),
]


def test_a_line_has_a_point_for_each_number_of_carriers_and_bytes_are_in_none() -> None:
    assert series(ROWS) == {
        "safety, plain": [(2.0, 1000.0), (3.0, 900.0)],
        "safety, Numba": [(2.0, 100_000.0), (3.0, 90_000.0)],
        "safety, SPIN": [(2.0, 10_000.0), (3.0, 5_000.0)],
    }
    drawn = ElementTree.fromstring(picture(ROWS))
    assert len(drawn.findall(f"{SVG}polyline")) == 3
    assert len(drawn.findall(f"{SVG}circle")) == 6


def test_what_is_more_is_higher_up_and_a_power_of_ten_is_on_its_line() -> None:
    times = [0.01 * robots for robots in ROBOTS]
    drawn = ElementTree.fromstring(steps_by_robots(times))
    heights = [float(dot.attrib["cy"]) for dot in drawn.findall(f"{SVG}circle")]
    assert heights == sorted(heights, reverse=True)
    lines = {
        float(line.attrib["d"].split()[1].split("H")[0])
        for line in drawn.findall(f"{SVG}path")
        if "H" in line.attrib["d"]
    }
    assert {heights[0], heights[-1]} <= lines
