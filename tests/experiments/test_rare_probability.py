"""What hardly ever happens: splitting against what is known, for any number of processes, broken off, and mistaken."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import kitrobot
from kitrobot import Agent, Mission, OpenMission, Pose, RunOptions, Start, Team, World
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.rare_probability import RareProbability, SplittingOptions, find_rare_probability
from tests.effort import THOROUGH
from tests.experiments.conftest import TEXT

ROBOTS = ("ann", "ben", "cem") if THOROUGH else ("ann", "ben")
BRANCHES = 12_000 if THOROUGH else 400
RATE = 0.9
ONE = 1 - (1 - RATE) ** (2 / 60)
"""The probability that a robot fails in two seconds: it has a turn to fail in each."""
TRUTH = ONE ** len(ROBOTS)
"""The probability that all do: of two 0.0055, of three 4.0e-4."""
ALL_FAIL = "never any count (Count.EqualTo(2))"


@pytest.fixture(scope="module")
def drivers() -> OpenMission:
    """Robots that count to two, a second for each, and have nothing to do with each other."""
    starts = tuple(Start(name, pose=Pose(200, 200 + 200 * at, 0)) for at, name in enumerate(ROBOTS))
    program = kitrobot.read_program(TEXT, "mini-robot", "count")
    team = Team([Agent(name, "count") for name in ROBOTS])
    return kitrobot.open_mission(
        Mission(programs=[program], team=team, own_world=World("yard", 1000, 800, starts=starts))
    )


def asked(opened: OpenMission, question: str = ALL_FAIL, rate: float = RATE, **options: Any) -> RareProbability:
    prepared = opened.prepare(RunOptions(1, 30.0, rate))
    chosen: dict[str, Any] = {"counts": "failed", "branches": BRANCHES, "jobs": 1, **options}
    return find_rare_probability(prepared, question, SplittingOptions(**chosen))


def decided(found: RareProbability) -> dict[str, Any]:
    """Everything but the time that it took."""
    made = found.to_json()
    del made["timing"]
    return made


@pytest.fixture(scope="module")
def found(drivers: OpenMission) -> RareProbability:
    return asked(drivers)


def test_the_interval_holds_what_is_known(found: RareProbability) -> None:
    assert found.complete
    assert found.interval is not None
    assert found.interval.low <= TRUTH <= found.interval.high < 4 * TRUTH
    assert found.levels[0] == 1.0
    assert abs(found.passed[0] - (1 - (1 - ONE) ** len(ROBOTS))) < 0.05
    assert found.branches <= BRANCHES


def test_the_result_does_not_depend_on_the_number_of_processes(drivers: OpenMission) -> None:
    few: dict[str, Any] = {"branches": 80, "repetitions": 4}
    assert decided(asked(drivers, **few)) == decided(asked(drivers, **few, jobs=2))


def test_every_kind_of_question_can_be_asked_and_what_is_sure_stays_sure(drivers: OpenMission) -> None:
    few: dict[str, Any] = {"branches": 80, "repetitions": 4}
    for question in ("never any count (Count.EqualTo(5))", "at most 1 times any ann (Count.EqualTo(1))"):
        found = asked(drivers, question, **few)
        assert found.repetitions == pytest.approx((1.0,) * 4)


def test_whoever_asks_for_the_end_gets_what_is_known_so_far(drivers: OpenMission) -> None:
    prepared = drivers.prepare(RunOptions(1, 30.0, RATE))
    options = SplittingOptions("failed", 200, 10, jobs=1)
    found = find_rare_probability(prepared, ALL_FAIL, options, stop=iter([False, True]).__next__)
    assert (len(found.repetitions), found.complete, found.interval) == (1, False, None)


@pytest.mark.parametrize(
    ("options", "sentence", "help"),
    [
        ({"counts": "fialed"}, "runs are split at", "did you mean failed?"),
        ({"counts": "delivered"}, "there is nothing to deliver in this mission", "split them at `failed`"),
        ({"counts": "collisions"}, "runs have no levels of `collisions`", "at another count"),
        ({"rate": 0.0}, "runs have no levels of `failed`", "at another count"),
        ({"branches": 100}, "100 branches are too few for 1 levels", "let there be 200 at least"),
        ({"repetitions": 1}, "2 repetitions at least", ""),
        ({"confidence": 1.0}, "a confidence between 0 and 1", ""),
        ({"jobs": 0}, "1 to 256 processes", ""),
        ({"question": "nothing"}, "no property nothing", ""),
    ],
)
def test_what_cannot_be_split_is_an_error_that_says_what_to_do(
    drivers: OpenMission, options: dict[str, Any], sentence: str, help: str
) -> None:
    with pytest.raises(KitRobotError, match=sentence) as raised:
        asked(drivers, **options)
    assert help in raised.value.help


def test_a_sensor_that_keeps_its_chance_for_a_while_is_refused(tmp_path: Path) -> None:
    (tmp_path / "r.robot.xml").write_text(
        '<robot name="r" version="1"><sensor name="Coin" device="chance" min="0" max="1">'
        '<function name="IsOne" type="boolean" comparison="is-one"/></sensor></robot>'
    )
    program = kitrobot.read_program("WAIT(9);", tmp_path / "r.robot.xml", "p")
    world = World("yard", 1000, 800, starts=(Start("ada", pose=Pose(200, 200, 0)),))
    mission = Mission(programs=[program], team=Team([Agent("ada", "p")]), own_world=world)
    opened = kitrobot.open_mission(mission, folder=tmp_path)
    with pytest.raises(KitRobotError, match="Coin of ada keeps its chance for a while") as raised:
        asked(opened, "failed")
    assert raised.value.help == "ask without splitting"
