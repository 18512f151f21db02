"""Fields of a fail sweep begin in the middle, and are what a run from the start is with the same failures."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.sweep import Fault, Field, SweepStoppedError, Task, moments_of, run_task, snapshots_at
from kitrobot.sim.tables.columns import EVENTS
from tests.effort import examples
from tests.sim.building import transport
from tests.sim.team_building import RunningTeam, random_team_program
from tests.sim.teams import random_team
from tests.team_programs.hosting import TooLarge

Make = Callable[[Sequence[Failure]], Simulation]
"""A run before its first step, with these failures on its schedule."""


def limited(run: Simulation, seconds: float = 6) -> Simulation:
    run.seconds_limit, run._last_tick = seconds, round(seconds * 1000 / run.tick_ms)
    return run


def state_of(run: Simulation) -> bytes:
    """All that a run goes on from, but what happened in its last steps."""
    run.state.clock[EVENTS] = 0
    return run._codec.encode(run.state)


def sweep(make: Make, failures: Sequence[Failure], count: int, pairs: bool) -> list[tuple[Field, bytes]]:
    """The fields of a sweep, each with the state at its end."""
    run = limited(make(failures))
    while run.outcome is None:
        run.advance(1000)
    moments = moments_of(run.tick, count)
    kept, agents = snapshots_at(limited(make(failures)), moments), tuple(range(len(run.members)))
    field_run, found = limited(make(failures)), []
    for n, tick in enumerate(moments):
        for agent in agents:
            first = Fault(agent, tick)
            task = Task(first, kept[tick], agents, moments[n:]) if pairs else Task(first, kept[tick])
            fields = [(field, state_of(field_run)) for field in run_task(field_run, task)]
            assert len(fields) == task.size
            found += fields
    return found


def from_the_start(make: Make, failures: Sequence[Failure], field: Field) -> tuple[Field, bytes]:
    """The same field, as one run of a mission with these failures."""
    probe = make(failures)
    names, step_s = [agent.name for agent in probe.members], probe.tick_ms / 1000
    more = [Failure(names[fault.agent], fault.tick * step_s) for fault in field.faults]
    run = limited(make([*failures, *more]))
    while run.outcome is None:
        run.advance(1000)
    return Field(field.faults, run.outcome, run.sentence, run.tick), state_of(run)


def are_the_same(make: Make, failures: Sequence[Failure], count: int, pairs: bool, sample: int, seed: int) -> None:
    fields = sweep(make, failures, count, pairs)
    over = {field.faults: field.ticks for field, _ in fields}
    assert len(over) == len(fields)
    for field, state in random.Random(seed).sample(fields, min(sample, len(fields))):
        other, other_state = from_the_start(make, failures, field)
        if field.faults[-1].tick < field.ticks:
            assert (field, state) == (other, other_state)
        else:
            # The second one fails after the end: then nothing more is said of it.
            assert (field.outcome, field.sentence) == (other.outcome, other.sentence)


@given(st.integers(0, 10**9), st.integers(1, 3), st.booleans())
@settings(max_examples=examples(3))
def test_fields_of_random_teams_are_runs_from_the_start(seed: int, robots: int, pairs: bool) -> None:
    chance = random.Random(seed)
    failures = [Failure("r0", chance.random() * 5, chance.choice(tuple(FailureKind))) for _ in range(2)]
    are_the_same(lambda given: random_team(seed, robots, given), failures, 2, pairs, 3, seed)


@given(st.integers(0, 10**9), st.booleans())
@settings(max_examples=examples(2))
def test_fields_of_teams_with_spare_robots_are_runs_from_the_start(seed: int, pairs: bool) -> None:
    maker, program = random_team_program(seed, 1)

    def make(failures: Sequence[Failure]) -> Simulation:
        return RunningTeam(maker, program, seed, list(failures)).run

    try:
        make([])
    except TooLarge:
        assume(False)
    are_the_same(make, [], 2, pairs, 3, seed)


def test_a_field_in_which_nobody_is_left_ends_as_a_run_from_the_start() -> None:
    make: Make = lambda failures: random_team(7, 1, failures)  # noqa: E731
    are_the_same(make, [], 4, False, 4, 1)


def test_who_is_held_for_ever_is_stuck_at_the_same_step_as_in_a_run_from_the_start() -> None:
    run = limited(transport(1, 2), 200)
    while run.outcome is None:
        run.advance(1000)
    [moment] = [run.tick // 2]
    kept = snapshots_at(limited(transport(1, 2), 200), [moment])
    [field] = run_task(run, Task(Fault(0, moment), kept[moment]))
    assert field.outcome == "stuck"
    assert "carrier-1 failed after" in field.sentence
    assert "(on schedule)" in field.sentence


def test_moments_are_spread_over_the_run_from_its_first_step_on() -> None:
    assert moments_of(1000, 4) == (0, 250, 500, 750)
    assert moments_of(3, 100) == (0, 1, 2)
    assert moments_of(0, 5) == (0,)


def test_a_sweep_is_broken_off_in_the_middle_of_a_field() -> None:
    run = limited(transport(1, 2))
    kept = run.snapshot()
    with pytest.raises(SweepStoppedError):
        list(run_task(run, Task(Fault(0, 0), kept), lambda: True))
