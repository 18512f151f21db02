"""Going back in a run and on again: the same run, to the byte, or another one from where something else was done."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kitrobot
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.timeline import PIECE, Intervention, Timeline
from kitrobot.trace.source import walk
from kitrobot.translation.translator import translate_to
from tests.effort import examples
from tests.sim.building import catalogue, empty_world, run_of

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TRANSPORT = kitrobot.open(EXAMPLES / "transport" / "transport.krt")
FARTHEST = 400


def fresh() -> Simulation:
    return TRANSPORT.simulation(seed=3)


def straight(to: int, interventions: list[Intervention]) -> Simulation:
    """The same run without ever going back."""
    simulation = fresh()
    for tick in range(to + 1):
        for one in interventions:
            if one.tick != tick:
                continue
            if one.kind == "force":
                simulation.force(one.agent, one.name, one.value)
            else:
                simulation.set_variable(one.agent, one.name, one.value or 0)
        if tick < to:
            simulation.step()
    return simulation


def same(one: Simulation, other: Simulation) -> bool:
    """Whether two runs stand alike and go on alike; what happened last is told by each in its own portions."""
    if (one.tick, one.outcome, one.agents, one.stock) != (other.tick, other.outcome, other.agents, other.stock):
        return False
    after = []
    for simulation in (one, other):
        twin = TRANSPORT.simulation(seed=simulation.seed)
        twin.restore(simulation.snapshot())
        twin.step()
        after.append(twin.snapshot() if twin.outcome is None else None)
    return after[0] == after[1]


def said(timeline: Timeline) -> str | None:
    """How the run has ended, if it stands at its end."""
    return timeline.simulation.outcome


def act(timeline: Timeline, random: Random) -> Intervention:
    """Something that a person does to the run."""
    if random.random() < 0.5:
        value = random.choice([None, 0, 1])
        timeline.force("carrier-1", "Collision", value)
        return Intervention(timeline.tick, "force", "carrier-1", "Collision", value)
    value = random.randrange(6)
    timeline.set_variable("carrier-2", "Dock", value)
    return Intervention(timeline.tick, "set", "carrier-2", "Dock", value)


@settings(max_examples=examples(6))
@given(st.integers(0, 2**32))
def test_any_way_there_leads_to_the_same_place(seed: int) -> None:
    random = Random(seed)
    timeline = Timeline(fresh(), room_bytes=random.choice([20_000, 200_000, 10_000_000]))
    done: list[Intervention] = []
    for _ in range(8):
        match random.randrange(4):
            case 0 | 1:
                timeline.advance(random.randrange(1, FARTHEST // 4))
            case 2:
                timeline.go_to(random.randrange(timeline.latest + 1))
            case 3:
                done = [one for one in done if one.tick <= timeline.tick]
                done.append(act(timeline, random))
    assert same(timeline.simulation, straight(timeline.tick, done))
    timeline.go_to(timeline.latest)
    assert same(timeline.simulation, straight(timeline.latest, done))


def test_back_one_step_and_on() -> None:
    timeline, plain = Timeline(fresh()), fresh()
    timeline.advance(120)
    for tick in range(119, 59, -1):
        timeline.go_to(tick)
        assert timeline.tick == tick
    plain.advance(60)
    assert same(timeline.simulation, plain)
    assert timeline.latest == 120


def test_what_happened_is_remembered_until_another_future_begins() -> None:
    timeline = Timeline(fresh())
    timeline.advance(3000)
    all_of_it = list(timeline.events)
    assert {"load", "unload"} <= {event.kind for event in all_of_it}
    timeline.go_to(1000)
    assert timeline.events == all_of_it
    assert all(event.tick < 1000 for event in timeline.events_until(1000))
    timeline.go_to(2000)
    timeline.advance(1500)
    assert timeline.events[: len(all_of_it)] == all_of_it
    timeline.go_to(1000)
    timeline.force("loader", "Presence", 0)
    assert timeline.latest == 1000
    assert timeline.events[:-1] == [event for event in all_of_it if event.tick < 1000]
    said = timeline.events[-1]
    assert (said.tick, said.kind, said.agent, said.cause) == (1000, "outside", "loader", "person")
    assert said.text == "Carrier held by hand: not there"
    timeline.set_variable("carrier-2", "Dock", 3)
    timeline.force("loader", "Presence", None)
    assert [event.text for event in timeline.events[-3:]] == [
        said.text,
        "Dock set by hand: 3",
        "Carrier no longer held",
    ]
    timeline.advance(10)
    timeline.go_to(999)
    timeline.force("loader", "Presence", 0)
    assert [event.tick for event in timeline.events if event.kind == "outside"] == [999]


def test_a_run_that_has_ended_can_be_gone_back_in() -> None:
    timeline = Timeline(TRANSPORT.simulation(seed=1))
    timeline.advance(100_000)
    assert said(timeline) == "done"
    end = timeline.simulation.agents, timeline.simulation.stock, timeline.tick
    timeline.go_to(timeline.latest - 1)
    assert said(timeline) is None
    timeline.advance(10)
    assert said(timeline) == "done"
    assert (timeline.simulation.agents, timeline.simulation.stock, timeline.tick) == end


def test_a_run_that_was_stuck_and_freed_by_hand_is_the_same_when_it_is_gone_through_again() -> None:
    mini = catalogue().robots["mini-robot"]

    def waiting() -> Simulation:
        return run_of({"a": (mini, "<Button.IsPressed()>(); WAIT(5);")}, empty_world(a=(1000, 1000, 0)))

    timeline = Timeline(waiting())
    timeline.advance(10_000)
    assert said(timeline) == "stuck"
    stuck = timeline.tick
    timeline.force("a", "Button", 1)
    timeline.advance(10_000)
    assert said(timeline) == "done"
    end = timeline.tick
    for tick in (0, stuck - 1, stuck):
        timeline.go_to(tick)
        assert said(timeline) is None
        timeline.advance(10_000)
        assert (said(timeline), timeline.tick) == ("done", end)
    twin = waiting()
    assert sum(1 for _ in timeline.done_again(twin)) == end + 1
    assert (twin.outcome, twin.tick) == ("done", end)


def test_going_out_of_the_run_goes_to_its_ends() -> None:
    timeline = Timeline(fresh())
    timeline.advance(50)
    timeline.go_to(-7)
    assert timeline.tick == 0
    timeline.go_to(10**9)
    assert timeline.tick == 50


def test_the_room_for_kept_states_is_bounded() -> None:
    room = 400_000
    timeline = Timeline(fresh(), room_bytes=room)
    timeline.advance(3000)
    assert sum(len(state) for state in timeline._states) <= room + len(timeline._states[0])
    assert len(timeline._states) > 3


def test_the_way_to_a_step_can_be_stopped() -> None:
    timeline = Timeline(fresh(), room_bytes=1)
    timeline.advance(2000)
    way = timeline.walk_to(1500)
    next(way)
    assert timeline.tick <= PIECE
    walk(timeline.walk_back_to(lambda: timeline.tick == 40))
    assert timeline.tick == 40


@pytest.mark.parametrize(("agent", "name"), [("nobody", "Sign"), ("carrier-1", "Nothing")])
def test_what_cannot_be_done_changes_nothing(agent: str, name: str) -> None:
    timeline = Timeline(fresh())
    timeline.advance(100)
    timeline.go_to(50)
    with pytest.raises(KitRobotError):
        timeline.force(agent, name, 1)
    with pytest.raises(KitRobotError):
        timeline.set_variable(agent, name, 1)
    assert (timeline.latest, timeline.interventions) == (100, [])


def test_what_somebody_did_names_a_sensor_as_the_page_does_in_the_readers_language() -> None:
    timeline = Timeline(fresh())
    timeline.force("loader", "Presence", 1)
    assert translate_to(timeline.events[-1].text, "fr") == "Porteur maintenu à la main : là"
