"""Kills in the middle of a study, of its processes and of the supervisor: no row is lost, none is there twice."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

from kitrobot.experiments.executor import Work
from kitrobot.experiments.local_workers import LocalWorkers
from kitrobot.experiments.point_runner import PointRunner
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_run import run_study
from kitrobot.text.json_text import from_json
from tests.effort import examples
from tests.experiments.missions import die_at_seed_3, short_plan, sorted_rows

ROOT = Path(__file__).parents[2]
PLAN = short_plan("1-20")

DIES = """
import os, signal, sys
from pathlib import Path
from typing import Any
from kitrobot.experiments import study_run
from kitrobot.experiments.local_workers import LocalWorkers
from kitrobot.experiments.study_run import run_study
from kitrobot.text.json_text import from_json

def main():
    study_run._SYNC_S = 0.0  # each row by itself
    folder, rows = Path(sys.argv[1]), int(sys.argv[2])
    begun = []

    def die(done, total):
        begun.append(done)
        if done >= begun[0] + rows:
            os.kill(os.getpid(), signal.SIGKILL)

    run_study(folder, LocalWorkers(2), progress=die)

if __name__ == "__main__":
    main()
"""


@pytest.fixture(scope="module")
def undisturbed():
    """The rows as one process makes them, one after another."""
    runner = PointRunner(PLAN)
    return sorted(runner.run(row) for row in range(PLAN.rows))


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
@pytest.mark.parametrize("seed", range(examples(1, 300)))
def test_killed_processes_cost_no_row(undisturbed, seed):
    chance = random.Random(seed)
    kills = {chance.randrange(PLAN.rows - 1) for _ in range(3)}
    executor = LocalWorkers(2)
    lines = []
    for number, line in enumerate(executor.run(Work(PLAN, range(PLAN.rows), PLAN.rows), lambda: False)):
        lines.append(line)
        if number in kills:
            os.kill(chance.choice(executor.workers).process.pid, signal.SIGKILL)
    assert sorted(lines) == undisturbed
    assert executor.workers == []


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
@pytest.mark.parametrize("seed", range(examples(1, 100)))
def test_a_killed_supervisor_costs_no_row(tmp_path, undisturbed, seed):
    chance = random.Random(seed)
    begin_study(tmp_path / "study", PLAN)
    script = tmp_path / "dies.py"
    script.write_text(DIES)
    for _ in range(2):
        rows = chance.randrange(1, PLAN.rows // 3)
        ended = subprocess.run([sys.executable, script, tmp_path / "study", str(rows)], cwd=ROOT, check=False)
        assert ended.returncode == -signal.SIGKILL
    assert 0 < len(sorted_rows(tmp_path / "study")) < PLAN.rows
    assert run_study(tmp_path / "study")
    assert sorted_rows(tmp_path / "study") == undisturbed


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_processes_may_be_killed_again_and_again_as_long_as_others_begin(undisturbed):
    executor = LocalWorkers(2)
    lines = []
    for number, line in enumerate(executor.run(Work(PLAN, range(PLAN.rows), PLAN.rows), lambda: False)):
        lines.append(line)
        if number % 3 == 0 and number < PLAN.rows - 4:
            os.kill(executor.workers[-1].process.pid, signal.SIGKILL)  # the newest, which may not be ready yet
    assert sorted(lines) == undisturbed


@pytest.mark.thorough("the other tests of this file and of test_cluster.py, with a kill or two each")
@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_random_kills_of_everything_leave_the_rows_of_an_undisturbed_study(tmp_path, monkeypatch):
    kills = pytest.importorskip("benchmarks.kills", exc_type=ImportError)
    monkeypatch.setenv("KITROBOT_COMPILE", "no")
    campaign = kills.Campaign(100, runs=1000, rows=15)
    campaign.run(tmp_path)
    assert campaign.done.total() == 100
    assert campaign.studies >= 2


def test_a_run_that_a_process_died_at_is_made_again_after_the_others_that_the_process_had():
    plan = short_plan("1-12", vary=[], functions={"one": die_at_seed_3})
    lines = list(LocalWorkers(1).run(Work(plan, range(plan.rows), plan.rows, {"one": die_at_seed_3}), lambda: False))
    rows = [from_json(line) for line in lines]
    assert [row["seed"] for row in rows if row["outcome"] == "died"] == [3]
    assert [row["seed"] for row in rows[:5]] == [1, 2, 4, 5, 6]


def test_processes_end_when_nobody_wants_more_rows():
    executor = LocalWorkers(2)
    lines: Any = executor.run(Work(PLAN, range(PLAN.rows), PLAN.rows), lambda: False)
    assert len(list(islice(lines, 3))) == 3
    processes = [worker.process for worker in executor.workers]
    lines.close()
    assert not any(process.is_alive() for process in processes)
