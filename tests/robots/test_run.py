"""Real robots as a run: steered and told to the page like a simulated one and a recording."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.line.news import Fault, News
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.run_encoder import RunEncoder
from kitrobot.robots.records import RecordedBoard
from kitrobot.robots.run import RobotsRun
from kitrobot.robots.session import InstalledProgram, RobotSession
from kitrobot.trace.model import TickRecord
from kitrobot.trace.source import AbilityError, RunSource, walk
from kitrobot.translation.reader_language import override_language, translate
from tests.boards.host import write_pulse
from tests.robots.twin import Clock, Twin

COUNT = 2


class Run:
    """Robots called `a` and `b`, both running."""

    def __init__(self, folder: Path) -> None:
        program = load_board_program(write_pulse(folder))
        assert program.recording_context is not None
        self.names, self.clock = program.names, Clock()
        self.sessions = [RobotSession(self.clock) for _ in range(2)]
        self.twins = [Twin() for _ in range(2)]
        robots = [RecordedBoard(name, program.names, program.recording_context) for name in ("a", "b")]
        self.left: list[tuple[int, int]] = []
        self.run = RobotsRun(robots, self.sessions, self.clock, self._left)
        for session, twin in zip(self.sessions, self.twins, strict=True):
            session.open(twin, twin.hello, InstalledProgram(program.names, program.recording_context))

    def _left(self, record: TickRecord, following: int) -> None:
        self.left.append((record.tick, following))

    def hears(self, number: int, news: News | Fault) -> None:
        self.twins[number].waiting.append(news)
        self.twins[number].stands("fault" if isinstance(news, Fault) else "running", news.tick)
        self.sessions[number].poll(0)


@pytest.fixture
def made(tmp_path: Path) -> Run:
    return Run(tmp_path)


def test_robots_are_a_source_that_can_be_forced_and_set_but_not_made_to_fail(made: Run) -> None:
    source: RunSource = made.run
    assert source.abilities == {"force", "set", "seek", "step"}
    source.force("b", "ButtonA", 1)
    source.set_variable("b", "Count", 7)
    assert made.twins[0].asked == []
    assert made.twins[1].asked == [("force", 1, 1), ("set", COUNT, 7)]
    assert [event.agent for event in source.events(10)] == [1, 1]
    with override_language("fr"):
        told = [translate(event.text) for event in source.events(10)]
    assert told == ["ButtonA maintenu à la main : true", "Count réglé à la main : 7"]
    for refused in (
        lambda: source.fail("a", "fail"),
        lambda: source.force("c", "ButtonA", 1),
    ):
        with pytest.raises(AbilityError):
            refused()
    for unknown in (
        lambda: source.force("b", "Ear", 1),
        lambda: source.set_variable("b", "Sum", 1),
        lambda: source.set_variable("b", "Count", 2**29),
        lambda: source.force("b", "ButtonA", -(2**40)),
    ):
        with pytest.raises(KitRobotError):
            unknown()
    source.stop()
    assert made.twins[0].asked == ["stop"]
    assert (source.outcome, source.sentence) == ("stopped", "")


def test_it_goes_on_with_the_clock_and_what_happens_is_of_the_tick_of_now(made: Run) -> None:
    made.clock.now += 0.5
    assert made.run.advance(1) == 1
    assert (made.run.tick, made.run.latest) == (1, 25)
    assert made.run.advance(1000) == 24
    made.hears(0, Fault(1, None, 3, ""))
    assert [event.tick for event in made.run.record().events] == [25]
    assert made.run.new_events(10) == (False, made.run.events(10))
    assert made.run.new_events(10) == (False, [])
    made.clock.now += 1
    assert made.run.advance(50) == 50
    assert made.run.record().events == []
    assert made.left == [(0, 25), (25, 75)]
    assert made.run.sentence == ""
    made.sessions[1].stop()
    assert (made.run.outcome, made.run.sentence) == ("failed", "a: fault 1: a driver failed")


def test_the_page_is_told_of_them_as_of_every_run(made: Run) -> None:
    encoder = RunEncoder(made.run.header)
    wait = next(number for number, (vertex, _, _) in enumerate(made.names.places) if vertex == "v5")
    made.hears(1, News(4, {COUNT: 6}, {0: wait}))
    made.sessions[1].force("ButtonA", 1)
    told = encoder.encode_changes(made.run.record(), made.run.latest, *made.run.new_events(10))
    assert told["agents"]["b"]["active"] == [[0, "v5"]]
    assert told["agents"]["b"]["values"]["Count"] == 6
    assert (told["agents"]["b"]["inputs"], told["agents"]["b"]["forced"]) == ({"ButtonA": 1}, ["ButtonA"])
    assert [event["text"] for event in told["events"]] == ["ButtonA held by hand: true"]
    assert told["agents"]["a"]["state"] == "running"
    again = encoder.encode_changes(made.run.record(), made.run.latest, *made.run.new_events(10))
    assert (again["agents"], again["events"]) == ({}, [])


def counts(made: Run) -> float:
    """What the variable `Count` of `a` is where the run stands."""
    return int(made.run.record().values(made.run.header)["a"]["variable Count"])


def test_what_was_heard_is_kept_and_the_robots_go_on_meanwhile(made: Run) -> None:
    for number in range(1, 6):
        made.clock.now += 1
        made.hears(0, News(number, {COUNT: number}, {0: number % 2}))
    assert made.run.advance(1000) == 250
    assert counts(made) == 5
    walk(made.run.seek(120))
    assert (made.run.tick, made.run.latest, made.run.outcome, counts(made)) == (120, 250, None, 2)
    assert made.run.active() == (((0, 0),), ())
    made.clock.now += 1
    made.hears(0, News(6, {COUNT: 6}, {}))
    assert (made.run.tick, made.run.latest, counts(made)) == (120, 300, 2)
    assert made.run.advance(30) == 30
    assert counts(made) == 3
    before = made.run.active()
    walk(made.run.seek_back(lambda: made.run.active() != before))
    assert (made.run.tick, counts(made)) == (149, 2)
    walk(made.run.seek_back(bool))
    assert (made.run.tick, counts(made)) == (0, 0)
    walk(made.run.seek(10**9))
    assert (made.run.tick, counts(made)) == (300, 6)


def test_news_that_comes_at_once_is_of_ticks_of_its_own_and_no_place_is_lost(made: Run) -> None:
    made.hears(0, News(1, {COUNT: 1}, {0: 3}))
    assert made.run.advance(10) == 0
    for number in (2, 3):
        made.hears(0, News(number, {COUNT: number}, {0: 3 + number}))
        made.hears(1, News(number, {}, {0: number}))
    assert (made.run.tick, made.run.record().active[0], counts(made)) == (0, ((0, 3),), 1)
    assert [one.active for one in made.run.records()] == [
        [((0, 3),), ()],
        [((0, 5),), ((0, 2),)],
        [((0, 6),), ((0, 3),)],
    ]
    assert [made.run.advance(1) for _ in range(3)] == [1, 1, 0]
    made.clock.now += 1
    assert made.run.latest == 50, "the clock is the same"


def test_only_the_last_moments_are_kept(made: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kitrobot.robots.run.MOST_MOMENTS", 10)
    for number in range(1, 31):
        made.clock.now += 1
        made.hears(0, News(number, {COUNT: number}, {}))
    walk(made.run.seek(0))
    assert 1 <= 30 - counts(made) <= 11
    assert made.run.tick == 50 * counts(made)
    assert len(made.run.records()) <= 11


def test_it_begins_anew_when_a_robot_is_started_while_none_runs(made: Run) -> None:
    made.hears(0, News(1, {COUNT: 4}, {0: 0}))
    made.clock.now += 1
    made.sessions[0].start()
    assert made.run.latest == 50, "the other one still runs"
    for session in made.sessions:
        session.stop()
    made.clock.now += 60
    made.sessions[0].poll(0)
    assert (made.run.advance(10**6), made.run.latest, made.run.outcome) == (50, 50, "stopped")
    made.run.new_events(10)
    made.sessions[0].start()
    assert (made.run.tick, made.run.latest, made.run.outcome) == (0, 0, None)
    told = made.run.new_events(10)
    assert (told.again, [event.text for event in told.events]) == (True, ["its program was started from here"])


def test_a_lost_link_takes_its_time_and_another_program_is_none_of_the_run(made: Run) -> None:
    made.clock.now += 1
    made.sessions[1].stop()
    made.sessions[0].lose("the link is lost")
    assert made.run.advance(10**6) == 50
    assert (made.run.outcome, made.run.sentence) == ("failed", "a: the link is lost")
    made.clock.now += 1
    twin = Twin()
    made.sessions[0].open(twin, twin.hello, made.sessions[0].known)
    assert (made.run.latest, made.run.outcome) == (100, None)
    assert [event.text for event in made.run.events(10)][-2:] == ["the link is lost", "the link is back"]
    other = Twin(program="87654321")
    made.sessions[0].open(other, other.hello, None)
    made.run.advance(10**6)
    assert (made.run.outcome, made.run.record().active) == ("stopped", [(), ()])


def test_who_closes_it_hears_nothing_any_more(made: Run) -> None:
    made.run.close()
    made.sessions[0].lose("the link is lost")
    assert made.run.events(10) == []
