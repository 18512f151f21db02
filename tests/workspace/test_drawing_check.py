"""What is said of a mission while it is drawn: waits and loops without an end, parts that never run."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest

from kitrobot.checking.drawing_check import RUN_S, check_drawing, explore_drawing
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.trap_detection import record_coverage, unexecuted_instructions
from kitrobot.workspace import child_processes
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from tests.effort import cases
from tests.sim.team_building import RunningTeam, random_team_program
from tests.team_programs.hosting import TooLarge
from tests.verifier.check_fixtures import EXAMPLES, mutant
from tests.verifier.test_brute_force import random_run


def opened(path: Path) -> PreparedRun:
    return open_mission(path).prepare(RunOptions(1, RUN_S))


RING = """<kitrobot version="1">
  <program name="drive" robot="carrier">
    <vertex id="start" element="Start"/>
    <vertex id="go" element="Wheel.Advance"><set name="speed">50</set></vertex>
    {parts}
    <vertex id="halt" element="Wheel.Stop"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="go"/><arc from="go" to="first"/>{arcs}<arc from="{last}" to="halt"/>
    <arc from="halt" to="stop"/>
  </program>
  <team><agent name="carrier-1" program="drive"/></team>
  <world href="ring.world.xml"/>
</kitrobot>
"""
WAIT = RING.format(
    parts="""<vertex id="first" element="When"/>
    <vertex id="nine" element="Sign.EqualTo"><set name="value">9</set></vertex>
    <vertex id="on" element="Lamp.LightOn"/>""",
    arcs="""<arc from="nine" to="first" at="condition"/>
    <arc from="first" out="body" to="on"/><arc from="on" to="first" at="return"/>""",
    last="first",
)
LOOP = RING.format(
    parts="""<vertex id="first" element="While"/>
    <vertex id="nine" element="Sign.LessThan"><set name="value">9</set></vertex>
    <vertex id="on" element="Lamp.LightOn"/><vertex id="p1" element="Wait"><set name="duration">2</set></vertex>
    <vertex id="off" element="Lamp.LightOff"/><vertex id="p2" element="Wait"><set name="duration">2</set></vertex>""",
    arcs="""<arc from="nine" to="first" at="condition"/>
    <arc from="first" out="body" to="on"/><arc from="on" to="p1"/><arc from="p1" to="off"/><arc from="off" to="p2"/>
    <arc from="p2" to="first" at="return"/>""",
    last="first",
)

MEETING = """<kitrobot version="1">
  <program name="meet" level="social">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="ParOfSeq"><set name="members">leader</set></vertex>
    <vertex id="v2" element="When"/>
    <vertex id="v3" element="{test}"/>
    <vertex id="v4" element="Light.LightOn"/>
    <vertex id="v5" element="SeqOfPar"><set name="members">both</set></vertex>
    <vertex id="v6" element="Light.LightOff"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/><arc from="v1" out="body" to="v2"/><arc from="v3" to="v2" at="condition"/>
    <arc from="v2" out="body" to="v4"/><arc from="v4" to="v2" at="return"/><arc from="v2" to="v1" at="return"/>
    <arc from="v1" to="v5"/><arc from="v5" out="body" to="v6"/><arc from="v6" to="v5" at="return"/>
    <arc from="v5" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="meet" robot="mini-robot"/>
    <agent name="robot-2" program="meet" robot="kit-robot"/>
    <role name="leader" robot="mini-robot"/>
    <role name="follower" robot="kit-robot"/>
    <group name="both" members="leader follower"/>
  </team>
  <world href="convoy.world.xml"/>
</kitrobot>
"""


def of(text: str, folder: Path) -> PreparedRun:
    path = folder / "drawn.krt"
    path.write_text(text, encoding="utf-8")
    return opened(path)


def test_a_wait_that_nothing_can_end_is_told_with_a_run_that_shows_it_and_what_never_runs_behind_it(
    tmp_path: Path,
) -> None:
    wait, idle = check_drawing(of(WAIT, tmp_path), lambda: False, None)
    assert (wait.problem.code, wait.problem.program, wait.problem.vertices) == ("waits-for-ever", "drive", ("first",))
    assert str(wait.problem.message) == "`carrier-1` can come to wait here for ever"
    assert wait.shown is not None
    assert wait.shown.faults == ()
    assert wait.shown.tick < 100
    assert (idle.problem.code, idle.problem.vertices, idle.shown) == ("never-reached", ("on", "halt"), None)


def test_where_there_are_no_processes_the_same_is_found_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    apart = check_drawing(of(WAIT, tmp_path), lambda: False, None)
    monkeypatch.setattr(child_processes, "_possible", False)
    assert check_drawing(of(WAIT, tmp_path), lambda: False, None) == apart
    assert check_drawing(of(WAIT, tmp_path), lambda: True, None) == []


def test_a_loop_that_never_lets_go_is_another_thing(tmp_path: Path) -> None:
    found = explore_drawing(of(LOOP, tmp_path).spec.simulation, 1, None)
    assert [(one.vertex, one.waits) for one in found.traps] == [("first", False)]


def test_carriers_that_block_each_other_before_the_goal_are_told_and_nothing_when_it_is_broken_off(
    tmp_path: Path,
) -> None:
    old = '<vertex id="v25" element="Cargo.IsPressed"/>'
    prepared = mutant(tmp_path, (old, old.replace("Pressed", "Released")), carriers=1, stock=1)
    found = explore_drawing(prepared.spec.simulation, 1, None)
    assert {one.agent for one in found.traps} >= {"carrier-1", "loader", "unloader"}
    assert check_drawing(prepared, lambda: True) == []


@pytest.mark.parametrize(
    "name",
    cases(
        ["square", "rooms", "passing-loop", "wall-follower", "convoy", "exchange"],
        ["merge", "door", "follow-the-leader"],
    ),
)
def test_nothing_is_said_of_missions_that_are_right_and_of_loops_that_are_meant_to_go_on(name: str) -> None:
    prepared = opened(EXAMPLES / name / f"{name}.krt")
    assert explore_drawing(prepared.spec.simulation, 1, None) == ((), ())


def test_parts_for_another_stock_are_none_that_never_run(tmp_path: Path) -> None:
    """A's manager ends the work where there is no box."""
    assert explore_drawing(mutant(tmp_path, carriers=2, stock=1).spec.simulation, 1, None) == ((), ())


def meeting(folder: Path, test: str) -> PreparedRun:
    world = (EXAMPLES / "convoy" / "convoy.world.xml").read_text(encoding="utf-8")
    (folder / "convoy.world.xml").write_text(world, encoding="utf-8")
    return of(MEETING.format(test=test), folder)


def test_who_waits_in_vain_in_a_team_is_told_and_so_is_who_waits_for_it_at_a_meeting(tmp_path: Path) -> None:
    found = check_drawing(meeting(tmp_path, "Flag.IsTrue"), lambda: False, None)
    traps = {(one.problem.code, one.problem.vertices) for one in found if one.shown is not None}
    assert traps == {("waits-for-ever", ("v2",)), ("waits-for-ever", ("v1",))}
    [idle] = [one.problem for one in found if one.shown is None]
    assert (idle.code, idle.program) == ("never-reached", "meet")
    assert set(idle.vertices) >= {"v4", "v6"}


def test_what_one_kind_of_robot_does_in_a_team_is_no_part_that_never_runs(tmp_path: Path) -> None:
    assert explore_drawing(meeting(tmp_path, "Flag.IsFalse").spec.simulation, 1, None) == ((), ())


@pytest.mark.parametrize("seed", cases([2, 4], [0, 1, 3, 5, 6, 7, *range(8, 200)]))
def test_of_random_teams_nothing_that_runs_is_told_to_be_never_reached(seed: int) -> None:
    maker, program = random_team_program(seed)
    try:
        team = RunningTeam(maker, program, seed)
    except TooLarge:
        return
    none_that_never_run_does(team.run, team.anew())


@pytest.mark.parametrize("seed", cases([*range(6)], [*range(6, 300)]))
def test_of_random_programs_nothing_that_runs_is_told_to_be_never_reached(seed: int) -> None:
    run, _ = random_run(random.Random(seed))
    other, _ = random_run(random.Random(seed))
    presses = random.Random(seed)

    def press() -> None:
        for agent in other.members:
            other.force(agent.name, "Button", presses.randint(0, 1))

    none_that_never_run_does(run, other, press)


def none_that_never_run_does(explored: Simulation, run: Simulation, before_step: Callable[[], object] = int) -> None:
    """Goes through a mission, and holds a run of it, of a minute at most, against what is said to run in none."""
    parts = abstract_run(explored)
    record_coverage(parts)
    if not explore(Model(explored, parts), Budget(2_000), False, PLAIN).complete:
        return
    never = unexecuted_instructions(parts)
    ran: set[tuple[ImageName, int]] = set()
    run.watch_programs()
    while run.outcome is None and run.tick < 3000:
        before_step()
        run.advance(1)
        for agent in run.members:
            ran |= {(agent.image_name, pc) for pc, seen in enumerate(agent.machine.seen) if seen}
    assert ran
    assert not {(name, pc) for name, pc in ran if pc in never[name]}
