"""The picture of a study, by matplotlib (`kitrobot[plot]`): a curve with intervals, or a map over two numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.summary import Cell, PointSummary, summarise
from kitrobot.experiments.variant import Value
from kitrobot.text.sentences import Sentence


def plot_study(study: StudyRows, measure: str, confidence: float) -> Any:
    """A `matplotlib.figure.Figure`: of one axis a curve with bars, of two a map.

    Raises:
        ExperimentError: more than two numbers vary, or nothing of that name was measured.
        KitRobotError: matplotlib is not installed.
    """
    figure_module = _matplotlib("figure")
    plan = study.plan
    if measure not in plan.measured:
        raise ExperimentError(Sentence("no row of the study has the measure `{name}`", measure))
    found, at = summarise(study, confidence), plan.measured.index(measure)
    values = {name: list(dict.fromkeys(one.point[name] for one in found)) for name in plan.addresses}
    varied = [name for name, known in values.items() if len(known) > 1]
    if len(varied) > 2:
        raise ExperimentError(
            Sentence("a picture has at most two numbers that vary; here {count} do", len(varied)),
            Sentence("take the rows with `to_pandas` and draw them yourself"),
        )
    figure = figure_module.Figure(figsize=(6, 4), layout="constrained")
    axes = figure.add_subplot()
    if len(varied) == 2:
        _draw_map(figure, axes, found, at, (varied[0], values[varied[0]]), (varied[1], values[varied[1]]))
        axes.set_title(measure)
    else:
        _draw_curve(axes, found, at, varied[0] if varied else "")
        axes.set_ylabel(measure)
    return figure


def _draw_curve(axes: Any, found: Sequence[PointSummary], at: int, name: str) -> None:
    known = [(one, one.cells[at]) for one in found if one.cells[at].mean is not None]
    places: list[Value] = [one.point[name] if name else "" for one, _ in known]
    if any(isinstance(place, str) for place in places):
        places = [str(place) for place in places]
    else:
        # A curve goes from left to right, in whatever order its values were given.
        known.sort(key=lambda one: one[0].point[name])
        places.sort()
    bars = [[_reach(cell)[side] for _, cell in known] for side in (0, 1)]
    axes.errorbar(places, [cell.mean for _, cell in known], yerr=bars, fmt="o-", capsize=4)
    if all(isinstance(place, int) for place in places):
        axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set_xlabel(name)


def _reach(cell: Cell) -> tuple[float, float]:
    """How far its interval goes below the estimate, and above."""
    interval = cell.interval
    return (interval.estimate - interval.low, interval.high - interval.estimate) if interval is not None else (0.0, 0.0)


def _draw_map(
    figure: Any,
    axes: Any,
    found: Sequence[PointSummary],
    at: int,
    down: tuple[str, Sequence[Value]],
    across: tuple[str, Sequence[Value]],
) -> None:
    table = [[math.nan] * len(across[1]) for _ in down[1]]
    for one in found:
        mean = one.cells[at].mean
        row, column = down[1].index(one.point[down[0]]), across[1].index(one.point[across[0]])
        table[row][column] = math.nan if mean is None else mean
    figure.colorbar(axes.imshow(table, aspect="auto", origin="lower"))
    axes.set_yticks(range(len(down[1])), [str(value) for value in down[1]])
    axes.set_xticks(range(len(across[1])), [str(value) for value in across[1]])
    axes.set_ylabel(down[0])
    axes.set_xlabel(across[0])


def _matplotlib(module: str) -> Any:
    try:
        return import_module(f"matplotlib.{module}")
    except ImportError as error:
        raise KitRobotError(
            Sentence("pictures of studies need matplotlib, which is not installed"),
            Sentence("install it: {command}", '`pip install "kitrobot[plot]"`'),
        ) from error
