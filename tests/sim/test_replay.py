"""A run and its recording are the same: whatever was done to the run, and however it was recorded."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kitrobot
from kitrobot.sim.recorder import Recorder, record_again, simulate
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.timeline import Timeline
from kitrobot.trace.reader import TraceReader
from tests.effort import cases
from tests.sim.teams import random_team

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TRANSPORT = kitrobot.open(EXAMPLES / "transport" / "transport.krt")


def fresh() -> Simulation:
    return TRANSPORT.simulation(seed=3)


def act(timeline: Timeline, random: Random) -> None:
    """Something that a person does to the run."""
    match random.randrange(3):
        case 0:
            timeline.force("carrier-1", "Collision", random.choice([None, 0, 1]))
        case 1:
            timeline.set_variable("carrier-2", "Dock", random.randrange(6))
        case _:
            timeline.inject_fault(
                random.choice(["carrier-3", "loader"]), random.choice(["fail", "stall", "mute", "revive"])
            )


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**32))
def test_a_run_with_all_that_was_done_to_it_is_recorded_once_more_to_the_byte(
    tmp_path_factory: pytest.TempPathFactory, seed: int
) -> None:
    folder, random = tmp_path_factory.mktemp("again"), Random(seed)
    timeline = Timeline(fresh())
    for _ in range(random.randrange(1, 8)):
        match random.randrange(4):
            case 0 | 1:
                timeline.advance(random.randrange(1, 80))
            case 2:
                timeline.go_to(random.randrange(timeline.latest + 1))
            case _:
                act(timeline, random)
    record_again(timeline, fresh(), folder / "a.krtrace")
    stood = timeline.tick
    record_again(timeline, fresh(), folder / "b.krtrace")
    assert (folder / "a.krtrace").read_bytes() == (folder / "b.krtrace").read_bytes()
    assert timeline.tick == stood, "recording leaves the run alone"
    recorder = Recorder(timeline.simulation)
    with TraceReader(folder / "a.krtrace") as reader:
        assert reader.last_tick == timeline.latest
        for record in reader:
            timeline.go_to(record.tick)
            assert recorder.record().numbers == record.numbers, record.tick
            assert recorder.record().active == record.active
        told = {(event.tick, event.kind, event.text) for _, event in reader.events}
    assert {(event.tick, event.kind, event.text) for event in timeline.events} <= told


def test_what_somebody_did_stands_in_the_recording_as_an_event(tmp_path: Path) -> None:
    timeline = Timeline(fresh())
    timeline.set_variable("carrier-1", "Dock", 2)
    timeline.advance(50)
    timeline.force("loader", "Presence", 0)
    timeline.advance(10)
    timeline.force("loader", "Presence", None)
    timeline.inject_fault("carrier-3", "fail")
    record_again(timeline, fresh(), tmp_path / "a.krtrace")
    with TraceReader(tmp_path / "a.krtrace") as reader:
        by_hand = [(tick, event) for tick, event in reader.events if event.cause == "person"]
        names = [agent.name for agent in reader.header.agents]
        values = [reader.seek(tick).values(reader.header) for tick in (0, 49, 50, 60)]
    assert [(tick, event.tick, names[event.agent], event.text) for tick, event in by_hand] == [
        (0, 0, "carrier-1", "Dock set by hand: 2"),
        (50, 50, "loader", "Carrier held by hand: not there"),
        (60, 60, "loader", "Carrier no longer held"),
        (60, 60, "carrier-3", "fails (by hand)"),
    ]
    assert values[0]["carrier-1"]["variable Dock"] == 2
    assert [bool(one["loader"]["forced"]) for one in values] == [False, False, True, False]


def test_a_run_nobody_touched_is_recorded_alike_at_once_and_once_more(tmp_path: Path) -> None:
    timeline = Timeline(TRANSPORT.simulation(seed=1))
    timeline.advance(100_000)
    assert timeline.simulation.outcome == "done"
    record_again(timeline, TRANSPORT.simulation(seed=1), tmp_path / "a.krtrace")
    simulate(TRANSPORT.simulation(seed=1), tmp_path / "b.krtrace")
    assert (tmp_path / "a.krtrace").read_bytes() == (tmp_path / "b.krtrace").read_bytes()


@pytest.mark.usefixtures("with_numba")
@pytest.mark.parametrize("seed", cases([1], [2, 3]))
def test_the_recording_of_a_random_team_is_the_same_plain_and_compiled(seed: int, tmp_path: Path) -> None:
    plain, compiled = random_team(seed, 6), random_team(seed, 6)
    plain.stays_plain = True
    assert compiled.compile_step()
    for name, run in (("a", plain), ("b", compiled)):
        simulate(run, tmp_path / f"{name}.krtrace", lambda now: now.tick >= 250)
    assert (tmp_path / "a.krtrace").read_bytes() == (tmp_path / "b.krtrace").read_bytes()


def test_a_recording_can_be_broken_off(tmp_path: Path) -> None:
    timeline = Timeline(fresh())
    timeline.advance(500)
    asked = iter(range(1000))
    record_again(timeline, fresh(), tmp_path / "a.krtrace", stop=lambda: next(asked) >= 20)
    with TraceReader(tmp_path / "a.krtrace") as reader:
        assert (reader.last_tick, reader.outcome["outcome"]) == (20, "stopped")
