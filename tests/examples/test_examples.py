"""Every mission of the gallery has no problems, runs to its end as done, and is written as we write missions."""

from __future__ import annotations

from pathlib import Path

import pytest

import kitrobot
from kitrobot.mission import read_mission, write_mission

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples").glob("*/*.krt"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs_to_its_end_as_done(path: Path) -> None:
    mission = kitrobot.open(path)
    assert [problem for problem in mission.check().problems if problem.severity != "hint"] == []
    run = mission.run(seed=1, seconds=300)
    assert run.outcome == "done", run.sentence
    assert run.collisions == 0


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_is_written_canonically(path: Path) -> None:
    data = path.read_bytes()
    mission, problems = read_mission(data, path.name)
    assert problems == []
    assert mission is not None
    assert write_mission(mission) == data
