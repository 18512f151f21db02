"""Recordings of real robots: their run (`run`) written into a file of the one format of traces.

An error of the file never disturbs the sessions: the recording ends, and `error` is the reason.
"""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from kitrobot.robots.records import RecordedBoard, header_of, refuse_several_missions
from kitrobot.robots.run import RobotsRun
from kitrobot.robots.state import Change
from kitrobot.text.sentences import Sentence, Word
from kitrobot.trace.model import TickRecord, TraceError
from kitrobot.trace.writer import TraceWriter

SETTLE_S = 5.0
"""How much of a recording is lost at most when the program is killed."""
MOST_FILLED = 30_000
"""Ticks without news that are written one by one; of a longer silence only the last ones."""


class RobotRecorder:
    """Records robots until it is closed. Safe to use from many threads.

    Raises:
        NoRecordingError: they run programs of several missions.
        TraceError: the file cannot be made.
    """

    def __init__(
        self, path: Path, robots: Sequence[RecordedBoard], clock: Callable[[], float] = time.monotonic
    ) -> None:
        refuse_several_missions(robots)
        self.path = path
        self.error: TraceError | None = None
        self._clock = clock
        self._done = False
        self._writer = TraceWriter(path, header_of(robots))
        self._settled = clock()
        self._run = RobotsRun(robots, clock=clock, on_tick=self._write)
        self._run.end_tick()
        try:
            self._writer.settle()
        except BaseException:
            self._writer.close()
            raise

    def robot_changed(self, number: int, change: Change) -> None:
        """As `RobotsRun.robot_changed`."""
        self._run.robot_changed(number, change)

    def save(self, path: Path) -> None:
        """Writes what was recorded so far into another file, whole; the recording goes on.

        Raises:
            TraceError: it cannot be written there, or nothing could be recorded.
        """
        with self._run.lock:
            self._end_tick()
            try:
                shutil.copyfile(self.path, path)
                if not self._done and self.error is None:
                    TraceWriter.end(path, self.outcome())
            except OSError as error:
                raise TraceError(Sentence("the recording cannot be saved: {reason}", Word(error.strerror))) from error

    def close(self) -> None:
        """Ends the recording; again does nothing."""
        with self._run.lock:
            if self._done:
                return
            self._end_tick()
            self._done = True
            self._writer.finish(self.outcome())
            self._attempt(self._writer.close)

    def outcome(self) -> dict[str, Any]:
        """The outcome so far, as the end of a trace holds it."""
        outcome, sentence = self._run.ending
        return {"outcome": outcome, "sentence": sentence, "ticks": self._run.tick - 1, "delivered": 0, "collisions": 0}

    def _end_tick(self) -> None:
        """Writes everything up to now."""
        if not self._done:
            self._run.end_tick()
            self._attempt(self._writer.settle)

    def _write(self, record: TickRecord, following: int) -> None:
        if not self._done and self.error is None:
            self._attempt(lambda: self._write_all(record, following))

    def _write_all(self, record: TickRecord, following: int) -> None:
        self._writer.record(record)
        for silent in range(max(record.tick + 1, following - MOST_FILLED), following):
            self._writer.record(TickRecord(silent, record.numbers, record.active))
        if self._clock() - self._settled >= SETTLE_S:
            self._settled = self._clock()
            self._writer.settle()

    def _attempt(self, write: Callable[[], None]) -> None:
        try:
            write()
        except TraceError as error:
            self.error = self.error or error
