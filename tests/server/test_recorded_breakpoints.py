"""A recording pauses at breakpoints where its run would have, as far as the records show who came where."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import kitrobot
from kitrobot.live.watched_recording import ReplayError, WatchedRecording
from kitrobot.live.watched_simulation import WatchedSimulation
from kitrobot.mission.trial import Breakpoint
from kitrobot.sim.breakpoints import ConditionError, Hit
from kitrobot.sim.recorder import simulate
from kitrobot.trace.source import walk
from kitrobot.workspace import recorded_agents
from kitrobot.workspace.traces import open_trace
from tests.effort import THOROUGH

# The fixtures are those of test_run.
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TRANSPORT = kitrobot.open(EXAMPLES / "transport" / "transport.krt")
CARRIER = TRANSPORT.program("carrier")
ELEMENTS = Counter(one.element for one in CARRIER.vertices)
Hits = list[tuple[int, Hit]]


@pytest.fixture(scope="module")
def recording(tmp_path_factory) -> Path:
    path: Path = tmp_path_factory.mktemp("recorded") / "transport.krtrace"
    simulate(TRANSPORT.simulation(seed=1), path)
    return path


@pytest.fixture
def replay(recording):
    replay = WatchedRecording(open_trace(recording), TRANSPORT)
    yield replay
    replay.close()


def vertex(element: str, number: int = 0) -> str:
    return [one.id for one in CARRIER.vertices if one.element == element][number]


def hits_of(one: WatchedSimulation | WatchedRecording, *breakpoints: Breakpoint) -> Hits:
    """Every pause on the way to the end, from the first tick."""
    walk(one.seek(0))
    one.pause_at(breakpoints)
    found: Hits = []
    while one.outcome is None:
        one.advance(None, 1e9, lambda: 0.0)
        found += [(one.tick, hit) for hit in one.hits]
    return found


@cache
def live(*breakpoints: Breakpoint) -> Hits:
    return hits_of(WatchedSimulation(TRANSPORT.prepare()), *breakpoints)


WAITS = [one.id for one in CARRIER.vertices if one.element in ("When", "While")]
ONCE = [one.id for one in CARRIER.vertices if "." in one.element and ELEMENTS[one.element] == 1]
"""Where robots wait, and commands that only one part can give."""


def test_it_pauses_where_robots_wait_and_at_commands_of_one_part_and_nowhere_that_the_run_did_not(replay):
    marks = [Breakpoint(program.name, one.id) for program in TRANSPORT.mission.programs for one in program.vertices]
    paused: set[str] = set()
    # A pause at one place changes nothing for another: all at once are as each alone, at a fraction of the work.
    for together in [[mark] for mark in marks] if THOROUGH else [marks]:
        mine, theirs = (
            {(tick, hit.program, hit.vertex, hit.agent) for tick, hit in hits}
            for hits in (hits_of(replay, *together), live(*together))
        )
        assert mine <= theirs
        paused |= {vertex for _, program, vertex, _ in mine if program == "carrier"}
    assert paused & {*WAITS}
    assert paused & {*ONCE}


@pytest.fixture(scope="module")
def place(recording) -> str:
    """A part of the carriers at which the recording pauses several times."""
    replay = WatchedRecording(open_trace(recording), TRANSPORT)
    found = next(one.id for one in CARRIER.vertices if len(hits_of(replay, Breakpoint("carrier", one.id))) > 5)
    replay.close()
    return found


def test_a_condition_is_tested_with_what_was_recorded(replay, place):
    mark = Breakpoint("carrier", place)
    for condition in ("Cargo.IsPressed()", "Sign.EqualTo(3)", "Cargo.IsReleased() & Run.IsTrue()"):
        wanted = replace(mark, when=condition)
        mine = hits_of(replay, wanted)
        everywhere = {tick for tick, _ in live(wanted)}
        assert {tick for tick, _ in mine} <= everywhere
        assert len(mine) < len(hits_of(replay, mark))


def test_visits_are_counted_and_agents_chosen(replay, place):
    mark = Breakpoint("carrier", place)
    one = [(tick, hit) for tick, hit in hits_of(replay, mark) if hit.agent == "carrier-2"]
    assert [hit.visit for _, hit in one] == list(range(1, len(one) + 1))
    assert hits_of(replay, replace(mark, agents=("carrier-2",), hits=2)) == one[1:]


def test_after_going_back_it_pauses_at_the_same_places_again(replay, place):
    mark = Breakpoint("carrier", place)
    assert hits_of(replay, mark) == hits_of(replay, mark)


def test_a_step_ends_at_a_breakpoint(replay, place):
    first = hits_of(replay, Breakpoint("carrier", place))[0]
    walk(replay.seek(0))
    walk(replay.step("nobody"))
    assert (replay.tick, replay.hits[0]) == first


def test_a_breakpoint_that_is_off_or_leads_nowhere_does_nothing(replay):
    marks = [
        Breakpoint("carrier", vertex("While"), enabled=False),
        Breakpoint("carrier", "v999"),
        Breakpoint("x", "v1"),
    ]
    assert hits_of(replay, *marks) == []


def test_a_condition_that_cannot_be_understood_is_refused(replay):
    with pytest.raises(ConditionError):
        replay.pause_at([Breakpoint("carrier", vertex("While"), when="Sign.")])


def test_it_pauses_in_programs_that_stand_in_a_team_s(tmp_path):
    team = kitrobot.open(EXAMPLES / "transport-team" / "transport-team.krt")
    marks = [Breakpoint(name, one.id) for name in ("carry", "load") for one in team.program(name).vertices]
    run, path = WatchedSimulation(team.prepare()), tmp_path / "team.krtrace"
    run.pause_at(marks)
    theirs: Hits = []
    while run.tick < 1500:
        run.advance(1500 - run.tick, 1e9, lambda: 0.0)
        theirs += [(run.tick, hit) for hit in run.hits]
    run.record_to(path)
    replay = WatchedRecording(open_trace(path), team)
    mine = hits_of(replay, *marks)
    replay.close()
    places = {(tick, hit.program, hit.vertex, hit.agent) for tick, hit in mine}
    assert {program for _, program, _, _ in places} == {"carry", "load"}
    assert places <= {(tick, hit.program, hit.vertex, hit.agent) for tick, hit in theirs}
    commands = {one.id for one in team.program("load").vertices if one.element == "Arm.Load"}
    assert commands <= {vertex for _, _, vertex, _ in places}, "a command of one part only is known to have been given"


def test_without_its_robot_a_condition_is_said_not_to_be_tested_and_the_place_still_pauses(recording, replay, place):
    mark = Breakpoint("carrier", place, when="Cargo.IsPressed()")
    header = open_trace(recording).reader.header
    assert recorded_agents.select_testable([mark], header, {}, ()) == ([replace(mark, when="")], False)
    assert recorded_agents.select_testable([replace(mark, enabled=False)], header, {}, ())[1]
    robots = {**TRANSPORT.catalogue.robots, "carrier": TRANSPORT.catalogue.robot("mini-robot")}
    changed = WatchedRecording(
        open_trace(recording), replace(TRANSPORT, catalogue=replace(TRANSPORT.catalogue, robots=robots))
    )
    with pytest.raises(ReplayError, match="cannot be tested in this recording"):
        changed.pause_at([mark])
    changed.advance(None, 1e9, lambda: 0.0)
    assert changed.hits
    changed.close()


def test_over_the_socket_a_recording_pauses_and_goes_on(connect, page, recording, place):
    opened = page.post("/api/trace", content=recording.read_bytes()).json()
    with connect() as watcher:
        replay = WatchedRecording(open_trace(recording), TRANSPORT)
        # At full speed it may be over before another request comes: the breakpoints come with this one.
        marks = [{"program": "carrier", "vertex": place}]
        watcher.send(type="replay", recording=opened["recording"], speed=0, breakpoints=marks)
        hits = hits_of(replay, Breakpoint("carrier", place))
        for tick in sorted({tick for tick, _ in hits})[:3]:
            said = watcher.until("state", status="paused", tick=tick)
            assert [one["agent"] for one in said["hits"]] == [hit.agent for at, hit in hits if at == tick]
            watcher.send(type="resume")
        replay.close()
