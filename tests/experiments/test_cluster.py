"""Studies on a Dask cluster that is started as its documents say: a real scheduler, real workers, and kills."""

from __future__ import annotations

import itertools
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.cluster import DaskCluster
from kitrobot.experiments.executor import ThisProcess, Work
from kitrobot.experiments.point_runner import PointRunner
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_run import run_study
from tests.experiments.missions import short_plan, sorted_rows

pytestmark = pytest.mark.skipif(find_spec("distributed") is None, reason="needs Dask")
"""Looked for and not imported: that takes half a second of each worker."""

PLAN = short_plan("1-40")


@pytest.fixture(scope="module")
def undisturbed():
    """The rows as one process makes them, one after another."""
    runner = PointRunner(PLAN)
    return sorted(runner.run(row) for row in range(PLAN.rows))


@contextmanager
def _program(
    name: str, *arguments: str, says: str, path: Path | None = None
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A program of Dask's, once it has said that; and what it said there. It finds modules in a folder first."""
    command = [sys.executable, "-m", f"distributed.cli.{name}", *arguments]
    environment = os.environ if path is None else {**os.environ, "PYTHONPATH": str(path)}
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environment) as process:
        assert process.stderr is not None
        try:
            found = next(match for line in process.stderr if (match := re.search(says, line)))
            yield process, found[1]
        finally:
            process.kill()
            process.stderr.read()


@contextmanager
def _scheduler():
    options = ("--host", "127.0.0.1", "--port", "0", "--no-dashboard")
    with _program("dask_scheduler", *options, says=r"Scheduler at:\s+(tcp://\S+)") as made:
        yield made


def _worker(address: str, path: Path | None = None):
    options = ("--no-nanny", "--nthreads", "1", "--no-dashboard")
    return _program("dask_worker", address, *options, says=r"(Registered to:)", path=path)


def test_a_worker_that_is_killed_costs_no_row_and_a_scheduler_that_goes_away_is_a_sentence(tmp_path, undisturbed):
    begin_study(tmp_path, PLAN)
    with _scheduler() as (scheduler, address), _worker(address) as (one, _), _worker(address) as (two, _):
        lines = []
        for line in DaskCluster(address).run(Work(PLAN, range(PLAN.rows), PLAN.rows), lambda: False):
            lines.append(line)
            if len(lines) == 5:
                one.kill()
        assert sorted(lines) == undisturbed

        # No run ends while the last worker stands still.
        two.send_signal(signal.SIGSTOP)
        looks = itertools.count()

        def kill_at_the_second_look():
            if next(looks) == 1:
                scheduler.kill()
            return False

        with pytest.raises(ExperimentError, match="the Dask scheduler has gone away") as told:
            run_study(tmp_path, DaskCluster(address), stop=kill_at_the_second_look)
        assert "--resume" in told.value.help
    assert set(sorted_rows(tmp_path)) < set(undisturbed)
    assert run_study(tmp_path, ThisProcess())
    assert sorted_rows(tmp_path) == undisturbed


@pytest.mark.parametrize(
    ("package", "reason"),
    [
        ('raise ImportError("there is no kitrobot here")\n', "cannot make a run: .*there is no kitrobot here"),
        pytest.param(
            None,
            "cannot make a run: .*this study was begun with KitRobot 0.0.1",
            marks=pytest.mark.thorough("the other worker, without the package"),
        ),
    ],
)
def test_a_worker_without_the_package_or_with_another_version_is_a_sentence(tmp_path, package, reason):
    if package is not None:
        (tmp_path / "kitrobot").mkdir()
        (tmp_path / "kitrobot" / "__init__.py").write_text(package)
    plan = PLAN if package is not None else replace(PLAN, version="0.0.1")
    folder = tmp_path if package is not None else None
    with (
        _scheduler() as (_, address),
        _worker(address, folder),
        pytest.raises(ExperimentError, match=reason) as told,
    ):
        list(DaskCluster(address).run(Work(plan, range(4), 4), lambda: False))
    assert told.value.help == "install the same version of KitRobot on all workers"


def test_a_scheduler_that_is_not_there_is_a_sentence(monkeypatch):
    monkeypatch.setattr("kitrobot.experiments.cluster._CONNECT_S", 1)
    with pytest.raises(ExperimentError, match="there is no Dask scheduler at `tcp://127.0.0.1:9`".replace(".", r"\.")):
        list(DaskCluster("tcp://127.0.0.1:9").run(Work(PLAN, [0], 1), lambda: False))


def test_without_dask_a_sentence_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ExperimentError, match="not installed") as told:
        list(DaskCluster("local").run(Work(PLAN, [0], 1), lambda: False))
    assert "kitrobot[cluster]" in told.value.help
