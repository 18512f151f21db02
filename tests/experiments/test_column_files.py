"""A summary of very many rows: the same with a column file, without one, and with one that is old, torn or wrong."""

from __future__ import annotations

import math
import random
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.experiments import row_columns
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.executor import Work
from kitrobot.experiments.point_runner import row_bytes
from kitrobot.experiments.study import Study
from kitrobot.experiments.study_run import Shard, run_study
from tests.effort import examples
from tests.experiments.missions import short_study

OUTCOMES = ("done", "failed", "stuck", "time", "error")


class CannedRows:
    """An executor that makes rows up, in an order that depends on chance."""

    def run(self, work: Work, stop):
        rows, chance = list(work.rows), random.Random(7)
        chance.shuffle(rows)
        for row in rows:
            outcome = chance.choice(OUTCOMES)
            number = None if chance.random() < 0.2 else chance.uniform(-5, 5)
            fields = {"seconds": row, "measures": {"seconds": row, "distance": number}}
            yield row_bytes(work.plan, row, outcome, "é", {} if outcome == "error" else fields)


@pytest.fixture
def study(tmp_path, monkeypatch):
    """Two shards of forty rows each, and one of the rows twice; column files are worth it."""
    monkeypatch.setattr(row_columns, "WORTH_KEEPING", 0)
    short_study(tmp_path, "1-40")
    for number in (1, 2):
        run_study(tmp_path, CannedRows(), Shard(number, 2))
    first, second = sorted(tmp_path.glob("rows*.jsonl"))
    with second.open("ab") as file:
        file.write(first.read_bytes().splitlines(keepends=True)[0])
    return Study(tmp_path)


def row_by_row(study):
    """Of each point its outcomes, and the numbers of each measure with their mean."""
    found = []
    rows = study.rows
    for point in range(study.plan.points):
        ours = [row for row in rows if row.number // len(study.plan.seeds) == point]
        columns = [[row.measures.get(name) for row in ours] for name in study.plan.measured]
        numbers = [[one for one in column if one is not None] for column in columns]
        means = [(len(one), pytest.approx(math.fsum(one) / len(one))) for one in numbers]
        found.append((Counter(row.outcome for row in ours), means))
    return found


def summary(study):
    return [(dict(one.outcomes), [(cell.runs, cell.mean) for cell in one.cells]) for one in study.summary()]


def test_a_summary_is_that_of_the_rows_with_column_files_and_without(study):
    expected = row_by_row(study)
    files = sorted(study.folder.glob("*.columns"))
    assert [file.name for file in files] == ["rows-1-of-2.columns", "rows-2-of-2.columns"]
    assert summary(study) == expected
    for file in files:
        file.unlink()
    assert summary(study) == expected
    assert summary(study) == expected, "made anew, and read"


def test_in_a_page_lines_are_read_without_msgspec_and_say_the_same(study, monkeypatch):
    expected = row_by_row(study)
    for file in study.folder.glob("*.columns"):
        file.unlink()
    monkeypatch.setattr(row_columns, "HAS_MSGSPEC", False)
    assert summary(study) == expected
    (study.folder / "rows-3-of-3.jsonl").write_bytes(b'{"row": 99999}\n')
    with pytest.raises(ExperimentError, match="no row of its study"):
        summary(study)


def test_rows_that_are_added_or_taken_out_count(study):
    path = study.folder / "rows-1-of-2.jsonl"
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[:-2]))
    assert summary(study) == row_by_row(study)
    path.write_bytes(b"".join([*lines[:-1], lines[-1][:20]]))
    assert summary(study) == row_by_row(study), "what is being written counts when it is whole"
    path.write_bytes(b"".join(lines))
    assert summary(study) == row_by_row(study)
    path.write_bytes(b"".join(reversed(lines)))
    assert summary(study) == row_by_row(study)


def test_a_column_file_of_another_study_says_nothing(study, tmp_path_factory):
    other = tmp_path_factory.mktemp("other")
    short_study(other, "1-40", seconds=11.0)
    run_study(other, CannedRows())
    (study.folder / "rows-1-of-2.columns").write_bytes((other / "rows.columns").read_bytes())
    assert summary(study) == row_by_row(study)


def test_a_column_file_that_is_cut_off_or_damaged_says_nothing(study):
    path = study.folder / "rows-1-of-2.columns"
    whole, expected = path.read_bytes(), row_by_row(study)

    @settings(max_examples=examples(25))
    @given(st.integers(0, len(whole) - 1), st.booleans())
    def holds(at, is_cut):
        damaged = bytearray(whole)
        damaged[at] ^= 0x41
        path.write_bytes(whole[:at] if is_cut else bytes(damaged))
        assert summary(study) == expected
        assert path.read_bytes() == whole, "made anew"

    holds()


def test_a_line_that_is_no_row_is_shown(study):
    with (study.folder / "rows-2-of-2.jsonl").open("ab") as file:
        file.write(b'{"row":4000,"outcome":"done"}\n')
    with pytest.raises(ExperimentError, match='"row":4000'):
        study.summary()


def test_where_no_file_can_be_made_the_summary_is_there_all_the_same(study, monkeypatch):
    for file in study.folder.glob("*.columns"):
        file.unlink()
        file.mkdir()
    assert summary(study) == row_by_row(study)
