"""Shared variables: seen in the next tick, the latest write wins, and of two at once the later agent's."""

from __future__ import annotations

import pytest

from kitrobot.primitives.robot import Robot
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.simulation import Simulation
from tests.sim.building import avatar, empty_world, run_of, steps

ROOM = empty_world(a=(500, 500, 0), b=(1500, 500, 0), c=(2500, 500, 0))
LEVEL = '<variable name="Level" type="integer" min="0" max="50" shared="yes"/>'


def robot(name: str = "avatar", tick: int = 20, variable: str = LEVEL) -> Robot:
    return avatar(variable, '<variable name="Own" type="integer" min="0" max="50"/>', name=name, tick=tick)


def levels(run: Simulation) -> list[int]:
    return [agent.values["Level"] for agent in run.agents]


def test_a_write_is_seen_by_everybody_from_the_next_tick_on() -> None:
    copy = "*[Own.LessThan(50)]( Own.Set(Level.Value()); );"
    run = run_of({"a": (robot(), copy), "b": (robot(), "WAIT(1); Level.Set(7); WAIT(9);")}, ROOM)
    seen = [(steps(run, 1).agents[0].values["Own"], levels(run)) for _ in range(8)]
    assert seen[4] == (0, [0, 0])
    assert seen[5] == (0, [7, 7])
    assert seen[6] == (7, [7, 7])


def test_of_two_writes_in_one_tick_the_later_agents_wins_everywhere() -> None:
    run = run_of(
        {name: (robot(), f"Level.Set({value}); WAIT(9);") for name, value in (("a", 9), ("b", 4), ("c", 6))}, ROOM
    )
    assert levels(steps(run, 1)) == [6, 6, 6]
    assert [(event.agent, event.text) for event in run.events] == [("c", "Level = 6")]


def test_variables_that_are_not_shared_stay_with_their_agent() -> None:
    run = run_of({"a": (robot(), "Own.Set(3); WAIT(9);"), "b": (robot(), "WAIT(9);")}, ROOM)
    assert [agent.values["Own"] for agent in steps(run, 2).agents] == [3, 0]


def test_robots_of_different_ticks_run_at_their_own_pace() -> None:
    fast, slow = robot("fast", 20), robot("slow", 50)
    count = "*[Own.LessThan(50)]( Own.Add(1); );"
    run = run_of({"a": (fast, count), "b": (slow, count)}, ROOM)
    assert run.tick_ms == 10
    assert [agent.values["Own"] for agent in steps(run, 50).agents] == [25, 10]
    assert run.seconds == 0.5


def test_a_variable_that_two_robots_define_differently_is_refused() -> None:
    other = robot("other", variable=LEVEL.replace("50", "60"))
    with pytest.raises(SimulationError, match="Level is shared, and avatar and other define it differently"):
        run_of({"a": (robot(), ""), "b": (other, "")}, ROOM)
