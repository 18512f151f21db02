"""A broken or hostile board: whatever it answers, who asks gets a sentence, in bounded time, and keeps little."""

from __future__ import annotations

import contextlib
import tracemalloc
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.deploy.errors import ResetError
from kitrobot.deploy.installation.boot_records import read_line
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import greet
from kitrobot.deploy.line.line import MOST, Line
from kitrobot.deploy.line.raw_paste import run_by_raw_paste
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import GarbledError, RawRepl
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.diagnostics.model import KitRobotError
from kitrobot_onboard.link import unwrap, wrap
from tests.deploy.fake_boards import Answers, FakeLine, FakeRobot

NEVER_LONGER_S = 150
FOR_EVER_S = 240
"""Who talks for ever is given up by then; many steps, each of them given up, are behind the longest of it."""
FRAMES = st.tuples(
    st.sampled_from("DDDEKNHCFTxd"),
    st.one_of(
        st.binary(max_size=80),
        st.sampled_from([b"", b"0", b"12 34", b"-1 -1", b"9" * 5000, b" ", b"\xff" * 4000, b"1 2 3", b"nan nan"]),
        st.binary(min_size=15, max_size=15).map(lambda end: b"\x01" + end),
    ),
    st.sampled_from([None, None, None, 0, 7]),
)
"""Kind, payload, number: None that of the request."""

RAW = st.one_of(st.binary(max_size=60), st.sampled_from([b"~", b">>> ", b"}" * 50, b"x" * 3000, b"raw REPL"]))


def board_of(choices: list[tuple[str, bytes, int | None] | bytes]) -> Callable[[bytes], Answers]:
    """It gives these in turn, for ever, whatever it is asked."""
    turn = 0

    def answers(data: bytes) -> Answers:
        nonlocal turn
        for piece in data.split(b"~"):
            found = unwrap(piece)
            if found is None:
                continue
            choice = choices[turn % len(choices)]
            turn += 1
            if isinstance(choice, bytes):
                yield 0.01, choice
            else:
                kind, payload, number = choice
                yield 0.01, wrap(kind, found[1] if number is None else number, payload)

    return answers


def in_touch(line: Line) -> Receiver:
    """A receiver that need not be defined first."""
    receiver = Receiver(RawRepl(line))
    receiver.family = "microbit"
    return receiver


FILES: dict[str, Callable[[Receiver], Any]] = {
    "value": lambda board: board.value("1"),
    "names": lambda board: board.names(),
    "sum_of": lambda board: board.sum_of("a"),
    "read": lambda board: board.read("a"),
    "write": lambda board: board.write("a", bytes(100)),
    "remove": lambda board: board.remove("a"),
    "write_words": lambda board: board.write_words(0, bytes(100)),
    "number": lambda board: board.number("1"),
    "flash": lambda board: Flash.of(board),
    "end": lambda board: board.end(),
}
ROBOT: dict[str, Callable[[Board], Any]] = {
    "greet": lambda board: board.greet(),
    "start": lambda board: board.start(True),
    "stop": lambda board: board.stop(),
    "step": lambda board: board.step(dict.fromkeys(range(1, 20), 5)),
    "force": lambda board: board.force(1, None),
    "set": lambda board: board.set(1, -5),
    "watch": lambda board: board.watch(50),
    "identify": lambda board: board.identify(),
    "last_fault": lambda board: board.last_fault(),
    "news": lambda board: board.news(1),
    "quit": lambda board: board.quit(),
}


@pytest.mark.parametrize("asked", FILES)
@given(choices=st.lists(st.one_of(FRAMES, RAW), min_size=1, max_size=6))
def test_what_takes_files_may_answer_anything(asked: str, choices: list[Any]) -> None:
    line = FakeLine(board_of(choices))
    with contextlib.suppress(KitRobotError):
        FILES[asked](in_touch(line))
    assert line.read_bytes < 4 * MOST


@pytest.mark.parametrize("asked", ROBOT)
@given(choices=st.lists(st.one_of(FRAMES, RAW), min_size=1, max_size=6))
def test_a_robot_may_answer_anything(asked: str, choices: list[Any]) -> None:
    line = FakeLine(FakeRobot())
    board = Board(line)
    greet(board)
    board.arguments = [0, 1, 2, 200]
    line.board = board_of(choices)
    began = line.time
    with contextlib.suppress(KitRobotError):
        ROBOT[asked](board)
    assert line.time - began < 3 * NEVER_LONGER_S


@given(choices=st.lists(st.one_of(FRAMES, RAW), min_size=1, max_size=6))
def test_a_greeting_may_be_answered_by_anything(choices: list[Any]) -> None:
    line = FakeLine(board_of(choices))
    try:
        hello = greet(Board(line))
    except KitRobotError:
        pass
    else:
        assert hello.state_name
    assert line.time < NEVER_LONGER_S


@given(st.one_of(st.binary(max_size=80), st.just(b"9" * 5000 + b" a b 0000 0000"), st.just(b"1 a b 0000 0000\n")))
def test_a_line_that_says_what_starts_may_be_anything(data: bytes) -> None:
    assert read_line(data) is None


@pytest.mark.parametrize("asked", ["read", "names"])
def test_a_file_or_a_list_that_never_ends_is_given_up(asked: str) -> None:
    line = FakeLine(board_of([("D", b"x" * (64 if asked == "read" else 400), None)]))
    tracemalloc.start()
    try:
        with pytest.raises(KitRobotError):
            FILES[asked](in_touch(line))
        assert tracemalloc.get_traced_memory()[1] < 20 * MOST
    finally:
        tracemalloc.stop()
    assert line.read_bytes < 2 * MOST


class Flood(FakeLine):
    """As many bytes as are wanted, as fast as a network gives them."""

    def read(self, timeout_s: float) -> bytes:
        self.time += 1e-6
        self.read_bytes += 4096
        return b"\xaa" * 4096


def test_a_flood_without_an_end_is_listened_to_within_bounds() -> None:
    line = Flood(lambda data: ())
    assert len(line.read_until(b"never", 1000)) <= MOST + 4096
    assert len(line.drain(1, 1000)) <= MOST + 4096


@pytest.mark.parametrize(("kind", "answer"), [("x", "K"), ("x", "N"), ("x", "H"), ("d", "N"), ("d", "D")])
def test_an_answer_of_a_robot_that_runs_means_that_the_board_restarted(kind: str, answer: str) -> None:
    receiver = in_touch(FakeLine(board_of([(answer, b"", None)])))
    with pytest.raises(ResetError):
        receiver._asked(kind, b"1", 2)


def test_a_prompt_means_that_the_board_restarted_and_is_noticed_at_once() -> None:
    line = FakeLine(lambda data: [(0.01, b"\r\nMicroPython v1.22\r\n>>> ")])
    with pytest.raises(ResetError):
        in_touch(line).names()
    assert line.time < 1


class Talker(FakeLine):
    """One that says the same for ever, a moment after the other."""

    def __init__(self, words: bytes) -> None:
        super().__init__(lambda data: ())
        self.words = words

    def read(self, timeout_s: float) -> bytes:
        self.time += 0.003
        assert self.time < FOR_EVER_S, f"still listening to {self.words!r}"
        return self.words

    def waiting(self) -> int:
        return len(self.words)


WAITING: dict[str, Callable[[Line], object]] = {
    "greet": lambda line: greet(Board(line)),
    "ask": lambda line: Board(line).greet(),
    "enter": lambda line: RawRepl(line).enter(),
    "begin": lambda line: Receiver(RawRepl(line)).begin(),
    "value": lambda line: Receiver(RawRepl(line)).value("1"),
    "tell": lambda line: run_by_raw_paste(line, "s=1"),
    "release": lambda line: RawRepl(line).release(),
}
BANNER = b"raw REPL; CTRL-B to exit\r\n>"


FOR_EVER = [
    *(
        b"x",
        b">>> ",
        b"\r\n>>> ",
        BANNER,
        b"\x01",
        b"OK\x04\x04>",
        b"~~~",
        b"\x04>",
        b"reboot " + BANNER + b"OK1\x04\x04>",
    ),
    *(wrap("K", 0, b""), wrap("H", 7, b"\1"), wrap("T", 0, b"aaaa"), wrap("K", 0, b"") + b"reboot " + BANNER),
]


@pytest.mark.parametrize("wait", WAITING.values(), ids=WAITING)
@pytest.mark.parametrize("words", FOR_EVER)
def test_who_talks_for_ever_is_not_listened_to_for_ever(wait: Callable[[Line], object], words: bytes) -> None:
    with contextlib.suppress(KitRobotError, GarbledError):
        wait(Talker(words))
