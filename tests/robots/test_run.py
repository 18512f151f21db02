"""Real robots as a run: steered and told to the page like a simulated one and a recording."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.deploy import Fault, News
from kitrobot.robots import Known, RecordedBoard, RobotSession, RobotsRun
from kitrobot.server.run_messages import RunEncoder
from kitrobot.trace import AbilityError, RunSource, TickRecord
from kitrobot.workspace import load_board_program
from tests.boards.host import write_pulse
from tests.robots.twin import Clock, Twin

COUNT = 2


class Run:
    """Robots called `a` and `b`, both running."""

    def __init__(self, folder: Path) -> None:
        program = load_board_program(write_pulse(folder))
        assert program.carried is not None
        self.names, self.clock = program.names, Clock()
        self.sessions = [RobotSession(self.clock) for _ in range(2)]
        self.twins = [Twin() for _ in range(2)]
        robots = [RecordedBoard(name, program.names, program.carried) for name in ("a", "b")]
        self.left: list[tuple[int, int]] = []
        self.run = RobotsRun(robots, self.sessions, self.clock, self._left)
        for session, twin in zip(self.sessions, self.twins, strict=True):
            session.open(twin, twin.hello, Known(program.names, program.carried))

    def _left(self, record: TickRecord, following: int) -> None:
        self.left.append((record.tick, following))

    def hears(self, number: int, news: News | Fault) -> None:
        self.twins[number].waiting.append(news)
        self.twins[number].stands("fault" if isinstance(news, Fault) else "running", news.tick)
        self.sessions[number].poll(0)


@pytest.fixture
def made(tmp_path: Path) -> Run:
    return Run(tmp_path)


def test_robots_are_a_source_that_can_be_forced_and_set_and_no_more(made: Run) -> None:
    source: RunSource = made.run
    assert source.abilities == {"force", "set"}
    source.force("b", "ButtonA", 1)
    source.set_variable("b", "Count", 7)
    assert made.twins[0].asked == []
    assert made.twins[1].asked == [("force", 1, 1), ("set", COUNT, 7)]
    assert [event.agent for event in source.events(10)] == [1, 1]
    for refused in (
        lambda: source.seek(0, bool),
        lambda: source.seek_back(bool, bool),
        lambda: source.fail("a", "fail"),
        lambda: source.force("c", "ButtonA", 1),
    ):
        with pytest.raises(AbilityError):
            refused()
    source.stop()
    assert made.twins[0].asked == ["stop"]
    assert (source.outcome, source.sentence) == ("stopped", "")


def test_it_goes_on_with_the_clock_and_what_happens_is_of_the_tick_of_now(made: Run) -> None:
    made.clock.now += 0.5
    assert made.run.advance(1) == 25
    made.hears(0, Fault(1, None, 3, ""))
    assert [event.tick for event in made.run.record().events] == [25]
    assert made.run.new_events(10) == (False, made.run.events(10))
    assert made.run.new_events(10) == (False, [])
    made.clock.now += 1
    assert made.run.advance(1) == 50
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
    told = encoder.news(made.run.record(), made.run.latest, *made.run.new_events(10))
    assert told["agents"]["b"]["active"] == [[0, "v5"]]
    assert told["agents"]["b"]["values"]["Count"] == 6
    assert (told["agents"]["b"]["inputs"], told["agents"]["b"]["forced"]) == ({"ButtonA": 1}, ["ButtonA"])
    assert [event["text"] for event in told["events"]] == ["the sensor ButtonA is held at 1"]
    assert told["agents"]["a"]["state"] == "running"
    again = encoder.news(made.run.record(), made.run.latest, *made.run.new_events(10))
    assert (again["agents"], again["events"]) == ({}, [])
