"""A study in numbers: of each point the mean of each measure, with its interval.

`done` is a share. Rows without a number do not count, and `Cell.runs` says how many do. The statistics are those of
`experiments.statistics`.
"""

from __future__ import annotations

import math
from array import array
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from kitrobot.experiments.row_columns import point_stretches, row_columns
from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.tables import text_lines
from kitrobot.experiments.variant import Value


@dataclass(frozen=True)
class Cell:
    """A measure at a point: how many runs gave a number, its interval (None of fewer than two), its mean."""

    measure: str
    runs: int
    interval: Interval | None
    mean: float | None = None


@dataclass(frozen=True)
class PointSummary:
    """A point: its number, its values by address, how many of its rows had which outcome, and its measures."""

    number: int
    point: Mapping[str, Value]
    outcomes: Mapping[str, int]
    cells: tuple[Cell, ...]


def summarise(study: StudyRows, confidence: float = USUAL_CONFIDENCE) -> list[PointSummary]:
    """Every point of a study of which a row is there, in the order of the plan.

    Raises:
        StatisticsError: the confidence is none.
    """
    plan = study.plan
    seeds = len(plan.seeds)
    outcomes: dict[int, dict[str, int]] = {}
    numbers: dict[int, list[array[float]]] = {}
    for block in row_columns(study.folder, plan):
        for at, rows in point_stretches(block.numbers, seeds):
            if at not in outcomes:
                outcomes[at], numbers[at] = {}, [array("d") for _ in plan.measured]
            for outcome, count in Counter(block.outcomes[rows]).items():
                outcomes[at][outcome] = outcomes[at].get(outcome, 0) + count
            for column, measured in zip(numbers[at], block.measures, strict=True):
                part = measured[rows]
                column.extend(part if isinstance(part, array) else [number for number in part if number is not None])
    return [
        PointSummary(
            at,
            plan.point(at * seeds),
            outcomes[at],
            tuple(_cell(name, column, confidence) for name, column in zip(plan.measured, numbers[at], strict=True)),
        )
        for at in sorted(outcomes)
    ]


def _cell(name: str, values: Sequence[float], confidence: float) -> Cell:
    from kitrobot.experiments.statistics.means import mean_interval
    from kitrobot.experiments.statistics.shares import share_interval

    if not values:
        return Cell(name, 0, None)
    count = len(values)
    if name == "done":
        return Cell(name, count, share_interval(int(sum(values)), count, confidence), math.fsum(values) / count)
    if count == 1:
        return Cell(name, 1, None, values[0])
    interval = mean_interval(values, confidence)
    return Cell(name, count, interval, interval.estimate)


def summary_json(study: StudyRows, confidence: float = USUAL_CONFIDENCE) -> list[dict[str, Any]]:
    """As plain values, in the published shape."""
    return [
        {
            "point": dict(one.point),
            "outcomes": dict(one.outcomes),
            "measures": {cell.measure: _cell_json(cell) for cell in one.cells},
        }
        for one in summarise(study, confidence)
    ]


def _cell_json(cell: Cell) -> dict[str, Any]:
    interval = cell.interval
    if interval is None:
        return {"runs": cell.runs}
    return {
        "runs": cell.runs,
        "estimate": interval.estimate,
        "low": interval.low,
        "high": interval.high,
        "confidence": interval.confidence,
        "method": str(interval.method),
    }


def summary_text(study: StudyRows, confidence: float = USUAL_CONFIDENCE) -> str:
    """As people read it: a line for each point, and the methods below."""
    found = summarise(study, confidence)
    rows = [[*study.plan.addresses, "runs", *study.plan.measured]]
    methods: dict[str, None] = {}
    for one in found:
        cells = [cell_text(cell) for cell in one.cells]
        rows.append([*map(str, one.point.values()), str(sum(one.outcomes.values())), *cells])
        methods |= dict.fromkeys(str(cell.interval.method) for cell in one.cells if cell.interval is not None)
    lines = [*text_lines(rows), "", *(f"  {confidence:.4g}: {method}" for method in methods)]
    return "\n".join(lines) + "\n"


def cell_text(cell: Cell) -> str:
    """A measure at a point in words: estimate and interval; the number itself of one run."""
    if cell.interval is None and cell.mean is not None:
        return f"{cell.mean:.5g}"
    if cell.interval is None:
        return "–"
    low, high = cell.interval.low, cell.interval.high
    return f"{cell.interval.estimate:.5g} ({low:.5g} … {high:.5g})"
