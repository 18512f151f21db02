"""The pictures on the cards of a class: for each pupil the program that was handed in last.

Made when work comes in, or from the file when the class was started anew. Safe to use from many threads.
"""

from __future__ import annotations

import threading

from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.messages import ClassPictureShape
from kitrobot.classroom.pupil import Pupil
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.reader import read_mission
from kitrobot.wire.mission import MissionShape, mission_shape

MOST_VERTICES = 500
"""Of a program that is drawn; nobody could tell a larger one's parts apart on a card."""


class ClassPictures:
    """The pictures of one class."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room
        self._cache: dict[str, bytes] = {}
        self._lock = threading.Lock()
        for pupil in room.pupils.values():
            if pupil.work:
                pupil.version = 1

    def take(self, pupil: Pupil, mission: MissionShape) -> None:
        """Stores the picture of a mission that was handed in."""
        with self._lock:
            self._cache[pupil.folder] = _picture(pupil.version, mission)

    def of(self, pupil: Pupil) -> bytes | None:
        """The picture as JSON; None where there is nothing to draw."""
        with self._lock:
            kept = self._cache.get(pupil.folder)
        if kept is None and pupil.work:
            try:
                data, _ = self._room.read_submission(pupil, pupil.work)
                mission = read_mission(data, pupil.work)[0]
            except KitRobotError:
                return None
            if mission is not None:
                self.take(pupil, mission_shape(mission))
            with self._lock:
                kept = self._cache.get(pupil.folder)
        return kept or None


def _picture(version: int, mission: MissionShape) -> bytes:
    runs = {agent.program for agent in mission.agents}
    program = next((one for one in mission.programs if one.name in runs), next(iter(mission.programs), None))
    if program is None or len(program.vertices) > MOST_VERTICES:
        return b""
    return ClassPictureShape(version=version, program=program).model_dump_json().encode()
