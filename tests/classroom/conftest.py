"""A class without HTTP, and a clock that goes on when a test says so."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.classroom.admission import Admission
from kitrobot.classroom.class_room import ClassRoom


class Clock:
    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def room(tmp_path: Path, clock: Clock):
    room = ClassRoom(tmp_path / "Class 5b", clock)
    yield room
    room.close()


@pytest.fixture
def admission(room: ClassRoom):
    return Admission(room)


def join(room: ClassRoom, admission: Admission, name: str = "Ada"):
    return admission.join(room.record.code, name, "", "10.0.0.5")
