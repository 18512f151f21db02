"""Robots that fail, stall, lose their radio and are revived: by hand, on schedule, by chance; how such runs end."""

from __future__ import annotations

from dataclasses import replace
from math import exp, log

import pytest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.model import Goal
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.agent_views import FAILED, MOVING, MUTED, STALLED
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from tests.sim.building import MOTOR, WHEEL, avatar, empty_world, run_of, shipped_world, steps, transport

TICK_S = 0.02
DRIVER = avatar(WHEEL.format(settings='speed="400" braking="800" acceleration="800"'))
TURNER = avatar(MOTOR.format(settings='rate="180"'))
COUNTER = avatar('<variable name="Own" type="integer" min="0" max="1000"/>', name="counter")
SHARER = avatar('<variable name="All" type="integer" min="0" max="50" shared="yes"/>', name="sharer")


def told(run: Simulation, count: int) -> list[Event]:
    """What happened in so many steps."""
    found = []
    for _ in range(count):
        run.advance(1)
        found += run.events
    return found


def test_a_failed_robot_brakes_as_physics_says_and_stays_where_it_is() -> None:
    run = run_of({"a": (DRIVER, "Wheel.Advance(100); WAIT(1000);")}, empty_world(a=(200, 500, 0)))
    steps(run, 50)
    before = run.poses()[0]
    assert before[4] & MOVING
    run.inject_fault("a", "fail")
    assert run.poses()[0][4] & FAILED
    assert run.agents[0].state == "failed"
    # Nobody is left, so the run has ended; its physics still follows v²/2a = 400²/1600 mm when somebody else goes on.
    assert run.outcome == "failed"

    pair = {"a": (DRIVER, "Wheel.Advance(100); WAIT(1000);"), "b": (COUNTER, "WAIT(1000);")}
    run = run_of(pair, empty_world(a=(200, 500, 0), b=(2000, 2000, 0)))
    steps(run, 50)
    from_x = run.poses()[0][0]
    run.inject_fault("a", FailureKind.FAIL)
    steps(run, 100)
    x, _, _, _, flags = run.poses()[0]
    assert x - from_x == pytest.approx(100.0, abs=1e-6)
    assert flags & FAILED
    assert not flags & MOVING
    steps(run, 100)
    assert run.poses()[0][0] == x


def test_a_failed_robot_stops_turning_at_once_and_turns_on_when_it_is_revived() -> None:
    run = run_of(
        {"a": (TURNER, "Motor.Turn(50); WAIT(1000);"), "b": (COUNTER, "WAIT(1000);")},
        empty_world(a=(500, 500, 0), b=(2000, 2000, 0)),
    )
    steps(run, 20)
    run.inject_fault("a", "fail")
    heading = run.poses()[0][2]
    steps(run, 20)
    assert run.poses()[0][2] == heading
    run.inject_fault("a", "revive")
    steps(run, 10)
    assert run.poses()[0][2] == pytest.approx(heading + 10 * TICK_S * 3.14159265 / 2, abs=1e-6)


def test_who_is_revived_drives_on_with_its_program_where_it_was() -> None:
    text = "*[Own.LessThan(999)]( Own.Add(1); WAIT(1); );"
    run = run_of({"a": (COUNTER, text), "b": (COUNTER, text)}, empty_world(a=(500, 500, 0), b=(2000, 2000, 0)))
    steps(run, 100)
    at = run.agents[0].values["Own"]
    run.inject_fault("a", "fail")
    steps(run, 300)
    assert run.agents[0].values["Own"] == at
    run.inject_fault("a", "revive")
    steps(run, 100)
    assert run.agents[0].values["Own"] == pytest.approx(at + 20, abs=1)
    assert run.agents[0].state == "waiting"


def test_a_stalled_robot_goes_on_as_it_was_told_and_hears_nothing() -> None:
    run = run_of(
        {"a": (DRIVER, "Wheel.Advance(100); WAIT(30); Wheel.Stop(); WAIT(100);")}, empty_world(a=(200, 500, 0))
    )
    steps(run, 50)
    run.inject_fault("a", "stall")
    x = run.poses()[0][0]
    steps(run, 150)
    assert run.poses()[0][0] - x == pytest.approx(400 * 150 * TICK_S)
    assert run.poses()[0][4] & (STALLED | MOVING) == STALLED | MOVING
    assert run.agents[0].state == "stalled"
    run.inject_fault("a", "revive")
    steps(run, 200)
    assert not run.poses()[0][4] & (STALLED | MOVING)


def sharers(*failures: Failure) -> Simulation:
    """a writes 1, 2, … every 200 ms; b listens; c writes nothing."""
    return run_of(
        {
            "a": (SHARER, "*[All.LessThan(50)]( All.Add(1); WAIT(2); );"),
            "b": (SHARER, "WAIT(1000);"),
            "c": (SHARER, "WAIT(1000);"),
        },
        empty_world(a=(500, 500, 0), b=(1500, 500, 0), c=(2500, 500, 0)),
        failures=failures,
    )


def values(run: Simulation) -> list[int]:
    """What each holds for the shared variable."""
    return [agent.values["All"] for agent in run.agents]


def test_a_muted_robot_hears_nothing_and_catches_up_by_the_latest_write() -> None:
    run = sharers()
    steps(run, 30)
    run.inject_fault("b", "mute")
    heard = values(run)[1]
    steps(run, 50)
    assert values(run)[1] == heard
    assert values(run)[0] == values(run)[2] > heard
    assert run.poses()[1][4] & MUTED
    run.inject_fault("b", "revive")
    assert len(set(values(run))) == 1


def test_what_a_muted_robot_wrote_is_heard_when_it_is_the_latest() -> None:
    run = sharers()
    steps(run, 30)
    run.inject_fault("a", "mute")
    heard = values(run)[1]
    steps(run, 50)
    assert values(run)[0] > heard == values(run)[1] == values(run)[2]
    mine = values(run)[0]
    run.inject_fault("a", "revive")
    assert values(run) == [mine] * 3
    assert [(event.kind, event.text) for event in run.unreported_events] == [
        ("failure", "loses its radio (by hand)"),
        ("revival", "is well again (by hand)"),
        ("message", f"All = {mine}"),
    ][1:]


def test_an_older_write_of_a_muted_robot_gives_way() -> None:
    run = sharers()
    steps(run, 30)
    run.inject_fault("c", "mute")
    run.set_variable("c", "All", 49)
    steps(run, 1)
    assert values(run)[2] == 49
    steps(run, 80)
    run.inject_fault("c", "revive")
    assert values(run) == [values(run)[0]] * 3
    assert values(run)[0] < 49


def test_a_schedule_holds_at_the_first_step_at_or_after_its_moment() -> None:
    run = sharers(Failure("b", 0.05, FailureKind.STALL), Failure("a", 0.0), Failure("b", 0.1, FailureKind.REVIVE))
    assert [(event.tick, event.agent, event.text, event.cause) for event in told(run, 10)] == [
        (0, "a", "fails (on schedule)", "mission"),
        (3, "b", "stalls (on schedule)", "mission"),
        (5, "b", "is well again (on schedule)", "mission"),
    ]


def test_somebody_who_takes_no_part_cannot_fail() -> None:
    run = sharers(Failure("nobody", 0.0))
    assert [event for event in told(run, 5) if event.kind == "failure"] == []
    with pytest.raises(KitRobotError, match="no agent nobody takes part"):
        run.inject_fault("nobody", "fail")


def test_what_changes_nothing_is_no_news() -> None:
    run = sharers()
    assert not run.inject_fault("a", "revive")
    assert run.inject_fault("a", "fail")
    assert not run.inject_fault("a", "fail")
    assert not run.inject_fault("a", "stall")
    assert [event.text for event in run.unreported_events] == ["fails (by hand)"]
    assert [event.text for event in told(run, 2) if event.kind == "failure"] == ["fails (by hand)"]
    assert run.unreported_events == []


def test_too_much_between_two_steps_is_refused_with_a_sentence() -> None:
    run = sharers()

    def much() -> None:
        for _ in range(10_000):
            run.inject_fault("a", "fail")
            run.inject_fault("a", "revive")

    with pytest.raises(KitRobotError, match="too much was done"):
        much()
    run.step()
    run.inject_fault("a", "fail")


# -- chance


def many(count: int, rate: float, seed: int) -> Simulation:
    """Robots that do nothing, in rows."""
    poses = {f"r{n}": (200.0 + 10 * (n % 40), 200.0 + 10 * (n // 40), 0.0) for n in range(count)}
    return run_of(
        dict.fromkeys(poses, (COUNTER, "WAIT(1000);")),
        empty_world(**poses),
        seed=seed,
        seconds=None,
        fail_rate=rate,
    )


def test_chance_has_the_rate_it_is_given_and_is_the_same_for_the_same_seed() -> None:
    rate, count, seconds = 0.6, 200, 59
    run, twin, other = many(count, rate, 7), many(count, rate, 7), many(count, rate, 8)
    events = [told(one, seconds * 50) for one in (run, twin, other)]
    assert events[0] == events[1] != events[2]
    assert {event.text for event in events[0]} == {"fails (by chance)"}
    expected = 1 - exp(seconds / 60 * log(1 - rate))
    spread = (expected * (1 - expected) / count) ** 0.5
    assert len(events[0]) / count == pytest.approx(expected, abs=4 * spread)
    # Everybody has turns of its own.
    assert len({event.tick % 50 for event in events[0]}) > 20


def test_without_a_rate_nobody_fails_and_with_certainty_everybody() -> None:
    assert told(many(20, 0.0, 1), 500) == []
    run = many(20, 1.0, 1)
    assert len(told(run, 60)) == 20
    assert run.outcome == "failed"


# -- endings


def test_when_nobody_is_left_the_run_has_failed_and_says_who() -> None:
    run = transport(1, 2, 2, failures=[Failure(agent.name, 1.0) for agent in transport(1, 2, 2).members])
    steps(run, 200)
    assert run.outcome == "failed"
    assert run.sentence.startswith("Nobody is left to go on: ")
    assert "carrier-1 failed after 1.0 s (on schedule)" in run.sentence
    assert run.sentence.endswith("B holds 0 of 2 boxes.")
    assert run.tick == 51


def test_a_failure_that_is_to_be_revived_is_no_end() -> None:
    names = [agent.name for agent in transport(1, 2, 2).members]
    failures = [Failure(name, 1.0) for name in names] + [Failure(name, 5.0, FailureKind.REVIVE) for name in names]
    run = transport(1, 2, 2, failures=failures)
    steps(run, 240)
    assert run.outcome is None
    assert {agent.state for agent in run.agents} == {"failed"}
    run.advance(30_000)
    assert run.outcome == "done"


def test_success_is_not_claimed_without_the_one_who_failed() -> None:
    run = run_of({"a": (COUNTER, "WAIT(10);"), "b": (COUNTER, "WAIT(10);")}, empty_world(a=(1, 1, 0), b=(900, 1, 0)))
    run.inject_fault("a", "fail")
    steps(run, 100)
    assert (run.outcome, run.sentence) == (
        "failed",
        "Every other program has ended, but a failed after 0.0 s (by hand).",
    )


def test_goals_that_hold_are_done_whoever_failed() -> None:
    wait = "WAIT(10);"
    run = run_of(
        {"a": (COUNTER, wait), "b": (COUNTER, wait)},
        replace(shipped_world("ring"), starts=empty_world(a=(1, 1, 0), b=(900, 1, 0)).starts),
        [Goal("B", "0")],
        failures=[Failure("a", 0.5)],
    )
    steps(run, 100)
    assert run.outcome == "done"
    assert run.sentence.startswith("Done after 1.0 s, although a failed after 0.5 s (on schedule): B holds")


def test_who_waits_for_a_failed_one_is_stuck_and_the_sentence_names_it() -> None:
    wait = "WAIT(1000);"
    listening = "*[All.EqualTo(0)]( WAIT(1); );"
    run = run_of(
        {"a": (SHARER, listening), "b": (SHARER, wait)}, empty_world(a=(500, 500, 0), b=(1500, 500, 0)), seconds=None
    )
    steps(run, 10)
    run.inject_fault("b", "fail")
    run.advance(5000)
    assert run.outcome == "stuck"
    assert "a waits for something that will not come; b failed after 0.2 s (by hand)." in run.sentence


def test_a_run_that_ended_goes_on_when_somebody_is_revived() -> None:
    run = run_of({"a": (COUNTER, "WAIT(10);")}, empty_world(a=(500, 500, 0)))
    steps(run, 5)
    run.inject_fault("a", "fail")
    outcomes: list[str | None] = [run.outcome]
    assert run.advance(10) == 0
    run.inject_fault("a", "revive")
    outcomes.append(run.outcome)
    run.advance(1000)
    assert [*outcomes, run.outcome] == ["failed", None, "done"]


def test_stop_stands_everything_still() -> None:
    run = run_of({"a": (DRIVER, "Wheel.Advance(100); WAIT(1000);")}, empty_world(a=(200, 500, 0)))
    steps(run, 50)
    assert run.poses()[0][4] & MOVING
    run.stop_motors()
    assert not run.poses()[0][4] & MOVING
