"""Studies as tables: CSV, Arrow, Parquet; and in numbers."""

from __future__ import annotations

import csv
import io
import sys
from typing import Any

import pytest

import kitrobot
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.statistics.means import unpaired_difference, unpaired_test
from kitrobot.experiments.statistics.multiple_comparisons import holm
from kitrobot.experiments.study import Study
from kitrobot.experiments.tables import column_names
from tests.experiments.missions import last_tick, short_mission, speed_address


@pytest.fixture(scope="module")
def study():
    """Two points of four seeds, with words and a missing number."""
    opened = short_mission()
    measures: dict[str, Any] = {
        "seconds": "seconds",
        "seed": "ticks",
        "never": "first any ann (Captor.LessThan(0))",
        "last": last_tick,
    }
    vary: dict[str, Any] = {speed_address(opened): [30, 60], "breakdown.rule": "tow"}
    return kitrobot.sweep(opened, vary=vary, seeds=range(1, 5), measures=measures)


def test_a_study_in_python_is_its_rows(study):
    assert isinstance(study, Study)
    assert [row.number for row in study.rows] == list(range(8))
    assert "8 of 8 runs" in repr(study)
    assert study.worst("last").measures["last"] == max(row.measures["last"] or 0 for row in study)


def test_csv_has_a_column_for_everything_and_a_line_for_each_row(study, tmp_path):
    study.to_csv(tmp_path / "rows.csv")
    lines = list(csv.reader(io.StringIO((tmp_path / "rows.csv").read_text())))
    speed = study.plan.addresses[0]
    named = ["row", "id", "seed", speed, "breakdown.rule", "outcome", "sentence", "seconds", "measure seed", "never"]
    assert lines[0] == column_names(study.plan) == [*named, "last"]
    assert [line[3] for line in lines[1:]] == ["30"] * 4 + ["60"] * 4
    assert {line[9] for line in lines[1:]} == {""}


def test_arrow_and_parquet_hold_the_same(study, tmp_path):
    core, files = pytest.importorskip("arro3.core"), pytest.importorskip("arro3.io")
    table = core.Table(study)
    assert table.column_names == column_names(study.plan)
    assert table.column("id").to_pylist() == [row.id for row in study.rows]
    assert table.column("never").to_pylist() == [None] * 8
    study.to_parquet(tmp_path / "rows.parquet")
    assert files.read_parquet(str(tmp_path / "rows.parquet")).read_all() == table


def test_pandas_reads_it(study):
    pytest.importorskip("pandas")
    frame = study.to_pandas()
    assert list(frame["last"]) == [row.measures["last"] for row in study.rows]


def test_without_arro3_a_sentence_says_how_to_get_it(study, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "arro3.io", None)
    with pytest.raises(KitRobotError, match="arro3") as told:
        study.to_parquet(tmp_path / "rows.parquet")
    assert "kitrobot[data]" in told.value.help


def test_a_summary_has_an_interval_for_each_measure_of_each_point_and_comparisons_are_paired(study):
    slow, fast = study.summary(ci=0.9)
    assert (slow.point[study.plan.addresses[0]], fast.outcomes) == (30, {"done": 4})
    seconds, _, never, _ = slow.cells
    assert (seconds.runs, seconds.interval.confidence, never.runs, never.interval) == (4, 0.9, 0, None)
    (found,) = study.compare(study.plan.addresses[0], "seconds")
    assert (found.first, found.other, found.pairs, found.interval.estimate) == (30, 60, 4, 0.0)
    with pytest.raises(KitRobotError, match="does not vary"):
        study.compare("fail-rate")
    with pytest.raises(KitRobotError, match="no row of the study has the measure"):
        study.compare(study.plan.addresses[0], "sconds")


def test_a_comparison_says_how_much_more_the_other_value_gives():
    opened = short_mission()
    address = speed_address(opened)
    study = kitrobot.sweep(opened, vary={address: [30, 60]}, seeds=range(1, 4), measures=["distance"])
    slow, fast = (
        [row.measures["distance"] or 0 for row in study.rows if row.point[address] == speed] for speed in (30, 60)
    )
    (found,) = study.compare(address)
    assert (found.pairs, found.interval.method) == (3, "Student's t interval of the differences")
    assert found.interval.low > 0
    assert found.interval.estimate == pytest.approx((sum(fast) - sum(slow)) / 3)


def test_an_unpaired_comparison_takes_all_runs_and_says_by_what_it_was_computed():
    opened = short_mission()
    address = speed_address(opened)
    study = kitrobot.sweep(
        opened, vary={address: [30, 60, 90]}, seeds=range(1, 5), measures=["distance", "done"], fail_rate=0.9
    )
    numbers = [
        [row.measures["distance"] or 0 for row in study.rows if row.point[address] == speed] for speed in (30, 60, 90)
    ]
    found = study.compare(address, "distance", paired=False)
    assert [(one.other, one.pairs, one.first_runs, one.other_runs) for one in found] == [
        (60, None, 4, 4),
        (90, None, 4, 4),
    ]
    plain = [unpaired_test(numbers[0], other) for other in numbers[1:]]
    assert [one.p_value for one in found] == holm(plain)
    assert found[0].interval == unpaired_difference(numbers[0], numbers[1])
    assert (found[0].interval.method, found[0].test) == ("Welch's t interval", "Welch's t test, p-values by Holm")
    done, _ = study.compare(address, "done", paired=False)
    assert (done.interval.method, done.test) == ("Newcombe's score interval", "Fisher's exact test, p-values by Holm")
