"""Boards to deploy to: the real firmware of the micro:bit in QEMU, and a current MicroPython as WebAssembly."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from kitrobot.deploy.line.line import Line
from tests.boards.clocks import TrafficClock
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.qemu import Emulated, running


@pytest.fixture(autouse=True)
def _own_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing of the person who runs the tests is read or written."""
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "no-config"))
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.delenv("KITROBOT_BOARDS", raising=False)


@pytest.fixture
def patient_host(monkeypatch: pytest.MonkeyPatch) -> None:
    """A host that gives up no board that only has to wait for a processor: two seconds after its last byte, the clock
    by which lines wait goes a tenth as fast.
    """
    clock = TrafficClock(granted_s=2.0, slow_pace=0.1)
    clock.heard()
    read = Line.read

    def read_and_note(line: Line, timeout_s: float) -> bytes:
        if data := read(line, timeout_s):
            clock.heard()
        return data

    monkeypatch.setattr(Line, "now", lambda line: clock.ms() / 1000)
    monkeypatch.setattr(Line, "read", read_and_note)


@pytest.fixture
def microbit() -> Iterator[Emulated]:
    """A micro:bit of 2016, with nothing on it."""
    with running() as board:
        yield board


@pytest.fixture(scope="session")
def _kept_microbit() -> Iterator[Emulated]:
    with running() as board:
        yield board


@pytest.fixture
def used_microbit(_kept_microbit: Emulated) -> Iterator[Emulated]:
    """A micro:bit of 2016 that has just started, with what tests before left on it: most files are there."""
    _kept_microbit.resume()
    _kept_microbit.cut_power()
    yield _kept_microbit
    _kept_microbit.pause()


@pytest.fixture(scope="module")
def _kept_kit() -> Iterator[ModernBoard]:
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}) as made:
        yield made


@pytest.fixture
def kit(_kept_kit: ModernBoard) -> ModernBoard:
    """One with pins that only remember, just switched on, with what tests of the same file before left on it."""
    _kept_kit.cut_power()
    return _kept_kit


@pytest.fixture
def board() -> Iterator[ModernBoard]:
    """A board with a current MicroPython: `address`, `cut_power()`."""
    with ModernBoard() as made:
        yield made
