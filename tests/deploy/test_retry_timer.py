"""A robot that is slow is told from one that is silent, whatever is asked, and nothing is done twice."""

from __future__ import annotations

import itertools

import pytest

from kitrobot.deploy.errors import BoardError, SilentError
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import STARTS, greet
from kitrobot.deploy.line.news import News
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.line.retry_timer import LONGEST_S, SILENT_S, RetryTimer
from kitrobot_onboard.link import unwrap, wrap
from tests.deploy.fake_boards import Answers, FakeLine, FakePrompt, FakeRobot


def greeted(line: FakeLine) -> Board:
    board = Board(line)
    greet(board)
    return board


@pytest.mark.parametrize("takes_s", [0.001, 0.4, 0.9, 2.0, 5.0])
def test_a_robot_that_answers_late_is_greeted_and_does_once_what_it_is_asked(takes_s: float) -> None:
    robot = FakeRobot(takes_s)
    board = greeted(FakeLine(robot))
    assert board.hello.program == "12345678"
    robot.done.clear()
    board.start()
    board.set(1, 5)
    board.set(1, 6)
    assert board.last_fault() is None
    board.stop()
    assert [kind for kind in robot.done if kind not in "hlp"] == ["s", "v", "v", "x"]


def test_who_never_says_a_word_is_silent_after_some_seconds_and_the_person_is_told_meanwhile() -> None:
    line = FakeLine(lambda data: ())
    told: list[float] = []
    with pytest.raises(SilentError, match="does not answer"):
        greet(Board(line), waits=lambda: told.append(line.time))
    assert SILENT_S <= line.time < SILENT_S + 1
    assert len(told) == 1
    assert told[0] < 5


def test_a_robot_that_falls_silent_is_told() -> None:
    line = FakeLine(FakeRobot())
    board = greeted(line)
    line.board = lambda data: ()
    began = line.time
    with pytest.raises(SilentError):
        board.stop()
    assert line.time - began < SILENT_S + 1


def test_a_robot_that_tells_news_and_answers_late_is_waited_for_and_one_that_never_answers_is_not() -> None:
    robot = FakeRobot(0.01)

    def busy(data: bytes) -> Answers:
        yield 0.3, wrap("T", 0, bytes(4))
        yield from ((3 * SILENT_S, answer) for _, answer in robot(data))

    line = FakeLine(robot)
    board = greeted(line)
    line.board = busy
    board.set(1, 7)
    assert robot.done.count("v") == 1
    assert isinstance(board.news(0), News)
    line.board = lambda data: [(0.3, wrap("T", 0, bytes(4)))]
    began = line.time
    with pytest.raises(SilentError):
        board.stop()
    assert line.time - began < LONGEST_S + 1


def test_a_line_that_gives_back_what_is_said_is_no_robot() -> None:
    line = FakeLine(lambda data: [(0.01, data)])
    with pytest.raises(SilentError):
        greet(Board(line))


def test_an_answer_that_was_on_its_way_since_long_before_stops_no_robot() -> None:
    robot = FakeRobot()
    first = True

    def late(data: bytes) -> Answers:
        nonlocal first
        if first and data.startswith(b"~h"):
            first = False
            yield 0.0, wrap("K", board._number, b"")
        yield from robot(data)

    line = FakeLine(late)
    board = Board(line)
    greet(board)
    assert b"\x03" not in line.said


def test_who_takes_files_since_a_deploy_broke_off_is_ended() -> None:
    started = FakePrompt(FakeRobot())
    ended = False

    def receiver(data: bytes) -> Answers:
        nonlocal ended
        if ended:
            return started(data)
        ended = b"\x03\x03" in data
        return [(delay, wrap("K", answer_number(answer), b"")) for delay, answer in FakeRobot()(data)]

    def answer_number(answer: bytes) -> int:
        found = unwrap(answer.strip(b"~"))
        assert found is not None
        return found[1]

    assert greeted(FakeLine(receiver)).hello.program == "12345678"


@pytest.mark.parametrize("starts_s", [0.1, 3.0, 25.0])
def test_at_the_prompt_the_program_is_started_and_waited_for(starts_s: float) -> None:
    assert greeted(FakeLine(FakePrompt(FakeRobot(), starts_s))).hello.free == 5000


def test_a_greeting_of_any_number_harms_no_prompt(monkeypatch: pytest.MonkeyPatch) -> None:
    for first in range(1, 256):
        monkeypatch.setattr("random.randrange", lambda *bounds, first=first: first)
        assert greeted(FakeLine(FakePrompt(FakeRobot()))).hello.free == 5000, first


def test_a_prompt_without_a_program_of_ours_is_known_at_once() -> None:
    line = FakeLine(FakePrompt())
    with pytest.raises(SilentError) as error:
        greet(Board(line))
    assert "reboot" in error.value.printed
    assert line.time < 3


def test_a_board_that_was_left_in_raw_paste_mode_is_started() -> None:
    assert greeted(FakeLine(FakePrompt(FakeRobot(), pasting=True))).hello.free == 5000


def test_a_program_of_ones_own_that_is_silent_or_prints_is_never_broken_off() -> None:
    for board in (lambda data: (), lambda data: [(0.01, b"3.7 degrees\r\n")], lambda data: [(0.01, b"\x01\x02")]):
        line = FakeLine(board)
        with pytest.raises(SilentError):
            greet(Board(line))
        outside = b"".join(piece for piece in line.said.split(b"~") if unwrap(piece) is None)
        assert b"\r\x02" in outside
        assert b"\x03" not in outside
        assert b"\x04" not in outside


@pytest.mark.parametrize("starts_s", [1.0, 20.0, 100.0])
def test_a_deployed_program_is_waited_for_as_the_board_is_slow(starts_s: float) -> None:
    line = FakeLine(FakePrompt(FakeRobot(), starts_s))
    assert greet(Board(line), 120, sequence=STARTS, starting_s=120).program == "12345678"


@pytest.mark.parametrize("takes_s", [0.01, 2.0])
def test_a_held_robot_hears_from_us_often_enough_however_late_it_answers(takes_s: float) -> None:
    robot = FakeRobot(takes_s)
    heard: list[float] = []

    def held(data: bytes) -> Answers:
        heard.append(line.time)
        return robot(data)

    line = FakeLine(held)
    board = greeted(line)
    heard.clear()
    board.start(held=True)
    while line.time < 60:
        board.news(1)
    assert max(later - earlier for earlier, later in itertools.pairwise(heard)) < 0.8
    assert robot.done.count("s") == 1


def test_a_start_that_is_refused_holds_nothing() -> None:
    line = FakeLine(FakeRobot(answers={"s": ("N", b"\x01")}))
    board = greeted(line)
    with pytest.raises(BoardError):
        board.start(held=True)
    said = len(line.said)
    board.news(5)
    assert len(line.said) == said


@pytest.mark.parametrize("takes_s", [0.05, 1.0, 4.0])
def test_the_raw_repl_is_entered_however_late_it_answers(takes_s: float) -> None:
    def board(data: bytes) -> Answers:
        if data == b"\r\x01":
            yield takes_s, b"raw REPL; CTRL-B to exit\r\n>"
        elif data == b"\x04":
            yield takes_s, b"OK\r\nMPY: soft reboot\r\nraw REPL; CTRL-B to exit\r\n>"
        elif data.endswith(b"\x04"):
            yield takes_s, b"OK" + data[:-1] + b"\x04\x04>"

    line = FakeLine(board)
    repl = RawRepl(line)
    repl.enter()
    assert repl.pace_s >= takes_s
    assert [repl.run(command) for command in ("a", "b", "c")] == ["a", "b", "c"]


@pytest.mark.parametrize("words", [b"", b"MicroPython v1.9.2\r\n"])
def test_a_board_that_hangs_is_called_until_somebody_has_pressed_its_button(words: bytes) -> None:
    """It hears for 0.3 s, 20 s after the person was asked; `words`: what it says when it is switched on."""
    pressed: list[float] = []
    is_free = False

    def board(data: bytes) -> Answers:
        nonlocal is_free
        since = line.time - pressed[0] if pressed else -1.0
        if line.time < 0.01 or 20.0 <= since < 20.1:
            yield 0.001, words
        is_free = is_free or (20.2 <= since < 20.5 and b"\x03" in data)
        if is_free and data.endswith(b"\x01"):
            yield 0.01, b"raw REPL; CTRL-B to exit\r\n>"
        elif is_free and data == b"\x04":
            yield 0.01, b"OK\r\nMPY: soft reboot\r\nraw REPL; CTRL-B to exit\r\n>"

    line = FakeLine(board)
    repl = RawRepl(line, lambda: pressed.append(line.time))
    repl.enter()
    assert repl.answered
    assert len(pressed) == 1


def test_a_board_whose_button_nobody_presses_is_silent() -> None:
    line = FakeLine(lambda data: ())
    with pytest.raises(SilentError, match="no MicroPython answers"):
        RawRepl(line).enter()
    assert 30.0 < line.time < 40.0


def test_patience_grows_and_begins_anew_with_each_sign_of_life() -> None:
    time = 0.0
    patience = RetryTimer(lambda: time, 1.0, 10.0, 60.0, 4.0)
    assert [patience.wait() for _ in range(4)] == [1.0, 2.0, 4.0, 4.0]
    time = 9.0
    assert patience.wait() == 1.0
    patience.heard()
    time = 18.0
    assert patience.left() == 1.0
    for time in range(18, 60):  # noqa: B007 - the clock
        patience.heard()
    time = 60.0
    assert patience.wait() == 0.0
