"""`import kitrobot`: what the command line gives, as objects."""

from __future__ import annotations

from typing import Any

import pytest

import kitrobot
from kitrobot.files.examples import examples_folder, first_example
from kitrobot.graph.model import empty_program
from tests.effort import THOROUGH

_FOLDER = examples_folder()
assert _FOLDER is not None
EXAMPLES = sorted(_FOLDER.glob("*/*.krt"))


def test_everything_that_is_named_is_there_and_in_order():
    assert kitrobot.__all__ == sorted(kitrobot.__all__)
    for name in kitrobot.__all__:
        assert getattr(kitrobot, name) is not None
    assert set(kitrobot.__all__) <= set(dir(kitrobot))


def test_what_is_not_there_is_an_attribute_error():
    with pytest.raises(AttributeError, match="nothing"):
        kitrobot.nothing  # type: ignore[attr-defined]  # noqa: B018


def test_a_mission_opens_checks_and_runs():
    path = first_example()
    assert path is not None
    mission = kitrobot.open(path)
    assert mission.check().ok
    told: list[float] = []
    run = mission.run(seed=1, progress=told.append)
    assert isinstance(run, kitrobot.Run)
    assert (run.outcome, run.total, sum(run.delivered.values())) == ("done", 12, 12)
    assert told == sorted(told)
    assert told


def test_a_mission_opens_by_a_plain_string():
    assert kitrobot.open(str(first_example())).mission.programs


WAIT_FOR_SOMEBODY = ("dice", "reaction")
"""Games: without a hand on their buttons they go on. tests/examples plays them."""


RUN = {"square", "transport", "dice"}
"""Those that are run here; tests/examples runs them all."""


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_is_free_of_errors_and_ends_as_done(path):
    mission = kitrobot.open(path)
    assert [problem for problem in mission.check().problems if problem.is_error] == []
    if THOROUGH or path.stem in RUN:
        assert mission.run(seed=1).outcome == ("time" if path.stem in WAIT_FOR_SOMEBODY else "done")


def test_running_a_mission_with_errors_raises_with_what_is_wrong(tmp_path):
    (tmp_path / "m.krt").write_text('<kitrobot version="1"><program name="p" robot="nobody"/></kitrobot>')
    mission = kitrobot.open(tmp_path / "m.krt")
    assert not mission.check().ok
    with pytest.raises(kitrobot.KitRobotError) as caught:
        mission.run()
    assert "mission-no-robot" in [item.code for item in caught.value.diagnostics]


def test_opening_what_is_no_mission_raises_with_what_is_wrong(tmp_path):
    (tmp_path / "m.krt").write_text("<kitrobot")
    with pytest.raises(kitrobot.KitRobotError) as caught:
        kitrobot.open(tmp_path / "m.krt")
    assert caught.value.diagnostics[0].is_error


def test_parse_gives_the_tree_and_the_mistakes():
    parsed = kitrobot.parse("WAIT(1); WAIT(;", "x.lll")
    assert isinstance(parsed, kitrobot.ParseResult)
    assert parsed.program.items
    assert [item.place.file for item in parsed.diagnostics if item.place] == ["x.lll"]


@pytest.mark.parametrize("kind", ["text", "tree", "graph"])
def test_compile_takes_a_text_a_tree_or_a_graph(kind):
    tree = kitrobot.parse("WAIT(1);").program
    programs: dict[str, Any] = {"text": "WAIT(1);", "tree": tree, "graph": empty_program("p", "any")}
    compiled = kitrobot.compile(programs[kind], "mini-robot")
    assert isinstance(compiled, kitrobot.CompiledProgram)
    assert compiled.ok


def test_compile_takes_a_robot_by_name_by_file_or_itself(tmp_path):
    (tmp_path / "r.robot.xml").write_text(
        '<robot name="r" version="1"><actuator name="Arm" device="arm"><procedure name="Up"/></actuator></robot>'
    )
    robot = kitrobot.robot(tmp_path / "r.robot.xml")
    for given in (robot, tmp_path / "r.robot.xml", str(tmp_path / "r.robot.xml")):
        assert kitrobot.compile("Arm.Up();", given).ok
    with pytest.raises(kitrobot.KitRobotError, match="nobody"):
        kitrobot.compile("WAIT(1);", "nobody")


def test_mistakes_of_a_program_are_collected_not_raised():
    compiled = kitrobot.compile("Wheel.Advance(500); Nobody.Knows();", "mini-robot")
    assert compiled.image is None
    assert len([item for item in compiled.diagnostics if item.is_error]) == 2


def test_execute_gives_a_tick_at_a_time():
    robot = kitrobot.robot("mini-robot")
    image = kitrobot.compile("Count.Add(2); WAIT(0);", robot).image
    assert image is not None
    ticks = kitrobot.execute(image, robot, ticks=3)
    first = next(ticks)
    assert isinstance(first, kitrobot.ExecutionTick)
    assert (first.tick, first.variables["Count"], first.ended) == (0, 2, False)
    assert [tick.ended for tick in ticks] == [True, True]


def test_a_walk_by_hand_refuses_a_timing_that_there_is_not():
    walk = kitrobot.walk(kitrobot.open_mission("blink"), timing="lockstep")
    assert walk.go_on() > 0
    with pytest.raises(kitrobot.KitRobotError, match=r"expected one of .*free.*, found .*slow"):
        kitrobot.walk("blink", timing="slow")
    with pytest.raises(kitrobot.KitRobotError, match="0 to 3 failures"):
        kitrobot.walk("blink", failures=9)
