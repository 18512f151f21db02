"""What the requests of one studio share: its folder, and what was read for the missions of it.

Robots, constructors and worlds are read from files each time they changed, so a file that is dropped into the folder is
there at the next request, without a restart; while nothing changed, what was read before serves again. Safe to use
from many threads.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import threading
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.folder import RECORDING, MissionFolder
from kitrobot.files.recovery import Journals
from kitrobot.live.background import StopSignal
from kitrobot.live.broadcast import Broadcast
from kitrobot.live.gallery import Gallery
from kitrobot.live.recordings import Recordings
from kitrobot.live.robot_gateway import SerialGateway
from kitrobot.live.robot_registry import RobotRegistry
from kitrobot.live.watched_run import WatchedRun
from kitrobot.mission.model import Mission
from kitrobot.primitives.catalogue import SHIPPED, Catalogue, load_catalogue
from kitrobot.translation.reader_language import reader_language
from kitrobot.user_folders import config_folder
from kitrobot.wire.catalogue import CatalogueShape, catalogue_shape
from kitrobot.workspace.compile_cache import CompileCache
from kitrobot.workspace.exercises import Exercises
from kitrobot.workspace.mission_loader import OpenMission, read_mission_data, with_mission
from kitrobot.workspace.new_mission_choices import NewMissionChoices
from kitrobot.workspace.previews import Previews
from kitrobot.workspace.search_path import SearchPath
from kitrobot.workspace.traces import OpenTrace
from kitrobot.workspace.tutorials import Tutorials
from kitrobot.world.lookup import EMPTY

Stamp = tuple[tuple[str, int, int, int], ...]
MAX_CACHED = 16
"""The number of folders whose catalogue is cached."""
MOST_WORLDS = 1000
"""Missions of which it is known which world they are in."""


class CachedCatalogue:
    """The catalogue of some folders, read in the state of `stamp`."""

    def __init__(self, stamp: Stamp, catalogue: Catalogue) -> None:
        self.stamp = stamp
        self.catalogue = catalogue
        self._shapes: dict[str, CatalogueShape] = {}

    def shape(self, language: str) -> CatalogueShape:
        """As it travels to a reader of that language; made once."""
        if language not in self._shapes:
            self._shapes[language] = catalogue_shape(self.catalogue, language)
        return self._shapes[language]


class Studio:
    """One studio. `runs` counts the runs that are on; only the server's event loop touches it."""

    def __init__(self, workspace: Path, mission: Path | None) -> None:
        self.folder = MissionFolder(workspace)
        self.journals = Journals(self.folder)
        self.first = self.folder.name_of(mission) if mission is not None else None
        self.runs = 0
        self.at_work: set[str] = set()
        """The kinds of work in the background that are on (`websocket_jobs`); as `runs`."""
        self.watches: dict[str, WatchedRun] = {}
        """The runs and recordings that are on, by their names."""
        self.broadcasts: dict[str, Broadcast] = {}
        """Their watchers, by the same names."""
        self.boards = RobotRegistry(SerialGateway())
        """The real robots."""
        self.boards_for_visitors = False
        """Whether pages on other machines may use the ports of this one."""
        self.in_page = False
        """Whether it runs in the page itself, without a network, and with chosen ports only (`in_page_server`)."""
        self.recordings = Recordings(self._recordings_are_in)
        self.saving = asyncio.Lock()
        """Held while a run is recorded once more: one at a time is quick enough."""
        self.gallery = Gallery()
        self.previews = Previews()
        """What missions do in their first seconds."""
        self.tutorials = Tutorials(self.folder)
        self.exercises = Exercises(self.folder)
        self.judging: dict[str, StopSignal] = {}
        """What stops each judging that is on, by the name that its page gave it."""
        self.programs = CompileCache()
        self._lock = threading.Lock()
        self._catalogues: dict[tuple[Path, ...], CachedCatalogue] = {}
        self._worlds: dict[str, Path] = {}

    @cached_property
    def _choices(self) -> NewMissionChoices:
        return NewMissionChoices(self.folder)

    @property
    def choices(self) -> NewMissionChoices:
        """What a new mission can begin with, the robots that are in the folder now included."""
        return self._choices.with_own(self.catalogue(""))

    def runs_of(self, path: str) -> list[str]:
        """The runs that are on of the mission of that path; none where it is of no file."""
        return [
            name
            for name, broadcast in list(self.broadcasts.items())
            if path and broadcast.on and broadcast.path == path
        ]

    def _recordings_are_in(self, folder: Path) -> None:
        self.folder.recordings = folder

    def catalogue(self, path: str) -> Catalogue:
        """The robots and constructors for a mission."""
        return self._parts(path).catalogue

    def catalogue_shape(self, path: str) -> CatalogueShape:
        """As `catalogue`, as it travels to the reader of this request."""
        return self._parts(path).shape(reader_language())

    def _parts(self, path: str) -> CachedCatalogue:
        folders = self.folder.folders_of(path)
        stamp = _stamp((SHIPPED, config_folder(), *folders))
        with self._lock:
            kept = self._catalogues.get(folders)
        if kept is not None and kept.stamp == stamp:
            return kept
        kept = CachedCatalogue(stamp, load_catalogue(folders))
        with self._lock:
            if len(self._catalogues) >= MAX_CACHED:
                self._catalogues.clear()
            self._catalogues[folders] = kept
        return kept

    def stamp(self, path: str) -> str:
        """A name for the state of the XML files that a mission depends on: another one when one of them changed."""
        with self._lock:
            world = self._worlds.get(path)
        stamp = _stamp((SHIPPED, config_folder(), *self.folder.folders_of(path)), world)
        return hashlib.sha256(repr(stamp).encode(errors="surrogateescape")).hexdigest()[:20]

    def world_file(self, href: str, path: str) -> Path | None:
        """The file of a mission's world; from now on it belongs to what the mission depends on."""
        search = self._search_path(path)
        found = search.world_file(href)
        with self._lock:
            if len(self._worlds) >= MOST_WORLDS:
                self._worlds.clear()
            self._worlds[path] = found or [search.folder, *search.before][-1] / (href or EMPTY)
        return found

    def open(self, mission: Mission, path: str) -> OpenMission:
        """A mission that the page sent, among the files of the folder it was opened from."""
        self.world_file(mission.world_href, path)
        search = self._search_path(path, self.catalogue(path))
        return with_mission(mission, path or "mission.krt", search, self.programs)

    def _search_path(self, path: str, known: Catalogue | None = None) -> SearchPath:
        folder, *own = self.folder.folders_of(path)
        return SearchPath(folder, tuple(own), self.folder.root_of(path), known)

    def parts_of(self, mission: Mission, path: str) -> Catalogue:
        """The robots and constructors for a mission that the page sent: of the files, and those it brings along."""
        catalogue = self.catalogue(path)
        return self.programs.catalogue(catalogue, mission.constructors, mission.variables, mission.crew)

    def recorded(self, trace: OpenTrace, recording: str) -> OpenMission | None:
        """The mission of a recording among what it brought along; None where that cannot be used."""
        try:
            return self.open(trace.mission, f"{RECORDING}{recording}/{trace.stem}.krt")
        except KitRobotError:
            return None

    def read(self, data: bytes, name: str, path: str) -> OpenMission:
        """A mission's file, opened among the files of the folder that it is in."""
        return read_mission_data(data, name, self._search_path(path, self.catalogue(path)))


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
