"""The recording of one real robot while the studio has it in its hand: begun with each run, kept until the next one.

A run is recorded from the moment it is started here, or found running, until it stops, ends or fails. When the link is
lost the recording waits: it goes on when the same program is found running again. Files stand in a temporary folder
that goes with the robot's hand. Only the hand's thread calls this, except for `save`.
"""

from __future__ import annotations

import tempfile
import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from kitrobot.trace import ENDING, TraceError

if TYPE_CHECKING:
    from kitrobot.deploy import Fault, News, Text
    from kitrobot.workspace import BoardProgram
    from kitrobot.workspace.board_recording import BoardRecorder


class Tape:
    """Records one robot, by the name that it has on the page."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._program: BoardProgram | None = None
        self._installed = ""
        self._recorder: BoardRecorder | None = None
        self._on = self._waits = False
        self._lock = threading.Lock()
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._told_error = False

    @property
    def is_there(self) -> bool:
        """Whether there is something to save."""
        return self._recorder is not None

    def error(self) -> TraceError | None:
        """Why the recording ended before its run did; said once."""
        found = self._recorder.error if self._recorder is not None else None
        if found is None or self._told_error:
            return None
        self._told_error = True
        return found

    def greeted(self, program: BoardProgram | None, installed: str, state: str, tick: int) -> None:
        """The robot was greeted: what it has (`program`, None when that is not known here) and how it stands."""
        goes_on = self._on and installed == self._installed
        self._program, self._installed = program, installed
        if goes_on:
            if self._waits:
                self._do(lambda recorder: recorder.found(0))
            self._waits = False
            self.stands(state, tick)
        elif state == "running":
            self._begin({})
            self.stands(state, tick)

    def started(self, inputs: Mapping[int, int], forced: Mapping[str, int]) -> None:
        """It was started from here. `inputs`: cells that were told already; `forced`: sensors that are held."""
        self._begin(inputs)
        self._do(lambda recorder: recorder.started(0))
        for sensor, value in forced.items():
            self.forced(sensor, value)

    def stopped(self) -> None:
        """It was stopped from here."""
        self._do(lambda recorder: recorder.stopped(0))
        self._end()

    def stands(self, state: str, tick: int) -> None:
        """How it stands; a run that is over ends the recording."""
        self._do(lambda recorder: recorder.stands(0, state, tick))
        if state not in ("running", "fault"):
            self._end()

    def told(self, news: News | Fault | Text | None) -> None:
        """What it said unasked; None for nothing."""
        self._do(lambda recorder: recorder.pass_time() if news is None else recorder.told(0, news))

    def failed(self, fault: Fault) -> None:
        """It stopped by itself."""
        self.told(fault)
        self._end()

    def lost(self, message: str) -> None:
        """The link is lost."""
        self._do(lambda recorder: recorder.lost(0, message))
        self._waits = self._on

    def began_anew(self) -> None:
        """It began anew by itself."""
        self._do(lambda recorder: recorder.began_anew(0))

    def forced(self, sensor: str, value: int | None) -> None:
        """A sensor is held at a value from here, or let go."""
        self._do(lambda recorder: recorder.forced(0, sensor, value))

    def variable_set(self, variable: str, value: int) -> None:
        """A variable was set from here."""
        self._do(lambda recorder: recorder.variable_set(0, variable, value))

    def save(self, path: Path) -> None:
        """Writes what was recorded so far into a file, from any thread.

        Raises:
            TraceError: nothing was recorded, or it cannot be written.
        """
        with self._lock:
            if self._recorder is None:
                raise TraceError("this robot was not recorded yet", "a recording begins when it runs")
            self._recorder.save(path)

    def close(self) -> None:
        """The robot is let go, and its recording with it."""
        self._end()
        with self._lock:
            self._recorder = None
            if self._folder is not None:
                self._folder.cleanup()
                self._folder = None

    def _begin(self, inputs: Mapping[int, int]) -> None:
        """A new recording takes the place of the one before, if what the robot has is known here."""
        from kitrobot.deploy import News
        from kitrobot.workspace.board_recording import BoardRecorder
        from kitrobot.workspace.board_traced import RecordedBoard

        self._end()
        program = self._program
        if program is None or program.carried is None:
            return
        try:
            folder = tempfile.TemporaryDirectory(prefix="kitrobot-", ignore_cleanup_errors=True)
        except OSError:
            # A computer without room for files runs robots all the same.
            return
        try:
            board = RecordedBoard(self._name, program.names, program.carried)
            recorder = BoardRecorder(Path(folder.name) / f"run{ENDING}", [board])
        except TraceError:
            folder.cleanup()
            return
        with self._lock:
            before, self._folder = self._folder, folder
            self._recorder, self._on, self._told_error = recorder, True, False
            if before is not None:
                before.cleanup()
        if inputs:
            recorder.told(0, News(0, inputs, {}))

    def _end(self) -> None:
        if self._recorder is not None and self._on:
            self._recorder.close()
        self._on = self._waits = False

    def _do(self, write: Callable[[BoardRecorder], None]) -> None:
        if self._recorder is not None and self._on:
            write(self._recorder)
