"""A studio for each pupil, in the teacher's process: for a class without a static site (`class_pages`).

Each is an ordinary studio on a hidden folder of its own, so nothing of one pupil is in another's. It simulates: ports,
teams of processes, recordings that are brought along, sweeps, experiments and checks of every order are not for pupils
here, for they would take the teacher's machine. The class itself (`class_routes`) knows nothing of these studios.
"""

from __future__ import annotations

import secrets
import threading
from pathlib import Path
from typing import Final

from fastapi import FastAPI

from kitrobot.classroom.class_room import STUDIOS, ClassRoom
from kitrobot.classroom.exercises import copy_exercise
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.folder_quota import Quota
from kitrobot.live.gallery import Gallery
from kitrobot.server.app import create_app

MOST_BYTES: Final = 64 * 1024 * 1024
MOST_FILES: Final = 300
"""Of one pupil's studio: missions, parts, journals, folders."""
NOT_HERE: Final = (
    *("/api/board", "/api/boards", "/api/trace", "/api/run/trace"),
    *("/api/sweep", "/api/experiment", "/api/verify"),
)
"""Beginnings of what pupils' studios do not do."""


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
        self.quota = Quota(folder, MOST_BYTES, MOST_FILES)

    def take_exercise(self) -> None:
        """Gets the files of the class's exercise; if that fails, the log reports it."""
        try:
            copy_exercise(self._room, self.folder)
        except (KitRobotError, OSError) as error:
            self._room.log.write(f"{self.folder.name} did not get the exercise: {error}")


class PupilStudios:
    """The studios of a class, each made when its pupil first asks for something. Safe to use from many threads."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room
        self._folder = room.folder / STUDIOS
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
