"""What holds whatever happens to robots: stock is conserved, plain and compiled code agree, a restored run goes on."""

from __future__ import annotations

from random import Random

import hypothesis
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.fault_schedule import KINDS
from kitrobot.sim.timeline import Timeline
from tests.effort import examples
from tests.sim.building import transport
from tests.sim.teams import random_team


def harms(random: Random, names: list[str], most: int) -> list[Failure]:
    """A random schedule."""
    return [
        Failure(random.choice(names), round(random.uniform(0, 4), 3), random.choice(KINDS))
        for _ in range(random.randrange(most + 1))
    ]


def by_hand(random: Random, names: list[str]) -> tuple[str, FailureKind]:
    return random.choice(names), random.choice(KINDS)


def boxes(run: Simulation) -> int:
    """All there are, in storehouses and on robots."""
    return sum(run.stock.values()) + sum(pose[3] for pose in run.poses())


@given(st.integers(0, 10**9))
@hypothesis.settings(max_examples=examples(7))
def test_stock_is_conserved_whatever_befalls_whom(seed: int) -> None:
    random = Random(seed)
    boxes_there, carriers = random.randrange(1, 9), random.randrange(1, 5)
    names = [agent.name for agent in transport(1, 1, carriers).members]
    schedule, rate = harms(random, names, 12), random.choice((0.0, 0.5))
    run = transport(seed, boxes_there, carriers, failures=schedule, fail_rate=rate)
    total = run.total
    for _ in range(10):
        run.advance(random.randrange(1, 300))
        run.inject_fault(*by_hand(random, names))
        assert boxes(run) == total
        assert run.outcome != "done" or run.stock["B"] == total


@pytest.mark.usefixtures("with_numba")
@given(st.integers(0, 10**9), st.integers(1, 12))
@hypothesis.settings(max_examples=examples(8, 500))
def test_plain_and_compiled_agree_on_failures(seed: int, robots: int) -> None:
    names = [agent.name for agent in random_team(seed, robots).members]
    random = Random(seed)
    schedule, rate = harms(random, names, 10), random.choice((0.0, 0.9))
    plain, compiled = random_team(seed, robots, schedule, rate), random_team(seed, robots, schedule, rate)
    assert compiled.compile_step()
    for _ in range(6):
        stretch, harmed = random.randrange(1, 60), by_hand(random, names)
        for run in (plain, compiled):
            run.advance(stretch)
            run.inject_fault(*harmed)
        assert plain.snapshot() == compiled.snapshot()
        assert plain.agents == compiled.agents
        assert (plain.outcome, plain.sentence, plain.events) == (compiled.outcome, compiled.sentence, compiled.events)


@given(st.integers(0, 10**9))
@hypothesis.settings(max_examples=examples(7))
def test_a_restored_run_goes_on_alike(seed: int) -> None:
    random = Random(seed)
    robots = random.randrange(1, 8)
    names = [agent.name for agent in random_team(seed, robots).members]
    run = random_team(seed, robots, harms(random, names, 8), random.choice((0.0, 0.9)))
    for _ in range(4):
        run.advance(random.randrange(1, 60))
        run.inject_fault(*by_hand(random, names))
    kept = run.snapshot()
    after = [(run.advance(40), run.snapshot(), run.events, run.outcome, run.sentence)]
    run.restore(kept)
    after.append((run.advance(40), run.snapshot(), run.events, run.outcome, run.sentence))
    assert after[0] == after[1]


@given(st.integers(0, 10**9))
@hypothesis.settings(max_examples=12, deadline=None)
def test_a_timeline_that_goes_back_and_forth_tells_one_story(seed: int) -> None:
    random = Random(seed)
    names = [agent.name for agent in transport(seed, 3, 3).members]
    schedule = harms(random, names, 6)
    timeline = Timeline(transport(seed, 3, 3, failures=schedule), room_bytes=random.choice((20_000, 10_000_000)))
    for _ in range(10):
        if random.random() < 0.4:
            timeline.inject_fault(*by_hand(random, names))
        elif random.random() < 0.5:
            timeline.go_to(random.randrange(timeline.latest + 1))
        else:
            timeline.advance(random.randrange(1, 150))
    timeline.go_to(timeline.latest)
    straight = transport(seed, 3, 3, failures=schedule)
    events: list[Event] = []
    for tick in range(timeline.latest + 1):
        for one in timeline.interventions:
            if one.tick == tick:
                straight.inject_fault(one.agent, one.name)
        if tick < timeline.latest:
            straight.step()
            events += straight.events
    assert straight.agents == timeline.simulation.agents
    assert (straight.outcome, straight.sentence) == (timeline.simulation.outcome, timeline.simulation.sentence)
    assert events == timeline.events
