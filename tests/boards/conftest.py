"""Boards to deploy to: the real firmware of the micro:bit in QEMU, and a current MicroPython as WebAssembly."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.microbit_hex.bundled_firmware import V1, firmware_file
from tests.boards.bench import bench_program
from tests.boards.clocks import TrafficClock
from tests.boards.hex_sections import image_2016
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.qemu import Emulated, booted, running
from tests.patience import PATIENCE_S


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
def _installed_microbit(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The state of a micro:bit of 2016 that has a small program from a file for its drive."""
    folder = tmp_path_factory.mktemp("microbit")
    program = bench_program(folder)
    with booted(firmware=image_2016(program, folder)) as board:
        with connect(board.address, PATIENCE_S) as link:
            assert link.hello.state == 2
        board.keep_state(folder / "state")
    return folder / "state"


@pytest.fixture
def used_microbit(_installed_microbit: Path) -> Iterator[Emulated]:
    """A micro:bit of 2016 that runs a small program: the loop is in its flash, which takes long to compile."""
    with booted("-incoming", f"exec:cat '{_installed_microbit}'", firmware=str(firmware_file(V1))) as board:
        yield board


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
