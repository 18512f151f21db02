"""A studio for each pupil, in the teacher's process: for a class without a static site (`class_pages`).

Each is an ordinary studio on a hidden folder of its own, so nothing of one pupil is in another's. It simulates: ports,
teams of processes, recordings that are brought along, sweeps and checks of every order are not for pupils here, for
they would take the teacher's machine. The class itself (`class_routes`) knows nothing of these studios.
"""

from __future__ import annotations

import os
import secrets
import threading
from pathlib import Path
from typing import Final

from fastapi import FastAPI

from kitrobot.classroom import ClassRoom
from kitrobot.diagnostics import KitRobotError
from kitrobot.server.app import create_app
from kitrobot.server.class_exercises import copy_exercise
from kitrobot.server.gallery import Gallery

FOLDER: Final = ".studios"
MOST_BYTES: Final = 64 * 1024 * 1024
MOST_FILES: Final = 300
"""Of one pupil's studio: missions, parts, journals."""
LOOK_S: Final = 5.0
"""How often a folder is measured, at most."""
NOT_HERE: Final = ("/api/board", "/api/boards", "/api/trace", "/api/run/trace", "/api/sweep", "/api/verify")
"""Beginnings of what pupils' studios do not do."""
WRITES: Final = ("/api/mission", "/api/journal", "/api/parts")


class PupilStudio:
    """One pupil's studio: its application, and the token that it takes."""

    def __init__(self, room: ClassRoom, folder: Path, gallery: Gallery) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        self.token = secrets.token_urlsafe(24)
        self.app: FastAPI = create_app(folder, None, self.token)
        # Only examples are in it, which are the same for all, and take seconds to read.
        self.app.state.studio.gallery = gallery
        self.app.state.studio.folder.in_class = True
        self._room = room
        self._measured: float | None = None
        self._full = False

    def take_exercise(self) -> None:
        """Gets the files of the exercise of the class; where that cannot be, the log says so."""
        try:
            copy_exercise(self._room, self.folder)
        except (KitRobotError, OSError) as error:
            self._room.log.say(f"{self.folder.name} did not get the exercise: {error}")

    def is_full(self, now: float) -> bool:
        """Whether nothing more is written."""
        if self._measured is None or now - self._measured >= LOOK_S:
            self._measured = now
            files = size = 0
            for folder, _, names in os.walk(self.folder):
                for name in names:
                    files += 1
                    try:
                        size += os.lstat(os.path.join(folder, name)).st_size
                    except OSError:
                        continue
            self._full = files > MOST_FILES or size > MOST_BYTES
        return self._full


class PupilStudios:
    """The studios of a class, each made when its pupil first asks for something. Safe to use from many threads."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room
        self._folder = room.folder / FOLDER
        self._clock = room.clock
        self._gallery = Gallery()
        self._made: dict[str, PupilStudio] = {}
        self._lock = threading.Lock()

    def of(self, pupil: str) -> PupilStudio:
        """The studio of the pupil with that folder."""
        with self._lock:
            made = self._made.get(pupil)
            if made is None:
                made = self._made[pupil] = PupilStudio(self._room, self._folder / pupil, self._gallery)
                made.take_exercise()
            return made

    def take_exercise(self) -> None:
        """The class has another exercise."""
        with self._lock:
            for made in self._made.values():
                made.take_exercise()

    def refuses(self, path: str) -> bool:
        """Whether that is not for pupils."""
        return any(path == one or path.startswith(f"{one}/") for one in NOT_HERE)

    def is_full(self, studio: PupilStudio, method: str, path: str) -> bool:
        """Whether that would be written, and the pupil has no room left."""
        writes = method in ("PUT", "POST") and any(path == one or path.startswith(f"{one}/") for one in WRITES)
        return writes and path not in ("/api/mission/text", "/api/mission/read") and studio.is_full(self._clock())
