"""Boards to deploy to: the real firmware of the micro:bit in QEMU, and a current MicroPython as WebAssembly."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.boards.modern import ModernBoard
from tests.boards.qemu import Emulated, running


@pytest.fixture(autouse=True)
def _own_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing of the person who runs the tests is read or written."""
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "no-config"))
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.delenv("KITROBOT_BOARDS", raising=False)


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


@pytest.fixture
def board() -> Iterator[ModernBoard]:
    """A board with a current MicroPython: `address`, `cut_power()`."""
    with ModernBoard() as made:
        yield made
