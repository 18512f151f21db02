"""Studies in a notebook: their table, and their picture where matplotlib is there."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import kitrobot
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.study import Study

AXES: dict[str, list[float]] = {"agents.carrier": [2, 3], "fail-rate": [0, 0.5], "radio.loss": [0, 50]}


def _study(folder: Path, count: int) -> Study:
    vary = {name: AXES[name] for name in [*AXES][:count]}
    found = kitrobot.sweep("transport", vary=vary, seeds=[1, 2], measures=["seconds", "done"], seconds=5, folder=folder)
    assert isinstance(found, Study)
    return found


def test_a_notebook_shows_a_study_as_a_table_and_escapes_what_comes_from_files(tmp_path: Path) -> None:
    shown = _study(tmp_path / "a<b", 1)._repr_html_()
    assert "<caption>a&lt;b: 4 of 4 runs</caption>" in shown
    assert "<th>agents.carrier</th><th>runs</th><th>seconds</th><th>done</th>" in shown
    assert "<td>3</td><td>2</td><td>5 (5 … 5)</td><td>0 (0 … " in shown
    assert "0.95: " in shown


def test_without_matplotlib_a_sentence_says_how_to_get_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(KitRobotError, match="need matplotlib") as raised:
        _study(tmp_path / "study", 1).plot()
    assert 'pip install "kitrobot[plot]"' in raised.value.help


def test_one_axis_is_a_curve_two_are_a_map_and_more_are_refused(tmp_path: Path) -> None:
    [axes] = _study(tmp_path / "one", 1).plot().axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("agents.carrier", "seconds")
    figure = _study(tmp_path / "two", 2).plot("done")
    assert (figure.axes[0].get_title(), figure.axes[0].images[0].get_array().shape) == ("done", (2, 2))
    figure.savefig(tmp_path / "map.svg")
    with pytest.raises(ExperimentError, match="here 3 do"):
        _study(tmp_path / "three", 3).plot()
    with pytest.raises(ExperimentError, match="no row of the study"):
        _study(tmp_path / "one", 1).plot("second")
