"""What the requests of one studio share: its folder, and what was read for the missions of it.

Robots, constructors and worlds are read from files each time they changed, so a file that is dropped into the folder is
there at the next request, without a restart; while nothing changed, what was read before serves again. Safe to use
from many threads.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable
from pathlib import Path

from kitrobot.mission import Mission
from kitrobot.primitives import SHIPPED, Catalogue, config_folder, load_catalogue
from kitrobot.server.gallery import Gallery
from kitrobot.server.shapes import CatalogueShape, catalogue_shape
from kitrobot.workspace import Journals, MissionFolder, OpenMission, Tutorials, read_mission_data, with_mission

Stamp = tuple[tuple[str, int, int], ...]
MOST_KEPT = 16
"""Folders whose catalogue is kept."""


class Studio:
    """One studio. `runs` counts the runs that are on; only the server's event loop touches it."""

    def __init__(self, workspace: Path, mission: Path | None) -> None:
        self.folder = MissionFolder(workspace)
        self.journals = Journals(self.folder)
        self.first = self.folder.name_of(mission) if mission is not None else None
        self.runs = 0
        self.gallery = Gallery()
        self.tutorials = Tutorials(self.folder)
        self._lock = threading.Lock()
        self._kept: dict[Path, tuple[Stamp, Catalogue, CatalogueShape]] = {}

    def catalogue(self, folder: Path) -> tuple[Catalogue, CatalogueShape]:
        """The robots and constructors for the missions of a folder, and the same as it travels."""
        stamp = _stamp((SHIPPED, config_folder(), folder))
        with self._lock:
            kept = self._kept.get(folder)
        if kept is not None and kept[0] == stamp:
            return kept[1], kept[2]
        catalogue = load_catalogue([folder])
        shape = catalogue_shape(catalogue)
        with self._lock:
            if len(self._kept) >= MOST_KEPT:
                self._kept.clear()
            self._kept[folder] = (stamp, catalogue, shape)
        return catalogue, shape

    def open(self, mission: Mission, path: str) -> OpenMission:
        """A mission that the page sent, among the files of the folder it was opened from."""
        folder = self.folder.folder_of(path)
        catalogue, _ = self.catalogue(folder)
        within = self.folder.root_of(path)
        return with_mission(mission, folder, name=path or "mission.krt", catalogue=catalogue, within=within)

    def parts_of(self, mission: Mission, path: str) -> Catalogue:
        """The robots and constructors for a mission that the page sent: of the files, and those it brings along."""
        catalogue, _ = self.catalogue(self.folder.folder_of(path))
        return catalogue.extended(mission.constructors, mission.variables)

    def read(self, data: bytes, name: str, path: str) -> OpenMission:
        """A mission's file, opened among the files of the folder that it is in."""
        folder = self.folder.folder_of(path)
        catalogue, _ = self.catalogue(folder)
        return read_mission_data(data, name, folder, catalogue=catalogue, within=self.folder.root_of(path))


def _stamp(folders: Iterable[Path]) -> Stamp:
    """What changes when an XML file of the folders changes."""
    found = []
    for folder in folders:
        try:
            for path in sorted(folder.glob("*.xml")):
                state = path.stat()
                found.append((str(path), state.st_mtime_ns, state.st_size))
        except OSError:
            continue
    return tuple(found)
