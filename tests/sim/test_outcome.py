"""How runs end: done, failed, stuck only when certain, time; and what keeps them from beginning."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.mission.model import Goal
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import CHANCE, STUCK
from kitrobot.world.model import Wall
from tests.effort import examples
from tests.sim.building import (
    WHEEL,
    avatar,
    catalogue,
    empty_world,
    example_images,
    run_of,
    shipped_world,
    transport,
)

ROOM = empty_world(a=(1000, 1000, 0), b=(2000, 1000, 0))
MINI = "mini-robot"


def ended(text: str, seconds: float | None = 30, other: str = "") -> Simulation:
    mini = catalogue().robots[MINI]
    agents = {"a": (mini, text)} | ({"b": (mini, other)} if other else {})
    run = run_of(agents, ROOM, seconds=seconds)
    while run.outcome is None:
        run.step()
    return run


def test_a_mission_without_goals_is_done_when_every_program_has_ended() -> None:
    run = ended("WAIT(10);", other="WAIT(20);")
    assert (run.outcome, run.tick) == ("done", 101)
    assert run.sentence == "Done after 2.0 s: every program has ended."


def test_an_empty_program_is_done_at_once() -> None:
    assert (ended("").outcome, ended("").tick) == ("done", 1)


def test_a_goal_that_does_not_hold_makes_it_failed_and_is_named() -> None:
    manager = catalogue().robots["store-manager"]
    run = run_of({"store-manager-B": (manager, "WAIT(1);")}, shipped_world("ring"), [Goal("B"), Goal("A", "12")])
    while run.outcome is None:
        run.step()
    assert run.outcome == "failed"
    assert run.sentence == "Every program has ended, but B holds 0 of 12 boxes and A holds all 12 boxes."


@pytest.mark.parametrize(
    "text",
    [
        "<Flag.IsTrue()>();",
        "*[Run.IsTrue()]( WAIT(1); );",
        "*[Run.IsTrue()]( WAIT(7); );",
        "*[Run.IsTrue()]( [Button.IsPressed()]( Light.LightOn(); ) );",
        "//( <Flag.IsTrue()>(), *[Run.IsTrue()]( WAIT(3); ) );",
        "Motor.AbsoluteTurn(25, 0);",
        "Wheel.Advance(50); WAIT(5); Wheel.Stop(); <Flag.IsTrue()>();",
    ],
)
def test_waiting_for_what_cannot_come_is_stuck(text: str) -> None:
    run = ended(text)
    assert run.outcome == "stuck", run.sentence
    assert run.sentence == "Nothing can change any more: a waits for something that will not come."
    assert run.seconds < 20


@pytest.mark.parametrize(("value", "outcome"), [(1, "done"), (0, "stuck")])
def test_a_run_that_is_stuck_goes_on_when_a_sensor_is_held_by_hand(value: int, outcome: str) -> None:
    """Where its program then waits as before, it is stuck once more, later."""
    run = ended("<Button.IsPressed()>(); WAIT(5);")
    tick = run.tick
    assert run.outcome == "stuck"
    run.force("a", "Button", value)
    assert run.sentence == ""
    after = gone_on(run)
    assert after.outcome == outcome
    assert after.tick > tick


def test_a_run_that_is_stuck_goes_on_when_a_variable_is_set_by_hand() -> None:
    run = ended("*[Count.LessThan(1)]( WAIT(1); );")
    assert run.outcome == "stuck"
    run.set_variable("a", "Count", 1)
    after = gone_on(run)
    assert after.outcome == "done"


def test_a_run_that_is_done_stays_done_whatever_is_held() -> None:
    run = ended("WAIT(1);")
    run.force("a", "Button", 1)
    run.set_variable("a", "Count", 7)
    assert run.outcome == "done"


@pytest.mark.parametrize(
    "text",
    [
        "WAIT(250);",
        "100*( WAIT(2); );",
        "*[Count.LessThan(20)]( WAIT(10); Count.Add(1); );",
        "*[Count.LessThan(100)]( Count.Add(1); );",
    ],
)
def test_what_takes_its_time_is_not_stuck(text: str) -> None:
    assert ended(text).outcome == "done"


@pytest.mark.parametrize(
    "text",
    [
        "Wheel.Advance(1); <Flag.IsTrue()>();",
        "*[Run.IsTrue()]( Light.LightOn(); WAIT(1); Light.LightOff(); WAIT(1); );",
    ],
)
def test_what_still_moves_or_speaks_is_not_stuck_but_runs_out_of_time(text: str) -> None:
    assert ended(text, seconds=20).outcome == "time"


def test_a_moving_robot_is_never_called_stuck() -> None:
    assert ended("Motor.Turn(1); <Flag.IsTrue()>();", seconds=20).outcome == "time"


def test_who_pushes_against_a_wall_for_ever_is_stuck() -> None:
    mini = catalogue().robots[MINI]
    walled = replace(ROOM, walls=(Wall(1500, 500, 1500, 1500),))

    def pushing(text: str) -> Simulation:
        return gone_on(run_of({"a": (mini, text)}, walled, seconds=100))

    assert pushing("Wheel.Advance(50); <Flag.IsTrue()>();").outcome == "stuck"
    assert pushing("Wheel.Advance(50); WAIT(300); Wheel.Stop();").outcome == "done", "that ends by itself"


def stalled(seed: int, step: int, agent: str = "carrier-1", failures: Sequence[Failure] = ()) -> Simulation:
    """The transport mission in which somebody stalls; its wheels go on as they were told."""
    run = transport(seed, failures=failures)
    run.stays_plain = True
    run.advance(step)
    run.inject_fault(agent, "stall")
    return run


def gone_on(run: Simulation, most: int = 6000) -> Simulation:
    while run.outcome is None and run.tick < most:
        run.advance(500)
    return run


@pytest.mark.parametrize("step", [50, 700])
def test_who_is_pushed_from_behind_drives_on(step: int) -> None:
    """Both collision sensors were pressed where two touched, and both waited for ever."""
    run = gone_on(stalled(1, step))
    assert run.collisions > 0
    assert run.outcome == "done", run.sentence


@pytest.mark.parametrize("step", [200, 1000, 1500])
def test_a_ring_on_which_a_stalled_one_pushes_the_others_is_stuck(step: int) -> None:
    run = gone_on(stalled(1, step))
    assert run.outcome == "stuck"
    assert f"carrier-1 stalled after {step / 50:.1f} s (by hand)" in run.sentence


@settings(max_examples=examples(5))
@given(st.integers(0, 99), st.integers(1, 2500), st.sampled_from(["carrier-1", "carrier-2", "carrier-3", "loader"]))
def test_what_is_called_stuck_never_changes_again(seed: int, step: int, agent: str) -> None:
    run = gone_on(stalled(seed, step, agent))
    if run.outcome != "stuck":
        return

    def standing() -> list[object]:
        return [[list(row) for row in run.state.robots.floats], list(run.state.docks.stock), run.collisions]

    before = standing()
    run.outcome, run.state.clock[STUCK] = None, 0
    run.state.clock[CHANCE] = 1  # so that it is not looked for again
    assert run.advance(4000) == 4000
    assert standing() == before
    assert run.events == []


def test_while_the_schedule_may_let_go_of_the_others_nobody_is_called_stuck() -> None:
    later = [Failure("carrier-1", 60.0, FailureKind.FAIL)]
    run = gone_on(stalled(1, 400, failures=later), 2900)
    assert run.outcome is None, "without the schedule it is stuck after 1300 steps"
    gone_on(run)
    ended: str | None = run.outcome
    assert ended == "stuck"
    assert run.tick > 3000


def test_a_snapshot_of_robots_that_are_held_goes_on_to_the_same_end() -> None:
    run = stalled(1, 400)
    run.advance(1240 - 400)
    other = transport(1)
    other.stays_plain = True
    other.restore(run.snapshot())
    assert run.outcome is None
    assert (gone_on(run).tick, run.outcome) == (gone_on(other).tick, other.outcome)
    assert run.snapshot() == other.snapshot()


def test_a_noisy_sensor_keeps_hope_alive() -> None:
    noisy = avatar(
        WHEEL.format(settings=""),
        '<sensor name="Captor" device="range" min="0" max="1000" noise="1"><operation name="Value" value="yes"/>'
        '<operation name="LessThan" test="less"><parameter name="value" min="0" max="1000"/></operation></sensor>',
    )
    run = run_of({"a": (noisy, "<Captor.LessThan(1)>();")}, ROOM, seconds=10)
    while run.outcome is None:
        run.step()
    assert run.outcome == "time"


def test_a_team_whose_carriers_wait_for_a_loader_that_is_not_there_is_stuck() -> None:
    run = transport(1)
    mission = run.mission
    mission.team.agents = [agent for agent in mission.team.agents if agent.name != "loader"]
    run = Simulation(mission, run.world, example_images(), catalogue(), 1, 600)
    while run.outcome is None:
        run.step()
    assert run.outcome == "stuck"
    assert run.seconds < 60
    assert "B holds 0 of 12 boxes" in run.sentence
    assert "carrier-1" in run.sentence


@pytest.mark.parametrize(
    ("agent", "kind", "why"),
    [
        ("store-manager-B", FailureKind.FAIL, "store-manager-B failed after 20.0 s (on schedule)"),
        ("store-manager-B", FailureKind.STALL, "store-manager-B stalled after 20.0 s (on schedule)"),
        ("store-manager-A", FailureKind.STALL, "store-manager-A stalled after 20.0 s (on schedule)"),
        ("store-manager-A", FailureKind.MUTE, "store-manager-A has no radio"),
        ("unloader", FailureKind.MUTE, "unloader has no radio"),
        ("loader", FailureKind.MUTE, "loader has no radio"),
    ],
)
def test_a_goal_that_holds_is_done_whoever_failed(agent: str, kind: FailureKind, why: str) -> None:
    run = gone_on(transport(1, failures=[Failure(agent, 20.0, kind)]))
    assert run.outcome == "done", run.sentence
    assert run.sentence == f"Done after {run.seconds:.1f} s, although {why}: B holds all 12 boxes."
    assert run.seconds < 70


def test_many_steps_at_once_and_one_by_one_end_a_run_whose_goal_holds_at_the_same_tick() -> None:
    failures = [Failure("loader", 20.0, FailureKind.MUTE)]
    single = transport(1, failures=failures)
    while single.outcome is None:
        single.step()
    assert single.tick == gone_on(transport(1, failures=failures)).tick


def test_who_is_to_be_revived_may_still_end_its_program() -> None:
    failures = [Failure("loader", 20.0, FailureKind.MUTE), Failure("loader", 80.0, FailureKind.REVIVE)]
    run = gone_on(transport(1, failures=failures))
    assert (run.outcome, run.sentence) == ("done", f"Done after {run.seconds:.1f} s: B holds all 12 boxes.")
    assert run.seconds > 80


def test_a_goal_that_holds_when_the_time_is_over_is_done() -> None:
    manager = catalogue().robots["store-manager"]
    agents = {"store-manager-A": (manager, "WAIT(9);"), "store-manager-B": (manager, "WAIT(99);")}
    run = gone_on(run_of(agents, shipped_world("ring"), [Goal("A", "12")], seconds=2))
    assert run.outcome == "done"
    assert run.sentence == "Done after 2.0 s, although 1 of 2 programs had not ended: A holds all 12 boxes."


def test_a_goal_that_holds_for_a_moment_on_the_way_ends_nothing() -> None:
    run = transport(1)
    mission = run.mission
    mission.team.goals = [Goal("B", "3")]
    run = gone_on(Simulation(mission, run.world, example_images(), catalogue(), 1, 600))
    assert (run.outcome, run.stock["B"]) == ("failed", 12)
    assert run.sentence == "Every program has ended, but B holds 12 boxes instead of 3."


def test_a_team_whose_storehouse_is_full_is_stuck_and_the_sentence_names_it() -> None:
    run = transport(1)
    houses = tuple(replace(house, capacity=5) if house.name == "B" else house for house in run.world.storehouses)
    world = replace(run.world, storehouses=houses)
    run = gone_on(Simulation(run.mission, world, example_images(), catalogue(), 1, 600))
    assert run.outcome == "stuck"
    assert "wait for something that will not come; storehouse B is full; B holds 5 of 12 boxes." in run.sentence


LEAVING = "leaves the world: only walls hold robots at its edge"


def test_who_drives_over_the_edge_of_the_world_is_told_once_and_named_in_the_end() -> None:
    mini = catalogue().robots[MINI]
    run = run_of({"a": (mini, "Wheel.Advance(50); WAIT(900);")}, replace(ROOM, walls=()), seconds=20)
    told: list[tuple[int, str, str]] = []
    while run.outcome is None:
        run.advance(100)
        told += [(event.tick, event.agent, event.text) for event in run.events]
    assert told == [(756, "a", LEAVING)], "3000 mm at 200 mm/s, and the gaining of speed"
    assert run.outcome == "time"
    assert run.sentence == (
        "The time of 20 s ran out: the program had not ended; a left the world, which has no wall there."
    )


def test_who_comes_back_into_the_world_is_not_named_in_the_end() -> None:
    mini = catalogue().robots[MINI]
    room = replace(empty_world(a=(3990, 1000, 0)), walls=())
    out_and_in = "Wheel.Advance(50); WAIT(10); Wheel.Reverse(50); WAIT(20); Wheel.Advance(50); WAIT(15);"
    run = run_of({"a": (mini, out_and_in + "Wheel.Reverse(50); WAIT(20);")}, room)
    texts = []
    while run.outcome is None:
        run.step()
        texts += [event.text for event in run.events]
    assert texts == [LEAVING, "its program has ended"]
    assert run.sentence == f"Done after {run.seconds:.1f} s: every program has ended; a ended with its motors on."


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (["a"], "a waits"),
        (["a", "b"], "a and b wait"),
        (["a", "b", "c"], "a, b and c wait"),
        (list("abcdefg"), "a, b, c, d, e and 2 more wait"),
    ],
)
def test_one_waits_and_many_wait(names: list[str], said: str) -> None:
    mini = catalogue().robots[MINI]
    room = empty_world(**{name: (300 + 400 * n, 1000, 0) for n, name in enumerate(names)})
    run = gone_on(run_of(dict.fromkeys(names, (mini, "<Flag.IsTrue()>();")), room))
    assert run.sentence == f"Nothing can change any more: {said} for something that will not come."


def test_the_one_program_of_a_run_is_not_counted() -> None:
    assert ended("WAIT(99);", seconds=1).sentence == "The time of 1 s ran out: the program had not ended."


def test_a_program_that_never_waits_and_never_ends_is_bounded() -> None:
    assert ended("*[Run.IsTrue()]( Count.Add(1); Count.Sub(1); );").outcome == "stuck"
    assert ended("*[Run.IsTrue()]( [Flag.IsTrue()]( Flag.Set(0); )!( Flag.Set(1); ); );").outcome == "stuck"


AT_ONCE = "came to its end at once, without a part that takes time"


def test_a_run_that_ends_before_time_passes_says_so_and_whose_motors_are_on() -> None:
    run = ended("Wheel.Advance(50);")
    assert run.ended_at_once
    assert run.sentence == f"Done after 0.0 s: the program {AT_ONCE}; a ended with its motors on."
    both = ended("Wheel.Advance(50);", other="Motor.Turn(50);")
    assert both.sentence == f"Done after 0.0 s: every program {AT_ONCE}; a and b ended with their motors on."
    assert ended("Wheel.Advance(50); Wheel.Stop();").sentence == f"Done after 0.0 s: the program {AT_ONCE}."


def test_a_run_that_takes_time_says_whose_motors_are_on_in_the_end() -> None:
    run = ended("Wheel.Advance(50); WAIT(10);")
    assert not run.ended_at_once
    assert run.sentence == "Done after 1.0 s: every program has ended; a ended with its motors on."
    assert ended("Wheel.Advance(50); WAIT(10); Wheel.Stop();").sentence.endswith("every program has ended.")
