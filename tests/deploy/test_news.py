"""What a host makes of what a board tells unasked, and when it asks all the same."""

from __future__ import annotations

import struct
import time
from typing import Any

import pytest

from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.news import Fault, News, Text, read_news
from kitrobot_onboard.link import unwrap, wrap

RUNNING, ENDED = 2, 3
CELL = b"c" + struct.pack("<Bi", 4, -9)


def goes(state: int, late: int = 0) -> bytes:
    """The record that says how a robot goes."""
    return b"s" + struct.pack("<BH", state, late)


def told(tick: int, records: bytes) -> bytes:
    """A frame of news."""
    return wrap("T", 0, struct.pack("<I", tick) + records)


class Twin:
    """A line to a board that answers at once and is asked about what it was asked."""

    address = "twin"

    def __init__(self) -> None:
        self.asked = ""
        self.comes = b""

    def write(self, data: bytes) -> None:
        found = unwrap(data.strip(b"~"))
        assert found is not None
        self.asked += found[0]
        hello = struct.pack("<BBBIIHH", 1, RUNNING, 0, 5000, 7, 0, 1) + b"c0ffee00 -"
        self.comes += wrap("H", found[1], hello) if found[0] == "h" else wrap("K", found[1], b"")

    def read(self, timeout_s: float) -> bytes:
        comes, self.comes = self.comes, b""
        return comes

    def now(self) -> float:
        return time.monotonic()

    def close(self) -> None:
        pass


@pytest.fixture
def wired() -> tuple[Any, Board]:
    twin: Any = Twin()
    board = Board(twin)
    board.greet()
    return twin, board


def test_a_board_that_still_tells_somebody_else_is_greeted(wired) -> None:
    twin: Any = Twin()
    twin.comes = told(7, goes(RUNNING))
    with Board(twin) as board:
        assert board.greet().free == 5000
        assert twin.asked == "h"
        assert isinstance(board.news(0), News)


def test_a_robot_that_runs_and_tells_how_it_goes_is_not_asked(wired: tuple[Any, Board]) -> None:
    twin, board = wired
    board.watch(100)
    twin.asked = ""
    for tick in range(10, 13):
        twin.comes += told(tick, CELL + goes(RUNNING, 3))
        assert board.news(0) == News(tick, {4: -9}, {}, frozenset(), RUNNING, 3)
        found = board.look()
        assert (found.state, found.tick, found.late, found.free, found.package) == (2, tick, 3, 5000, "c0ffee00")
    assert twin.asked == ""


@pytest.mark.parametrize("records", [CELL, CELL + goes(ENDED)], ids=["says nothing of it", "does not run"])
def test_a_robot_is_asked_when_it(wired: tuple[Any, Board], records: bytes) -> None:
    twin, board = wired
    twin.comes += told(10, records)
    assert board.news(0) is not None
    twin.asked = ""
    assert board.look().tick == 7
    assert twin.asked == "h"


def test_a_robot_that_went_silent_is_asked(wired: tuple[Any, Board], monkeypatch: pytest.MonkeyPatch) -> None:
    twin, board = wired
    twin.comes += told(10, goes(RUNNING))
    assert board.news(0) is not None
    monkeypatch.setattr(board, "_fresh_s", -1.0)
    twin.asked = ""
    assert board.look().tick == 7
    assert twin.asked == "h"


@pytest.mark.parametrize("order", ["s", "x"])
def test_what_was_told_before_an_order_does_not_say_how_it_goes_after_it(wired: tuple[Any, Board], order: str) -> None:
    twin, board = wired
    twin.comes += told(900, goes(RUNNING))
    if order == "s":
        board.start()
    else:
        board.stop()
    twin.asked = ""
    assert board.look().tick == 7
    assert twin.asked == "h"


def test_what_a_robot_says_after_its_answer_is_newer_than_that_though_both_are_read_at_once(
    wired: tuple[Any, Board], monkeypatch: pytest.MonkeyPatch
) -> None:
    twin, board = wired
    write = twin.write

    def answered_and_told(data: bytes) -> None:
        write(data)
        twin.comes += told(9, goes(RUNNING, 1))

    monkeypatch.setattr(twin, "write", answered_and_told)
    found = board.look()
    assert (found.tick, found.late, found.free) == (9, 1, 5000)
    monkeypatch.setattr(twin, "write", write)
    assert board.news(0) == News(9, {}, {}, frozenset(), RUNNING, 1)
    assert board.look().tick == 9, "else the robot seems to have begun anew"


def test_news_of_the_run_before_are_no_news_of_the_one_that_is_started(
    wired: tuple[Any, Board], monkeypatch: pytest.MonkeyPatch
) -> None:
    twin, board = wired
    write = twin.write

    def answered_and_told(data: bytes) -> None:
        twin.comes += told(901, CELL) + b"still here\n~"
        write(data)
        twin.comes += told(1, goes(RUNNING))

    monkeypatch.setattr(twin, "write", answered_and_told)
    twin.comes += told(900, CELL)
    board.start()
    found = [board.news(0) for _ in range(2)]
    assert found == [Text("still here\n"), News(1, {}, {}, frozenset(), RUNNING, 0)]


def test_what_a_later_version_adds_at_the_end_is_left_out() -> None:
    assert read_news(struct.pack("<I", 5) + CELL + goes(RUNNING) + b"?later") == News(
        5, {4: -9}, {}, frozenset(), RUNNING, 0
    )


def test_a_record_that_is_cut_off_is_left_out() -> None:
    assert read_news(struct.pack("<I", 5) + CELL + goes(RUNNING)[:-1]) == News(5, {4: -9}, {})


def test_a_robot_that_told_a_fault_is_asked_how_it_stands(wired: tuple[Any, Board]) -> None:
    twin, board = wired
    twin.comes = told(7, goes(RUNNING)) + wrap("F", 0, struct.pack("<BHI", 1, 3, 8) + b"a0 OSError")
    assert isinstance(board.news(0), News)
    assert board.news(0) == Fault(1, 3, 8, "a0 OSError")
    twin.asked = ""
    board.look()
    assert twin.asked == "h"


def test_a_fault_of_the_run_before_is_not_told_after_a_start(wired: tuple[Any, Board]) -> None:
    twin, board = wired
    fault = struct.pack("<BHI", 1, 65535, 3) + b"s2 not plugged in"
    twin.comes = wrap("F", 0, fault)
    board.stop()
    board.start(held=True)
    twin.comes += told(1, goes(RUNNING))
    assert isinstance(board.news(0), News)
    twin.comes = wrap("F", 0, fault)
    assert isinstance(board.news(0), Fault)
