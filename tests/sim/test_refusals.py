"""What keeps a run from beginning."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from kitrobot.compiler.compilation import compile_program, compile_text
from kitrobot.graph.model import empty_program
from kitrobot.mission.model import Agent, Goal, Mission, Team
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.setup.limits import MAX_AGENTS, SimulationError
from kitrobot.sim.setup.setup import check_mission
from kitrobot.sim.simulation import Simulation
from kitrobot.world.geometry import Pose
from kitrobot.world.model import Start, World
from tests.sim.building import (
    avatar,
    catalogue,
    run_of,
    shipped_world,
    steps,
)
from tests.sim.test_outcome import MINI, ROOM, gone_on


def refused(mission: Mission, world: World = ROOM, robots: Catalogue | None = None) -> SimulationError:
    known = robots or catalogue()
    images = {ImageName(program.name): compile_program(program, known) for program in mission.programs}
    with pytest.raises(SimulationError) as caught:
        Simulation(mission, world, images, known)
    return caught.value


def team(*agents: Agent, goals: list[Goal] | None = None) -> Mission:
    return Mission(programs=[empty_program("p", MINI)], team=Team(list(agents), goals or []))


def test_a_team_of_nobody_is_refused() -> None:
    assert "nobody to run" in refused(team()).message


def test_a_program_that_is_not_there_or_has_errors_is_refused() -> None:
    assert "“q” is not in this mission" in refused(team(Agent("a", "q"))).message
    broken = team(Agent("a", "p"))
    broken.programs[0].arcs.clear()
    broken.programs[0].vertices[0].element = "Nonsense"
    assert "has errors" in refused(broken).message


def test_an_agent_without_a_start_is_refused_with_the_starts_there_are() -> None:
    error = refused(team(Agent("c", "p")))
    assert error.message == "c has no start “c” in the world empty"
    assert error.help == "starts that are free there: a, b"


def test_two_agents_in_one_place_are_refused() -> None:
    assert "a and c start in the same place" in refused(team(Agent("a", "p"), Agent("c", "p", "a"))).message


@pytest.mark.parametrize(("apart", "fits"), [(134, False), (136, True)])
def test_two_carriers_start_on_one_road_when_they_are_a_length_apart(apart: float, fits: bool) -> None:
    starts = (Start("a", road="ring", at_mm=20), Start("b", road="ring", at_mm=20 + apart))
    mission = Mission(programs=[empty_program("p", "carrier")], team=Team([Agent("a", "p"), Agent("b", "p")]))
    world = replace(shipped_world("ring"), starts=starts)
    if fits:
        images = {ImageName("p"): compile_program(mission.programs[0], catalogue())}
        assert steps(Simulation(mission, world, images, catalogue()), 1).outcome == "done"
    else:
        assert "a and b start in the same place" in refused(mission, world).message


def test_a_robot_that_is_too_large_for_its_place_is_refused() -> None:
    world = World("w", 4000, 2500, walls=ROOM.walls, starts=(Start("a", pose=Pose(60, 1000, 0)),))
    assert "a starts in a wall" in refused(team(Agent("a", "p")), world).message


def test_a_goal_that_names_no_storehouse_is_refused() -> None:
    assert "“Z” is not in the world" in refused(team(Agent("a", "p"), goals=[Goal("Z")])).message


def test_everything_in_the_way_is_said_at_once() -> None:
    error = refused(team(Agent("c", "p"), Agent("d", "p"), goals=[Goal("Z")]))
    assert len(error.diagnostics) == 3


def test_a_million_agents_are_refused_in_a_sentence() -> None:
    error = refused(team(*[Agent("a", "p")] * 10**6))
    assert error.message == f"expected at most {MAX_AGENTS} agents in a run, found 1000000"


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        ({"seconds": 1e308}, "expected a time limit of more than 0 and at most 1000000000 seconds, found 1e+308"),
        ({"seconds": float("nan")}, "found nan"),
        ({"seconds": float("inf")}, "found inf"),
        ({"seconds": 0}, "found 0"),
        ({"seed": -1}, "expected a seed from 0 to 9007199254740992, found -1"),
        ({"seed": 2**53 + 1}, "found 9007199254740993"),
        ({"seed": 10**400}, "expected a seed"),
        ({"fail_rate": float("nan")}, "expected a probability from 0 to 1 that a robot fails, found nan"),
        ({"fail_rate": 1.5}, "found 1.5"),
    ],
)
def test_numbers_that_no_run_can_have_are_refused_in_a_sentence(limits: dict[str, Any], words: str) -> None:
    agents = {"a": (catalogue().robots[MINI], "")}
    with pytest.raises(SimulationError) as caught:
        run_of(agents, ROOM, **limits)
    assert words in caught.value.message
    assert caught.value.help


@pytest.mark.parametrize("limits", [{"seconds": 1e9}, {"seed": 2**53}, {"fail_rate": 1.0}])
def test_the_largest_numbers_of_a_run_are_taken(limits: dict[str, Any]) -> None:
    assert gone_on(run_of({"a": (catalogue().robots[MINI], "")}, ROOM, **limits)).outcome is not None


def test_looking_over_a_mission_says_what_making_its_run_says() -> None:
    wrong = team(Agent("c", "p"), Agent("a", "p"), Agent("b", "p", "a"), goals=[Goal("Z")])
    for mission in (wrong, team(Agent("a", "p"), Agent("b", "p", "a")), team()):
        images = {ImageName(program.name): compile_program(program, catalogue()) for program in mission.programs}
        with pytest.raises(SimulationError) as caught:
            check_mission(mission, ROOM, images, catalogue())
        assert caught.value.diagnostics == refused(mission).diagnostics
    fine = team(Agent("a", "p"), Agent("b", "p"))
    check_mission(fine, ROOM, {ImageName("p"): compile_program(fine.programs[0], catalogue())}, catalogue())


def ended_at_once(agents: int) -> bool:
    """Whether a run of so many agents that have nothing to do begins and is over."""
    plain = avatar('<variable name="Count" type="integer"/>')
    mission = Mission(programs=[empty_program("p", "avatar")])
    mission.team.agents = [Agent(f"a{n}", "p", "a") for n in range(agents)]
    images = {ImageName("p"): compile_text("", plain)}
    run = Simulation(mission, ROOM, images, Catalogue(robots={"avatar": plain}))
    return steps(run, 1).outcome == "done"


def test_as_many_agents_as_allowed_begin_a_run_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kitrobot.sim.setup.setup.MAX_AGENTS", 30)
    assert ended_at_once(30)
    with pytest.raises(SimulationError, match="expected at most 30 agents in a run, found 31"):
        ended_at_once(31)


@pytest.mark.slow
@pytest.mark.thorough("test_as_many_agents_as_allowed_begin_a_run_and_no_more, with a small limit")
def test_a_hundred_thousand_agents_begin_a_run() -> None:
    assert ended_at_once(MAX_AGENTS)
