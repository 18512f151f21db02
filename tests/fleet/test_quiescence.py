"""Whether a fleet comes to an end by itself when nothing can change any more, whatever its programs do meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest

from kitrobot.cli.agent import prepare_team_run
from kitrobot.fleet.quiescence import QUIESCENT_MS, QuiescenceDetector
from kitrobot.fleet.recurrence import Recurrence, Snapshot
from kitrobot.fleet.replica import Replica
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import PLANNED, PLANS, TICK
from kitrobot.sim.tables.team_columns import T_AT
from kitrobot.workspace.mission_run import RunOptions
from tests.fleet.network import Fleet
from tests.fleet.test_convoy import anew, fleet, until

WORLD = """<world version="1" name="flat" width="2000" height="2000">
  <start name="robot-1" x="300" y="300" heading="0"/><start name="robot-2" x="900" y="900" heading="0"/></world>"""


def mission(more: str, order: list[str]) -> str:
    """Two robots with a program that does this and then looks again and again, with a wait between, at its counter."""
    names = ["start", *order, "look", "stop"]
    arcs = "".join(f'<arc from="{a}" to="{b}"/>' for a, b in pairwise(names))
    agents = "".join(f'<agent name="robot-{n}" program="p"/>' for n in (1, 2))
    return f"""<kitrobot version="1"><program name="p" robot="mini-robot"><vertex id="start" element="Start"/>{more}
      <vertex id="look" element="While"/><vertex id="less" element="Count.LessThan"><set name="value">4</set></vertex>
      <vertex id="wait" element="Wait"><set name="duration">7</set></vertex><vertex id="stop" element="Stop"/>{arcs}
      <arc from="less" to="look" at="condition"/><arc from="look" out="body" to="wait"/>
      <arc from="wait" to="look" at="return"/></program>
      <team>{agents}</team><world href="flat.world.xml"/></kitrobot>"""


def made(folder: Path, text: str, seconds: float) -> Callable[[], Simulation]:
    (folder / "flat.world.xml").write_text(WORLD)
    file = folder / "two.krt"
    file.write_text(text)
    return lambda: prepare_team_run(file, RunOptions(1, seconds)).simulation


def test_programs_that_only_look_again_and_again_are_stuck(tmp_path: Path) -> None:
    one = Fleet(made(tmp_path, mission("", []), 600))
    one.finish(60_000)
    assert one.run.outcome == "stuck", one.run.sentence
    assert one.run.seconds < 20


def test_where_sensors_may_still_see_something_the_time_ends_the_run_and_that_is_told(tmp_path: Path) -> None:
    drives = '<vertex id="turn" element="Motor.Turn"><set name="speed">5</set></vertex>'
    one = Fleet(made(tmp_path, mission(drives, ["turn"]), 30))
    one.finish(60_000)
    assert one.run.outcome == "time", one.run.sentence
    told = "all programs wait, but what sensors see may change; the run ends after 30 s"
    assert [str(line) for line in one.world.log].count(told) == 1


@pytest.fixture
def driving() -> Simulation:
    """A team that drives, and of which each robot waits for a meeting with its one thread."""
    one = fleet()
    while not any(agent.busy for agent in one.run.members):
        one.step()
    state = one.run.state
    for i in range(4):
        state.team.robots[T_AT][i] = 0
        threads = state.machines.threads[i]
        threads[::2] = [5 if n == 0 else -1 for n in range(len(threads[::2]))]
    return one.run


def stuck_after(run: Simulation, ms: int, quiet: bool = True) -> tuple[bool, list[str]]:
    """Whether it is stuck when for so long nothing happened, and what was told."""
    quiescence, told = QuiescenceDetector(Replica(run), 0), list[str]()
    quiescence.check(0, True, [True] * 4, 0)
    for now in range(20, ms + 1, 20):
        run.state.clock[TICK] += 1
        line = quiescence.check(now, False, [quiet, True, None, True], 0)
        told += [line] if line is not None else []
    return quiescence.is_stuck, told


def test_a_team_that_waits_for_itself_is_stuck_although_motors_turn(driving: Simulation) -> None:
    assert stuck_after(driving, QUIESCENT_MS - 20) == (False, [])
    assert stuck_after(driving, QUIESCENT_MS) == (True, [])


def test_a_team_of_which_another_thread_may_look_is_not_called_stuck(driving: Simulation) -> None:
    threads = driving.state.machines.threads[1]
    threads += [7, 0]
    is_stuck, told = stuck_after(driving, 3 * QUIESCENT_MS)
    assert not is_stuck
    assert told == ["all programs wait, but what sensors see may change; the run ends after 600 s"]
    assert stuck_after(driving, 3 * QUIESCENT_MS, quiet=False) == (False, [])


def test_a_failure_on_schedule_is_waited_for(driving: Simulation) -> None:
    clock = driving.state.clock
    clock[PLANS] = clock[PLANNED] + 1
    assert stuck_after(driving, 3 * QUIESCENT_MS) == (False, [])


def test_who_lives_is_not_named_as_failed_where_too_few_are_left_to_decide() -> None:
    one = fleet()
    until(one, 2000)
    for i in (0, 1, 2):
        one.kill(i)
    one.finish()
    assert one.run.outcome == "stuck"
    said = str(one.run.sentence)
    for name in ("robot-1", "robot-2", "robot-3"):
        assert f"{name} failed" in said
    assert "robot-4 failed" not in said
    assert "robot-4 stands still since" in said
    assert "(it hears too few of its team)" in said
    assert ("robot-4", "stands still (it hears too few of its team)") in [(e.agent, e.text) for e in one.events]


def test_at_a_slow_pace_nobody_is_missed_between_two_ticks() -> None:
    one = Fleet(anew, pace=0.1)
    until(one, 20_000)
    assert one.run.outcome is None
    assert one.world.log == []
    assert one.run.tick > 90


# Cycles of one machine.


def state(number: int) -> Snapshot:
    return [number], [0], [0]


@pytest.mark.parametrize(("lead", "period"), [(0, 1), (0, 7), (5, 1), (13, 50), (100, 3)])
def test_a_cycle_is_found_whatever_its_period_and_what_comes_before(lead: int, period: int) -> None:
    recurrence = Recurrence()
    ticks = [-n for n in range(1, lead + 1)] + [n % period for n in range(6 * (period + lead) + 8)]
    found = [recurrence.repeats(state(number)) for number in ticks]
    assert not any(found[:lead])
    assert found[-1]
    assert recurrence.period == period


def test_what_goes_on_counting_is_no_cycle_and_leaving_one_is_seen_within_its_period() -> None:
    recurrence = Recurrence()
    assert not any(recurrence.repeats(state(n)) for n in range(1000))
    recurrence.reset()
    for n in range(100):
        recurrence.repeats(state(n % 5))
    assert recurrence.period == 5
    assert not [recurrence.repeats(state(1000 + n)) for n in range(6)][-1]
    recurrence.reset()
    assert recurrence.period == 0
