"""Recordings of real robots, from what robots tell: what stands in them, and that they are whole whatever happens."""

from __future__ import annotations

import resource
import sys
from functools import partial
from pathlib import Path

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.boards.sent_programs import load_recording_context, store_names, store_recording_context
from kitrobot.deploy.line.news import Fault, News, Text
from kitrobot.robots.recording import MOST_FILLED, RobotRecorder
from kitrobot.robots.records import NoRecordingError, RecordedBoard
from kitrobot.robots.session import InstalledProgram, RobotSession
from kitrobot.robots.state import Activity
from kitrobot.trace.model import PERSON, PROGRAM, ROBOT, TraceError
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.replay import state_at, summary_of
from kitrobot.workspace.traces import open_trace
from tests.boards.host import write_pulse
from tests.robots.twin import Clock, Twin

BUTTON, COUNT, RUN = 1, 2, 3


class Recorded:
    """Robots in sessions that are recorded; each is greeted when it is `found`."""

    def __init__(self, path: Path, boards: list[RecordedBoard], clock: Clock) -> None:
        self.recorder = RobotRecorder(path, boards, clock)
        self.known = [InstalledProgram(one.names, one.recording_context) for one in boards]
        self.sessions = [RobotSession(clock) for _ in boards]
        self.twins = [Twin() for _ in boards]
        for number, session in enumerate(self.sessions):
            session.subscribe(partial(self.recorder.robot_changed, number))

    def found(self, doing: Activity = "running", tick: int = 0, number: int = 0) -> RobotSession:
        self.twins[number].stands(doing, tick)
        self.sessions[number].open(self.twins[number], self.twins[number].hello, self.known[number])
        return self.sessions[number]

    def told(self, news: News | Fault | Text | None, number: int = 0) -> None:
        if isinstance(news, News):
            self.twins[number].stands("running", news.tick)
        elif isinstance(news, Fault):
            self.twins[number].stands("fault", news.tick)
        if news is not None:
            self.twins[number].waiting.append(news)
        self.sessions[number].poll(0)


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def pulse(tmp_path: Path):
    """Makes robots of that name with the program `pulse`."""
    program = load_board_program(write_pulse(tmp_path))
    assert program.recording_context is not None
    return lambda name: RecordedBoard(name, program.names, program.recording_context)


def instruction(board: RecordedBoard, vertex: str) -> int:
    return next(number for number, (found, _, _) in enumerate(board.names.places) if found == vertex)


def test_what_a_robot_tells_stands_at_the_moment_it_was_heard(tmp_path, clock, pulse) -> None:
    one = pulse("a")
    made = Recorded(tmp_path / "r.krtrace", [one], clock)
    clock.now += 0.125
    made.found("running", 7)
    image, wait = instruction(one, "v3"), instruction(one, "v5")
    made.told(News(8, {COUNT: 5, RUN: 1}, {0: wait}, frozenset((image, wait))))
    clock.now += 0.125
    made.told(News(13, {COUNT: 6, 200: 1}, {0: None}))
    made.recorder.close()
    with TraceReader(tmp_path / "r.krtrace") as reader:
        assert [record.tick for record in reader] == list(range(13))
        assert reader.header.real
        before, heard, after = (reader.seek(tick) for tick in (5, 6, 12))
        assert before.values(reader.header)["a"]["variable Count"] == 0
        values = heard.values(reader.header)["a"]
        assert (values["variable Count"], values["doing"], values["tick"]) == (5, 2, 8)
        assert heard.active == [((0, wait),)]
        # What was shown is a fixed number of the program, so it is known without being told.
        assert [(one.actuator, one.procedure, one.arguments) for one in heard.commands] == [("Display", "Image", (0,))]
        assert (after.active, after.commands) == ([()], [])
        assert not {column.name for column in reader.header.columns} & {"x_mm", "y_mm", "heading_rad"}


def test_what_people_did_and_what_went_wrong_are_events_with_cause_vertex_and_line(tmp_path, clock, pulse) -> None:
    one = pulse("a")
    made = Recorded(tmp_path / "r.krtrace", [one], clock)
    session = made.found("ready")
    at = instruction(one, "v3")
    fault = Fault(1, at, 40, "a0 OSError")
    for act in (
        lambda: session.start(),
        lambda: session.force("ButtonA", 1),
        lambda: session.set_variable("Count", 9),
        lambda: session.force("ButtonA", None),
        lambda: made.told(Text("hello\n")),
        lambda: made.told(fault),
        lambda: made.told(fault),
    ):
        clock.now += 1
        act()
    made.recorder.close()
    with open_trace(tmp_path / "r.krtrace").reader as reader:
        events = [(event.tick, event.kind, event.text, event.cause) for _, event in reader.events]
        line = one.names.line(at)
        assert events == [
            (50, "outside", "its program was started from here", PERSON),
            (100, "outside", "ButtonA held by hand: true", PERSON),
            (150, "outside", "Count set by hand: 9", PERSON),
            (200, "outside", "ButtonA no longer held", PERSON),
            (250, "message", "hello", PROGRAM),
            (
                300,
                "failure",
                f"fault 1: a driver failed (Display: OSError); at the vertex v3, line {line} of the code",
                ROBOT,
            ),
        ]
        assert reader.outcome["outcome"] == "failed"
        assert reader.outcome["sentence"].startswith("fault 1: a driver failed")
    trace = open_trace(tmp_path / "r.krtrace")
    with trace.reader:
        assert summary_of(trace)["real"]
        held = state_at(trace, 2)["agents"]["a"]
        assert (held["forced"], held["inputs"], held["x_mm"]) == (["ButtonA"], {"ButtonA": 1}, None)
        failed = state_at(trace, 6)["agents"]["a"]
        assert failed["state"] == "failed"
        assert [stands["vertex"] for stands in failed["vertices"]] == ["v3"]


def test_several_robots_share_one_clock_and_a_lost_one_is_silent(tmp_path, clock, pulse) -> None:
    one, two = pulse("a"), pulse("b")
    made = Recorded(tmp_path / "r.krtrace", [one, two], clock)
    wait = instruction(one, "v5")
    for number, board in enumerate((one, two)):
        made.found(number=number)
        made.told(News(1 + 50 * number, {COUNT: number + 1}, {0: instruction(board, "v5")}), number)
    clock.now += 1
    made.sessions[1].lose("the link is lost")
    clock.now += 1
    made.twins[0].stands("ended", 99)
    made.told(None)
    made.recorder.close()
    trace = open_trace(tmp_path / "r.krtrace")
    with trace.reader as reader:
        assert [agent.name for agent in reader.header.agents] == ["a", "b"]
        assert reader.seek(49).active == [((0, wait),), ((0, wait),)]
        assert reader.seek(50).active == [((0, wait),), ()]
        assert [(event.agent, event.kind, event.text) for _, event in reader.events] == [
            (1, "failure", "the link is lost"),
            (0, "end", "its program has ended"),
        ]
        found = state_at(trace, 1.5)["agents"]
        assert [found[name]["state"] for name in ("a", "b")] == ["running", "stalled"]
        assert reader.outcome["sentence"] == "b: the link is lost"


def test_what_is_saved_on_the_way_is_whole_and_the_recording_goes_on(tmp_path, clock, pulse) -> None:
    made = Recorded(tmp_path / "r.krtrace", [pulse("a")], clock)
    made.found()
    for second in range(1, 4):
        clock.now += 1
        made.told(News(50 * second, {COUNT: second}, {}))
        made.recorder.save(tmp_path / f"{second}.krtrace")
    made.recorder.close()
    made.recorder.save(tmp_path / "4.krtrace")
    for second, last in ((1, 50), (2, 100), (3, 150), (4, 151)):
        with open_trace(tmp_path / f"{second}.krtrace").reader as reader:
            assert (reader.last_tick, reader.cut) == (last, False)


def test_a_recording_that_nobody_closes_is_whole_but_for_some_seconds(tmp_path, clock, pulse) -> None:
    made = Recorded(tmp_path / "r.krtrace", [pulse("a")], clock)
    made.found()
    for path in ("at once", "later"):
        with open_trace(tmp_path / "r.krtrace").reader as reader:
            assert reader.cut
            assert reader.last_tick == {"at once": 0, "later": 299}[path]
        clock.now += 6
        made.told(None)


def test_a_long_silence_takes_its_time_and_no_room(tmp_path, clock, pulse) -> None:
    made = Recorded(tmp_path / "r.krtrace", [pulse("a")], clock)
    made.found()
    clock.now += 24 * 3600
    made.told(News(1, {COUNT: 3}, {}))
    made.recorder.close()
    assert (tmp_path / "r.krtrace").stat().st_size < 50_000
    with open_trace(tmp_path / "r.krtrace").reader as reader:
        assert reader.last_tick == 24 * 3600 * 50
        assert sum(1 for _ in reader) < MOST_FILLED + 10


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of a file's size there")
def test_where_the_disk_is_full_the_recording_ends_whole_and_says_so(tmp_path, clock, pulse) -> None:
    path = tmp_path / "r.krtrace"
    made = Recorded(path, [pulse("a")], clock)
    made.found()
    clock.now += 6
    made.told(News(1, {COUNT: 3}, {}))
    clock.now += 6
    made.told(None)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (path.stat().st_size + 20, limits[1]))
    try:
        for _ in range(3):
            clock.now += 6
            made.told(News(2, {COUNT: 4}, {}))
        made.recorder.close()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert made.recorder.error is not None
    assert "cannot be written" in made.recorder.error.message
    with open_trace(path).reader as reader:
        assert reader.cut
        assert sum(1 for _ in reader) == 600
        assert reader.seek(400).values(reader.header)["a"]["variable Count"] == 3


def test_a_place_that_cannot_be_written_is_refused_at_once(tmp_path, clock, pulse) -> None:
    with pytest.raises(TraceError, match="cannot be written"):
        RobotRecorder(tmp_path / "none" / "r.krtrace", [pulse("a")], clock)


def test_robots_of_different_missions_do_not_go_into_one_recording(tmp_path, clock, pulse) -> None:
    other = tmp_path / "other"
    other.mkdir()
    path = write_pulse(other)
    path.write_text(path.read_text().replace(">3<", ">4<"))
    program = load_board_program(path)
    assert program.recording_context is not None
    with pytest.raises(NoRecordingError, match="different missions"):
        RobotRecorder(
            tmp_path / "r.krtrace", [pulse("a"), RecordedBoard("b", program.names, program.recording_context)], clock
        )


def test_what_a_recording_carries_is_kept_and_found_again(tmp_path, monkeypatch) -> None:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    program = load_board_program(write_pulse(tmp_path))
    assert program.recording_context is not None
    store_names(program.names, ["0123abcd"])
    store_recording_context(program.recording_context, ["0123abcd"])
    assert load_recording_context("0123abcd") == program.recording_context
    assert [part.file for part in program.recording_context.parts] == ["pulser.robot.xml"]
    assert load_recording_context("0123abce") is None
    assert load_recording_context("../0123abcd") is None
    file = tmp_path / "state" / "boards" / "0123abcd.carried"
    for damage in ("", "[]", '{"mission": 1}', file.read_text()[:-40]):
        file.write_text(damage)
        assert load_recording_context("0123abcd") is None
    store_recording_context(None, ["0123abcd"])
    assert not file.exists()
