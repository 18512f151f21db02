"""Watching a robot asks nothing of it while it runs."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from kitrobot.boards.monitor import watched_robot
from kitrobot.boards.programs import load_board_program
from kitrobot.live.robot_gateway import SerialGateway
from kitrobot.live.robot_worker import RobotWorker
from kitrobot_onboard.link import unwrap
from tests.boards.host import HostBoard, host_board, write_pulse
from tests.boards.proxy import Proxy
from tests.patience import PATIENCE_S


@pytest.fixture(autouse=True)
def _looked_at_all_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """However slow this machine is."""
    monkeypatch.setattr("kitrobot.robots.session.LOOK_S", 0.0)
    monkeypatch.setattr("kitrobot.deploy.line.board._FRESH_S", 1e9)


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[HostBoard]:
    with host_board(write_pulse(tmp_path), "pulse") as board:
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
        watched_robot(wire.address, tmp_path / "pulse.krt") as watched,
    ):
        watched.begin(20)
        while ear.heard.count("T") < 20:
            assert watched.listen(PATIENCE_S) is None
        assert watched.session.state.doing == "running"
        assert watched.session.state.tick > 0
    assert ear.asked() == 0


def test_the_studio_asks_nothing_of_a_robot_that_runs(robot: HostBoard, tmp_path: Path) -> None:
    ear = Ear()
    program = load_board_program(tmp_path / "pulse.krt")
    changed = threading.Event()
    with Proxy(int(robot.address.rpartition(":")[2]), disturb=ear) as wire:
        worker = RobotWorker(wire.address, "robot", "page", SerialGateway(), lambda: None)
        worker.session.subscribe(lambda change: changed.set())
        try:
            worker.connect(program)
            while ear.heard.count("T") < 10:
                assert changed.wait(PATIENCE_S)
                changed.clear()
            assert worker.status.robot.doing == "running"
        finally:
            worker.close()
            worker.wait(PATIENCE_S)
    assert ear.asked() == 0


def test_a_robot_whose_cable_is_pulled_as_soon_as_it_is_connected_is_lost(robot: HostBoard, tmp_path: Path) -> None:
    program = load_board_program(tmp_path / "pulse.krt")
    said = threading.Condition()

    def pull_at_watch(data: bytes) -> bytes:
        asked = [found[0] for piece in data.split(b"~") if (found := unwrap(piece)) is not None]
        if "w" not in asked:
            return data
        wire.cut()
        return b""

    def changed() -> None:
        with said:
            said.notify_all()

    with Proxy(int(robot.address.rpartition(":")[2]), disturb=pull_at_watch) as wire:
        worker = RobotWorker(wire.address, "robot", "page", SerialGateway(), changed)
        try:
            with said:
                worker.connect(program)
                assert said.wait_for(lambda: bool(worker.status.message), PATIENCE_S)
            assert worker.status.phase == "lost"
            assert "look at its cable" in str(worker.status.help)
        finally:
            worker.close()
