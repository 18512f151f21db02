"""A study: its rows are the same whatever makes them, and its folder survives what happens to it."""

from __future__ import annotations

import errno
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.executor import ThisProcess
from kitrobot.experiments.local_workers import LocalWorkers
from kitrobot.experiments.plan import PLAN_FILE, read_plan
from kitrobot.experiments.point_runner import PointRunner
from kitrobot.experiments.study_folder import ROWS, RowWriter, begin_study, finished_rows, open_study, row_lines
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.study_run import Shard, merge_studies, read_shard, run_study, study_status
from tests.effort import examples
from tests.experiments.missions import (
    die_at_seed_3,
    give_nan,
    last_tick,
    short_mission,
    short_plan,
    short_study,
    sorted_rows,
    speed_address,
)

PLAN = short_plan()


@pytest.fixture(scope="module")
def undisturbed():
    """The rows as one process makes them, one after another."""
    runner = PointRunner(PLAN)
    return sorted(runner.run(row) for row in range(PLAN.rows))


def test_a_plan_is_what_was_written_of_it():
    plan = short_plan(vary=[(speed_address(short_mission()), "30,60"), ("breakdown.rule", "tow,stay")], is_zip=True)
    assert read_plan(plan.to_toml(), "plan.toml") == plan
    strange = replace(plan, mission="a\r\n'''\x7f\"\\", name="''")
    assert read_plan(strange.to_toml(), "plan.toml") == strange


def test_a_row_is_the_run_that_the_mission_itself_gives(undisturbed):
    opened = short_mission()
    found = {row.number: row for row in _rows(undisturbed)}
    address = speed_address(opened)
    for row in found.values():
        vertex = next(one for one in opened.mission.programs[0].vertices if one.id == address.split(".")[1])
        vertex.settings["speed"] = str(row.point[address])
        run = type(opened)(**{name: getattr(opened, name) for name in opened.__dataclass_fields__}).run(
            seed=row.seed, fail_rate=1.0
        )
        assert (row.outcome, row.sentence, row.seconds) == (run.outcome, run.sentence, run.seconds)


def _rows(lines):
    from kitrobot.experiments.study_rows import study_row
    from kitrobot.text.json_text import from_json

    nowhere: Any = None
    return [study_row(from_json(line), nowhere) for line in lines]


def test_points_have_the_same_seeds_and_each_run_an_id_of_its_own():
    assert {PLAN.seed(row) for row in range(6)} == {PLAN.seed(row) for row in range(6, 12)} == set(range(1, 7))
    assert len({PLAN.row_id(row) for row in range(PLAN.rows)}) == PLAN.rows
    assert replace(PLAN, measures=()).row_id(0) == PLAN.row_id(0)
    assert replace(PLAN, seconds=1.0).row_id(0) != PLAN.row_id(0)


@settings(max_examples=examples(8))
@given(st.data())
def test_order_shards_and_restarts_never_change_a_row(tmp_path_factory, undisturbed, data):
    folder = tmp_path_factory.mktemp("study")
    begin_study(folder, PLAN)
    count = data.draw(st.integers(1, 4))
    for number in data.draw(st.permutations(range(1, count + 1))):
        left = data.draw(st.integers(0, PLAN.rows))
        run_study(folder, shard=Shard(number, count), stop=iter([False] * left + [True]).__next__)
        run_study(folder, shard=Shard(number, count))
    assert sorted_rows(folder) == undisturbed
    assert finished_rows(folder, PLAN) == b"\1" * PLAN.rows


@pytest.mark.parametrize("jobs", [1, 2, 3])
def test_processes_give_the_same_rows(tmp_path, undisturbed, jobs):
    begin_study(tmp_path, PLAN)
    told = []
    assert run_study(tmp_path, LocalWorkers(jobs), progress=lambda done, total: told.append((done, total)))
    assert sorted_rows(tmp_path) == undisturbed
    assert told[0] == (0, 12)
    assert told[-1] == (12, 12)


def test_folders_of_shards_are_merged_and_a_row_that_is_there_twice_counts_once(tmp_path, undisturbed):
    folders = [tmp_path / f"part-{number}" for number in range(1, 9)]
    for number, folder in enumerate(folders, 1):
        begin_study(folder, PLAN)
        run_study(folder, shard=Shard(number, 8))
    run_study(folders[0], stop=iter([False, False, True]).__next__)
    assert merge_studies(folders, tmp_path / "whole") == PLAN.rows
    assert sorted_rows(tmp_path / "whole") == undisturbed
    assert merge_studies(folders, folders[0]) == PLAN.rows
    assert len(StudyRows(folders[0])) == PLAN.rows


@given(cut=st.integers(0, 2000))
def test_a_row_that_was_cut_off_is_made_again(tmp_path_factory, undisturbed, cut):
    folder = tmp_path_factory.mktemp("study")
    begin_study(folder, PLAN)
    whole = b"".join(undisturbed)
    (folder / ROWS).write_bytes(whole[: cut % len(whole)])
    assert len(list(row_lines(folder))) == whole[: cut % len(whole)].count(b"\n")
    assert run_study(folder)
    assert sorted_rows(folder) == undisturbed


def test_a_second_supervisor_is_told_so_and_changes_nothing(tmp_path):
    short_study(tmp_path)
    with RowWriter(tmp_path):
        with pytest.raises(ExperimentError, match="is being worked on by another process") as told:
            run_study(tmp_path)
        assert "--shard" in told.value.help
        assert run_study(tmp_path, shard=Shard(1, 2))
    assert len(list(row_lines(tmp_path))) == 6


def test_on_a_full_disk_rows_are_whole_or_not_there_and_the_study_goes_on_when_there_is_room(tmp_path, undisturbed):
    begin_study(tmp_path, PLAN)

    def refuse(file):
        raise OSError(errno.ENOSPC, "No space left on device")

    with RowWriter(tmp_path) as writer:
        writer.write(undisturbed[:2])
    with RowWriter(tmp_path, sync=refuse) as writer, pytest.raises(ExperimentError, match="No space left"):
        writer.write(undisturbed[2:5])
    assert sorted_rows(tmp_path) == undisturbed[:2]
    assert run_study(tmp_path)
    assert sorted_rows(tmp_path) == undisturbed


def test_another_study_another_version_and_no_study_are_sentences(tmp_path):
    short_study(tmp_path / "study")
    with pytest.raises(ExperimentError, match="`study` holds another study"):
        short_study(tmp_path / "study", seeds="1-7")
    with pytest.raises(ExperimentError, match="holds no study"):
        open_study(tmp_path)
    short_study(tmp_path / "other", seeds="1-7")
    with pytest.raises(ExperimentError, match="are not of one study"):
        merge_studies([tmp_path / "study", tmp_path / "other"], tmp_path / "whole")
    run_study(tmp_path / "other")
    (tmp_path / "study" / ROWS).write_bytes((tmp_path / "other" / ROWS).read_bytes().splitlines(True)[7])
    with pytest.raises(ExperimentError, match="rows of another study"):
        run_study(tmp_path / "study")
    (tmp_path / "study" / ROWS).write_bytes(b"{}\n")
    with pytest.raises(ExperimentError, match="holds a line that is no row"):
        run_study(tmp_path / "study")
    older = replace(PLAN, version="0.0.1")
    begin_study(tmp_path / "older", older)
    with pytest.raises(ExperimentError, match=r"begun with KitRobot 0\.0\.1"):
        run_study(tmp_path / "older")
    for text in ("", "format = 1", "format = 99\nkitrobot='9'", "x", "[["):
        (tmp_path / "study" / PLAN_FILE).write_text(text)
        with pytest.raises(ExperimentError, match=r"study/plan\.toml"):
            open_study(tmp_path / "study")


@pytest.mark.parametrize("text", ["0/2", "3/2", "1", "a/b", "1/0", "-1/2"])
def test_a_shard_that_makes_no_sense_is_refused(text):
    with pytest.raises(ExperimentError, match="expected a shard such as 3/64"):
        read_shard(text)


@pytest.mark.parametrize(
    ("measure", "words"),
    [
        ("sconds", "`sconds` is no measure"),
        ("distance.cas", "no agent cas takes part"),
        ("time any ann (Nose.IsPressed())", "the measure `time any ann"),
        ("first nonsense", "the measure `first nonsense`"),
        ("seconds,seconds", "two measures are called `seconds`"),
    ],
)
def test_a_measure_that_cannot_be_read_is_refused(measure, words):
    with pytest.raises(ExperimentError, match=words):
        short_plan(measures=[measure])


def test_measures_add_up_what_happens_from_tick_to_tick():
    asked = "seconds,ticks,done,distance,distance.ann,energy,energy.ben,n=count all drive (Captor.LessThan(1000))"
    plan = short_plan("1", fail_rate=0.0, measures=[asked, "first any ann (Captor.LessThan(0))"])
    slow, fast = _rows(PointRunner(plan).run(row) for row in range(2))
    for row, speed in ((slow, 30), (fast, 60)):
        told = row.measures
        assert (told["seconds"], told["ticks"], told["done"]) == (row.seconds, row.seconds * 50, 1)
        assert told["distance"] == pytest.approx(2 * told["distance.ann"])
        assert told["energy.ben"] == pytest.approx(speed * 1.0, abs=speed * 0.05)
        assert told["energy"] == pytest.approx(2 * told["energy.ben"])
        assert told["first any ann (Captor.LessThan(0))"] is None
    assert fast.measures["distance"] > 1.5 * slow.measures["distance"] > 0


def test_a_mission_that_cannot_be_run_is_a_row_that_says_why(tmp_path):
    plan = short_study(tmp_path, "1", vary=[("world.width", "1000,100")])
    assert run_study(tmp_path)
    assert study_status(tmp_path).outcomes["error"] == 1
    (wrong,) = (row for row in StudyRows(tmp_path) if row.outcome == "error")
    assert plan.point(wrong.number) == {"world.width": 100}
    assert wrong.sentence
    with pytest.raises(ExperimentError, match="no run behind this row"):
        wrong.record()


def test_a_measure_in_python_gets_the_recording_and_one_that_is_no_number_is_told(tmp_path):
    functions = {"last": last_tick, "nan": give_nan, "wrong": len}
    short_study(tmp_path, "1-2", functions=functions)
    with pytest.raises(ExperimentError, match="the measure `last` is a Python function"):
        run_study(tmp_path)
    assert run_study(tmp_path, functions=functions)
    for row in StudyRows(tmp_path, functions):
        assert row.seconds is not None
        assert (row.measures["last"], row.measures["nan"], row.measures["wrong"]) == (row.seconds * 50, None, None)
        assert row.wrong["nan"] == "the measure `nan` gave no number"
        assert "TypeError" in row.wrong["wrong"]


def test_the_run_behind_a_row_is_recorded_and_is_that_very_run(tmp_path):
    short_study(tmp_path)
    run_study(tmp_path)
    study = StudyRows(tmp_path)
    for row in (study.worst("distance"), study.best("distance"), study.row(4), study.row(study.rows[5].id[:12])):
        trace = row.replay()
        told = trace.reader.outcome
        assert row.seconds is not None
        trace.reader.close()
        assert (told["outcome"], told["sentence"], told["ticks"]) == (row.outcome, row.sentence, row.seconds * 50)
    with pytest.raises(ExperimentError, match="no row `99`"):
        study.row(99)
    with pytest.raises(ExperimentError, match="the measure `speed`"):
        study.worst("speed")


# -- what dies in the middle


def test_a_run_that_takes_its_process_along_three_times_is_a_row_that_says_so(tmp_path):
    functions = {"one": die_at_seed_3}
    short_study(tmp_path, "1-5", vary=[], functions=functions)
    assert run_study(tmp_path, LocalWorkers(2), functions=functions)
    rows = StudyRows(tmp_path).rows
    (died,) = (row for row in rows if row.outcome == "died")
    assert (died.seed, died.sentence) == (3, "its process died 3 times")
    assert [row.measures["one"] for row in rows if row.outcome != "died"] == [1] * 4


def test_an_executor_can_be_stopped_between_rows(tmp_path):
    short_study(tmp_path)
    assert not run_study(tmp_path, ThisProcess(), stop=iter([False, False, True]).__next__)
    assert len(list(row_lines(tmp_path))) == 2
