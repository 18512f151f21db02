"""Which part of a real robot's session is recorded while the studio is connected to it: its last run.

A run is recorded from the moment it is started here, or found running, until it stops, ends or fails, and stored until
the next one. When the link is lost the recording waits: it goes on when the same program is found running again. Files
are in a temporary folder that goes with the robot's session. Only the session's thread calls this, except for `save`.
"""

from __future__ import annotations

import tempfile
import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.trace.model import TraceError

if TYPE_CHECKING:
    from kitrobot.robots.recording import RobotRecorder
    from kitrobot.robots.session import RobotSession
    from kitrobot.robots.state import Change


class LastRunRecorder:
    """Records the last run of one robot, by the name that it has on the page."""

    def __init__(self, name: str, session: RobotSession) -> None:
        self._name = name
        self._session = session
        self._installed = ""
        self._recorder: RobotRecorder | None = None
        self._on = False
        self._lock = threading.Lock()
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._is_error_reported = False
        session.subscribe(self._changed)

    @property
    def is_there(self) -> bool:
        """Whether there is something to save."""
        return self._recorder is not None

    def error(self) -> TraceError | None:
        """Why the recording ended before its run did; returned once."""
        found = self._recorder.error if self._recorder is not None else None
        if found is None or self._is_error_reported:
            return None
        self._is_error_reported = True
        return found

    def save(self, path: Path) -> None:
        """Writes what was recorded so far into a file, from any thread.

        Raises:
            TraceError: nothing was recorded, or it cannot be written.
        """
        with self._lock:
            if self._recorder is None:
                raise TraceError(
                    Sentence("this robot was not recorded yet"), Sentence("a recording begins when it runs")
                )
            self._recorder.save(path)

    def close(self) -> None:
        """Ends with the robot's session, and removes the recording."""
        self._end()
        with self._lock:
            self._recorder = None
            if self._folder is not None:
                self._folder.cleanup()
                self._folder = None

    def _changed(self, change: Change) -> None:
        from kitrobot.robots.session import held_event
        from kitrobot.robots.state import ChangeKind

        kind, state = change.kind, change.state
        if kind is ChangeKind.STARTED:
            self._begin()
            known = self._session.known
            held = () if known is None else (held_event(known.names, *one) for one in state.forced.items())
            change = replace(change, events=(*change.events, *held))
        elif kind is ChangeKind.GREETED and not (self._on and state.installed == self._installed):
            self._end()
            if state.doing == "running":
                self._begin()
                change = replace(change, events=())
        if kind is ChangeKind.GREETED:
            self._installed = state.installed
        if self._recorder is not None and self._on:
            self._recorder.robot_changed(0, change)
        if not state.lost and (state.doing in ("none", "ready", "ended") or state.fault is not None):
            self._end()

    def _begin(self) -> None:
        """A new recording takes the place of the one before, if what the robot has is known here."""
        from kitrobot.robots.recording import RobotRecorder
        from kitrobot.robots.records import RecordedBoard

        self._end()
        known = self._session.known
        if known is None or known.recording_context is None:
            return
        try:
            folder = tempfile.TemporaryDirectory(prefix="kitrobot-", ignore_cleanup_errors=True)
        except OSError:
            # A computer without room for files runs robots all the same.
            return
        try:
            board = RecordedBoard(self._name, known.names, known.recording_context)
            recorder = RobotRecorder(Path(folder.name) / f"run{ENDING}", [board])
        except TraceError:
            folder.cleanup()
            return
        with self._lock:
            before, self._folder = self._folder, folder
            self._recorder, self._on, self._is_error_reported = recorder, True, False
            if before is not None:
                before.cleanup()

    def _end(self) -> None:
        if self._recorder is not None and self._on:
            self._recorder.close()
        self._on = False
