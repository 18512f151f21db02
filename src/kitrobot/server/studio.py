"""What the requests of one studio share: its folder, and what was read for the missions of it.

Robots, constructors and worlds are read from files each time they changed, so a file that is dropped into the folder is
there at the next request, without a restart; while nothing changed, what was read before serves again. Safe to use
from many threads.
"""

from __future__ import annotations

import contextlib
import hashlib
import threading
from collections.abc import Iterable
from pathlib import Path

from kitrobot.diagnostics import KitRobotError
from kitrobot.mission import Mission
from kitrobot.primitives import SHIPPED, Catalogue, config_folder, load_catalogue
from kitrobot.server.audience import Audience
from kitrobot.server.board_links import RealLinks
from kitrobot.server.board_room import BoardRoom
from kitrobot.server.gallery import Gallery
from kitrobot.server.playing import Player
from kitrobot.server.recordings import Recordings
from kitrobot.server.shapes import CatalogueShape, catalogue_shape
from kitrobot.server.watching import Watch
from kitrobot.workspace import (
    Journals,
    KeptPrograms,
    MissionFolder,
    OpenMission,
    OpenTrace,
    Tutorials,
    read_mission_data,
    with_mission,
    world_file,
)
from kitrobot.workspace.folder import RECORDING
from kitrobot.world import EMPTY

Stamp = tuple[tuple[str, int, int, int], ...]
MOST_KEPT = 16
"""Folders whose catalogue is kept."""
MOST_WORLDS = 1000
"""Missions of which it is known which world they are in."""


class Studio:
    """One studio. `runs` counts the runs that are on; only the server's event loop touches it."""

    def __init__(self, workspace: Path, mission: Path | None) -> None:
        self.folder = MissionFolder(workspace)
        self.journals = Journals(self.folder)
        self.first = self.folder.name_of(mission) if mission is not None else None
        self.runs = 0
        self.watches: dict[str, Watch | Player] = {}
        """The runs and recordings that are on, by their names."""
        self.audiences: dict[str, Audience] = {}
        """Who watches them, by the same names."""
        self.boards = BoardRoom(RealLinks())
        """The real robots."""
        self.boards_for_visitors = False
        """Whether pages on other machines may use the ports of this one."""
        self.recordings = Recordings(self._recordings_are_in)
        self.saving = threading.Lock()
        """Held while a run is recorded once more: one at a time is quick enough."""
        self.gallery = Gallery()
        self.tutorials = Tutorials(self.folder)
        self.programs = KeptPrograms()
        self._lock = threading.Lock()
        self._kept: dict[tuple[Path, ...], tuple[Stamp, Catalogue, CatalogueShape]] = {}
        self._worlds: dict[str, Path] = {}

    def runs_of(self, path: str) -> list[str]:
        """The runs that are on of the mission of that path; none where it is of no file."""
        return [
            name for name, audience in list(self.audiences.items()) if path and audience.on and audience.path == path
        ]

    def _recordings_are_in(self, folder: Path) -> None:
        self.folder.recordings = folder

    def catalogue(self, path: str) -> tuple[Catalogue, CatalogueShape]:
        """The robots and constructors for a mission, and the same as it travels."""
        folders = self.folder.folders_of(path)
        stamp = _stamp((SHIPPED, config_folder(), *folders))
        with self._lock:
            kept = self._kept.get(folders)
        if kept is not None and kept[0] == stamp:
            return kept[1], kept[2]
        catalogue = load_catalogue(folders)
        shape = catalogue_shape(catalogue)
        with self._lock:
            if len(self._kept) >= MOST_KEPT:
                self._kept.clear()
            self._kept[folders] = (stamp, catalogue, shape)
        return catalogue, shape

    def stamp(self, path: str) -> str:
        """A name for the state of the XML files that a mission depends on: another one when one of them changed."""
        with self._lock:
            world = self._worlds.get(path)
        stamp = _stamp((SHIPPED, config_folder(), *self.folder.folders_of(path)), world)
        return hashlib.sha256(repr(stamp).encode(errors="surrogateescape")).hexdigest()[:20]

    def world_file(self, href: str, path: str) -> Path | None:
        """The file of a mission's world; from now on it belongs to what the mission depends on."""
        folders = self.folder.folders_of(path)
        found = world_file(href, folders[::-1], [*folders, self.folder.root_of(path)])
        with self._lock:
            if len(self._worlds) >= MOST_WORLDS:
                self._worlds.clear()
            self._worlds[path] = found or folders[-1] / (href or EMPTY)
        return found

    def open(self, mission: Mission, path: str) -> OpenMission:
        """A mission that the page sent, among the files of the folder it was opened from."""
        folder, *own = self.folder.folders_of(path)
        catalogue, _ = self.catalogue(path)
        within = self.folder.root_of(path)
        self.world_file(mission.world_href, path)
        name = path or "mission.krt"
        return with_mission(
            mission, folder, name=name, catalogue=catalogue, within=within, before=own, kept=self.programs
        )

    def parts_of(self, mission: Mission, path: str) -> Catalogue:
        """The robots and constructors for a mission that the page sent: of the files, and those it brings along."""
        catalogue, _ = self.catalogue(path)
        return self.programs.catalogue(catalogue, mission.constructors, mission.variables)

    def recorded(self, trace: OpenTrace, recording: str) -> OpenMission | None:
        """The mission of a recording among what it brought along; None where that cannot be used."""
        try:
            return self.open(trace.mission, f"{RECORDING}{recording}/{trace.stem}.krt")
        except KitRobotError:
            return None

    def read(self, data: bytes, name: str, path: str) -> OpenMission:
        """A mission's file, opened among the files of the folder that it is in."""
        folder, *own = self.folder.folders_of(path)
        catalogue, _ = self.catalogue(path)
        return read_mission_data(data, name, folder, catalogue=catalogue, within=self.folder.root_of(path), before=own)


def _stamp(folders: Iterable[Path], also: Path | None = None) -> Stamp:
    """What changes when an XML file of the folders changes, or the file `also`, or when one comes or goes."""
    paths: list[Path] = [] if also is None else [also]
    for folder in folders:
        with contextlib.suppress(OSError):
            paths += sorted(folder.glob("*.xml"))
    found = []
    for path in paths:
        with contextlib.suppress(OSError):
            state = path.stat()
            found.append((str(path), state.st_mtime_ns, state.st_ino, state.st_size))
    return tuple(found)
