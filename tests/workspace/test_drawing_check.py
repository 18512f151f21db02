"""What is said of a mission while it is drawn: waits and loops without an end, parts that never run."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.workspace import RunOptions, child_processes, open_mission
from kitrobot.workspace.drawing_check import RUN_S, look, look_through
from kitrobot.workspace.running import PreparedRun
from kitrobot.workspace.verification import runs_of
from tests.verifier.building import EXAMPLES, mutant


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


def of(text: str, folder: Path) -> PreparedRun:
    path = folder / "drawn.krt"
    path.write_text(text, encoding="utf-8")
    return opened(path)


def test_a_wait_that_nothing_can_end_is_told_with_a_run_that_shows_it_and_what_never_runs_behind_it(
    tmp_path: Path,
) -> None:
    wait, idle = look_through(of(WAIT, tmp_path), lambda: False, None)
    assert (wait.problem.code, wait.problem.program, wait.problem.vertices) == ("waits-for-ever", "drive", ("first",))
    assert str(wait.problem.message) == "`carrier-1` can come to wait here for ever"
    assert wait.shown is not None
    assert wait.shown.harms == ()
    assert wait.shown.tick < 100
    assert (idle.problem.code, idle.problem.vertices, idle.shown) == ("never-reached", ("on", "halt"), None)


def test_where_there_are_no_processes_the_same_is_found_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    apart = look_through(of(WAIT, tmp_path), lambda: False, None)
    monkeypatch.setattr(child_processes, "_possible", False)
    assert look_through(of(WAIT, tmp_path), lambda: False, None) == apart
    assert look_through(of(WAIT, tmp_path), lambda: True, None) == []


def test_a_loop_that_never_lets_go_is_another_thing(tmp_path: Path) -> None:
    found = look(runs_of(of(LOOP, tmp_path).parts()), 1, None)
    assert [(one.vertex, one.waits) for one in found.traps] == [("first", False)]


def test_carriers_that_block_each_other_before_the_goal_are_told_and_nothing_when_it_is_broken_off(
    tmp_path: Path,
) -> None:
    old = '<vertex id="v25" element="Cargo.IsPressed"/>'
    prepared = mutant(tmp_path, (old, old.replace("Pressed", "Released")), carriers=1, stock=1)
    found = look(runs_of(prepared.parts()), 1, None)
    assert {one.agent for one in found.traps} >= {"carrier-1", "loader", "unloader"}
    assert look_through(prepared, lambda: True) == []


def test_of_a_mission_that_the_model_cannot_hold_nothing_is_said(tmp_path: Path) -> None:
    team = opened(EXAMPLES / "convoy" / "convoy.krt")
    assert look_through(team, lambda: False) == []


@pytest.mark.parametrize("name", ["square", "rooms", "passing-loop", "wall-follower"])
def test_nothing_is_said_of_missions_that_are_right_and_of_loops_that_are_meant_to_go_on(name: str) -> None:
    prepared = opened(EXAMPLES / name / f"{name.rpartition('/')[2]}.krt")
    assert look(runs_of(prepared.parts()), 1, None) == ((), ())
