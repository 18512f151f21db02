"""Watching a robot asks nothing of it while it runs, and notices when it began anew."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy import Board, Hello, News
from kitrobot.server.board_hand import Hand
from kitrobot.server.board_links import RealLinks
from kitrobot.workspace import load_board_program
from kitrobot.workspace.board_watching import Watched, connected
from kitrobot_onboard.link import unwrap
from tests.boards.host import HostBoard, host_board, write_pulse
from tests.boards.proxy import Proxy
from tests.patience import PATIENCE_S


@pytest.fixture(autouse=True)
def _looked_at_all_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """However slow this machine is."""
    monkeypatch.setattr("kitrobot.server.board_hand.LOOK_S", 0.0)
    monkeypatch.setattr("kitrobot.workspace.board_watching.LOOK_S", 0.0)
    monkeypatch.setattr("kitrobot.deploy.board._FRESH_S", 1e9)


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[HostBoard]:
    with host_board(write_pulse(tmp_path), "pulse", tmp_path) as board:
        yield board


class Ear:
    """Hears the types of all frames on a wire, in both directions."""

    def __init__(self) -> None:
        self.heard = ""
        self._lock = threading.Lock()

    def __call__(self, data: bytes) -> bytes:
        with self._lock:
            self.heard += "".join(found[0] for piece in data.split(b"~") if (found := unwrap(piece)) is not None)
        return data

    def asked(self) -> int:
        """How often it was asked how it goes, once it had told that three times since it was watched."""
        told = self.heard[self.heard.rindex("w") :].split("T", 3)
        return told[3].count("h")


def test_who_watches_asks_nothing_of_a_robot_that_runs(robot: HostBoard, tmp_path: Path) -> None:
    ear = Ear()
    with (
        Proxy(int(robot.address.rpartition(":")[2]), disturb=ear) as wire,
        connected(wire.address, tmp_path / "pulse.krt") as watched,
    ):
        watched.begin(20)
        while ear.heard.count("T") < 20:
            assert watched.listen(PATIENCE_S) is None
        assert watched.view.hello.state_name == "running"
        assert watched.view.hello.tick > 0
    assert ear.asked() == 0


def test_the_studio_asks_nothing_of_a_robot_that_runs(robot: HostBoard, tmp_path: Path) -> None:
    ear = Ear()
    program = load_board_program(tmp_path / "pulse.krt")
    changed = threading.Event()
    with Proxy(int(robot.address.rpartition(":")[2]), disturb=ear) as wire:
        hand = Hand(wire.address, "robot", "page", RealLinks(), changed.set)
        try:
            hand.connect(program)
            while ear.heard.count("T") < 10:
                assert changed.wait(PATIENCE_S)
                changed.clear()
            assert hand.standing.state == "running"
        finally:
            hand.close()
            hand.wait(PATIENCE_S)
    assert ear.asked() == 0


class BeganAnew:
    """A robot that lost its power for a moment, and tells nothing since."""

    def __init__(self) -> None:
        self.hello = self._at(500)
        self.watched: list[int] = []

    def _at(self, tick: int) -> Hello:
        return Hello(1, 2, 0, 2000, tick, 0, 1, "c0ffee00", "-")

    def news(self, timeout: float) -> News | None:
        return None

    def look(self) -> Hello:
        return self._at(3)

    def watch(self, period_ms: int) -> None:
        self.watched.append(period_ms)


def test_a_robot_that_began_anew_is_watched_again() -> None:
    twin: Any = BeganAnew()
    board: Board = twin
    watched = Watched("twin", board, None, None)
    watched.begin(70)
    assert watched.listen(0) is None
    assert watched.listen(0) is None
    assert twin.watched == [70, 70]
