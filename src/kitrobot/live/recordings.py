"""The recordings that a studio has open: their files, and a folder for each with what it brought along.

Each has a name of its own, never used twice; `MissionFolder` finds the mission of one as `recording:NAME/FILE.krt`. A
file that the page sent is stored in a temporary folder, which goes when the studio ends. Safe to use from many threads.
"""

from __future__ import annotations

import secrets
import shutil
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.traces import OpenTrace, open_trace, unpack

MAX_OPEN = 16
"""Recordings that stay open; the one that was opened first goes when there are more."""


class RecordingError(KitRobotError):
    """There is no such recording, or none any more."""


class Recordings:
    """The recordings of one studio. `placed` is called with the folder of their missions, when it is created."""

    def __init__(self, placed: Callable[[Path], None]) -> None:
        self._placed = placed
        self._made: tempfile.TemporaryDirectory[str] | None = None
        self._files: dict[str, Path] = {}
        self._lock = threading.Lock()

    def folder(self) -> Path:
        """The temporary folder of them all."""
        with self._lock:
            if self._made is None:
                self._made = tempfile.TemporaryDirectory(prefix="kitrobot-", ignore_cleanup_errors=True)
                self._placed(Path(self._made.name).resolve())
            return Path(self._made.name).resolve()

    def new_file(self, name: str) -> Path:
        """A place for a file with that last name, in a folder that holds nothing else."""
        return Path(tempfile.mkdtemp(dir=self.folder(), prefix="file-")) / name

    def add(self, path: Path) -> tuple[str, Path, OpenTrace]:
        """Opens a recording: its name, the file of its mission, and what it holds; close that when done.

        Raises:
            TraceError: it cannot be played.
            FileError: what it brings along could not be written.
        """
        trace = open_trace(path)
        try:
            name = secrets.token_hex(6)
            place = self.folder() / name
            place.mkdir()
            mission = unpack(trace, place)
        except BaseException:
            trace.reader.close()
            raise
        with self._lock:
            self._files[name] = path
            gone = list(self._files)[:-MAX_OPEN]
            left = [(one, self._files.pop(one)) for one in gone]
        for one, file in left:
            shutil.rmtree(self.folder() / one, ignore_errors=True)
            if self.folder() in file.parents:
                shutil.rmtree(file.parent, ignore_errors=True)
        return name, mission, trace

    def open(self, name: str) -> OpenTrace:
        """A recording that was added, opened once more.

        Raises:
            RecordingError: there is none of that name.
            TraceError: its file was changed meanwhile.
        """
        with self._lock:
            path = self._files.get(name)
        if path is None:
            raise RecordingError(Sentence("this recording is not open any more"), Sentence("open its file once more"))
        return open_trace(path)
