"""What would hang or break a careless simulator ends in a sentence, or in a run that is bounded."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.sim.setup.limits import MAX_AGENTS, SimulationError
from kitrobot.world.model import Wall
from kitrobot.world.xml_reader import read_world
from tests.sim.building import WHEEL, avatar, catalogue, empty_world, run_of, transport

MINI = catalogue().robots["mini-robot"]
HOLE = b"""<world version="1" name="w" width="3000" height="2000"><road name="r" width="100">
<point x="100" y="100"/><point x="2000" y="100"/><section sign="1" from="0" to="500"/><section sign="2" from="700"/>
</road></world>"""


@pytest.mark.parametrize(
    "walls", [(Wall(1000, 900, 1000, 1100),), (Wall(1000, 1000, 1000, 1000),), (Wall(0, 960, 3000, 960),)]
)
def test_a_robot_inside_a_wall_is_refused_by_its_name(walls: tuple[Wall, ...]) -> None:
    with pytest.raises(SimulationError, match="a starts in a wall"):
        run_of({"a": (MINI, "WAIT(1);")}, replace(empty_world(a=(1000, 1000, 0)), walls=walls))


def test_a_road_with_a_hole_is_a_mistake_with_its_place() -> None:
    problems = read_world(HOLE, "w.world.xml")[1]
    assert [problem.message for problem in problems] == [
        "expected section 2 to begin at 500 mm, found 700: a gap of 200 mm"
    ]
    assert problems[0].place is not None


def test_a_program_that_loops_for_ever_without_waiting_takes_one_pass_a_tick() -> None:
    text = "*[Run.IsTrue()]( *[Run.IsTrue()]( Count.Add(1); [Count.EqualTo(100)]( Count.Set(0); ) ); );"
    run = run_of({"a": (MINI, text)}, empty_world(a=(1000, 1000, 0)), seconds=5)
    assert run.advance(10**9) == 250 or run.outcome == "stuck"
    assert run.outcome in ("time", "stuck")


def test_a_mission_whose_programs_never_end_runs_out_of_time() -> None:
    moving = "*[Run.IsTrue()]( Wheel.Advance(50); WAIT(10); Wheel.Reverse(50); WAIT(10); );"
    run = run_of({"a": (MINI, moving)}, empty_world(a=(1000, 1000, 0)), seconds=30)
    assert run.advance(10**9) == 1500
    assert run.sentence == "The time of 30 s ran out: the program had not ended."


def test_a_call_for_ever_so_many_steps_comes_back_when_very_much_has_happened() -> None:
    text = "*[Run.IsTrue()]( Light.LightOn(); WAIT(1); Light.LightOff(); WAIT(1); );"
    lossy = avatar(
        '<actuator name="Light" device="lamp" dropout="100"><procedure name="LightOn"/></actuator>',
        '<variable name="Run" type="boolean" initial="true"/>',
    )
    run = run_of({"a": (lossy, text.split("WAIT")[0] + ");")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    done = run.advance(5000)
    assert 0 < done < 5000
    assert len(run.events) == done
    while run.outcome is None:
        run.advance(5000)
    assert run.tick == 5000


def test_as_many_robots_as_you_like_in_one_place_are_refused_quickly() -> None:
    robot = avatar(WHEEL.format(settings=""))
    world = empty_world(**{f"a{n}": (1000, 1000, 0) for n in range(2000)})
    with pytest.raises(SimulationError, match="start in the same place") as caught:
        run_of(dict.fromkeys((start.name for start in world.starts), (robot, "WAIT(1);")), world)
    assert len(caught.value.diagnostics) <= 200


def test_there_is_room_for_a_hundred_thousand_and_no_more() -> None:
    assert MAX_AGENTS == 100_000


def test_no_steps_and_fewer_than_none_do_nothing() -> None:
    run = transport(1)
    assert run.advance(0) == run.advance(-5) == run.tick == 0
