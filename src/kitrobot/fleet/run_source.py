"""`FleetSource`: a fleet as a `RunSource`, whose trace is written while it goes on and whose past is read from that.

The thread of the team's process adds steps (`step`, `finish`); a viewer is at a tick of it, in another
thread, one at a time. What has happened cannot be changed; only the emergency stop reaches the fleet.
"""

from __future__ import annotations

import shutil
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from kitrobot.sim.recorder import STOPPED, Recorder, outcome_of
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence, Word
from kitrobot.trace.drawing import Drawing, DrawingReader
from kitrobot.trace.model import TickRecord, TraceError, TraceEvent, TraceHeader, TracePart
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.source import NewEvents, RecordingSource, UnchangeableSource, walk
from kitrobot.trace.writer import TraceWriter

MOST_RECENT_NUMBERS = 200_000
"""Numbers of the last records that are cached, so that following the run reads no file."""
MOST_EVENTS = 5000
"""Events that are cached; the oldest go first. The trace has all of them."""


class FleetSource(UnchangeableSource):
    """The run of a fleet.

    Args:
        simulation: the mission before its first step; afterwards only the thread of the team's process uses it.
        path: the file of its trace, in a folder that is the caller's.
        parts: XML files that the mission needs.
        stop: presses the emergency stop.

    Attributes:
        on_record: called with each record before it is kept, and how the run ended with it; None while it goes on. It
            may add events.

    Raises:
        TraceError: the file cannot be made.
    """

    refusal = (
        Sentence("each agent of this run is a process of its own: that can only be done in the simulator"),
        Sentence("press Run for that"),
    )

    def __init__(
        self, simulation: Simulation, path: Path, parts: Sequence[TracePart], stop: Callable[[], None]
    ) -> None:
        self._simulation = simulation
        self._recorder = Recorder(simulation, parts)
        self._stop = stop
        self.on_record: Callable[[TickRecord, str | None], None] = lambda record, outcome: None
        self._lock = threading.Lock()
        """Guards the file and what is newest."""
        self._path = path
        self._writer = TraceWriter(path, self._recorder.header)
        self._newest = self._now = self._recorder.record(())
        columns = len(self._newest.numbers)
        self._recent: deque[TickRecord] = deque([self._newest], max(32, MOST_RECENT_NUMBERS // columns))
        self._written = False
        self._ended: tuple[str, str] | None = None
        self._broken: TraceError | None = None
        self._events: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self._unsent: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self._past: RecordingSource | None = None
        self._drawn = DrawingReader(self._recorder.header)

    # -- the thread of the team's process

    def step(self) -> None:
        """Records the run after a step, and before the first."""
        record = self._recorder.record()
        if self._written and record.tick <= self._newest.tick:
            return
        self.on_record(record, self._simulation.outcome)
        with self._lock:
            self._newest, self._written = record, True
            if record.tick == 0:
                self._now = record
                self._recent.clear()
            self._recent.append(record)
            if record.tick > self._drawn.tick:
                self._drawn.take(record)
            self._events += record.events
            self._unsent += record.events
            self._write(lambda: self._writer.record(record))

    def finish(self, outcome: str, sentence: str) -> None:
        """The run is over."""
        with self._lock:
            if not self._written:
                self._written = True
                self._write(lambda: self._writer.record(self._newest))
            self._ended = outcome, sentence
            self._writer.finish(self._outcome())
            self._write(self._writer.close)

    def _write(self, write: Callable[[], None]) -> None:
        """A disk that is full ends the recording, and not the run."""
        try:
            if self._broken is None:
                write()
        except TraceError as error:
            self._broken = error

    def _outcome(self) -> dict[str, Any]:
        outcome, sentence = self._ended or (STOPPED, "")
        return {**outcome_of(self._simulation), "outcome": outcome, "sentence": sentence}

    # -- where it stands

    @property
    def header(self) -> TraceHeader:
        """As it is recorded."""
        return self._recorder.header

    @property
    def latest(self) -> int:
        """The tick of the last step."""
        return self._newest.tick

    @property
    def drawing(self) -> Drawing:
        """What pens drew up to the last step."""
        return self._drawn.drawing

    @property
    def has_ended(self) -> bool:
        """Whether the run is over, whatever the current tick is."""
        return self._ended is not None

    @property
    def outcome(self) -> str | None:
        """How it ended, if the current tick is the last."""
        return self._ended[0] if self._ended is not None and self._now is self._newest else None

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self._ended[1] if self._ended is not None and self.outcome is not None else ""

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events."""
        with self._lock:
            return list(self._events)[-most:]

    def new_events(self, most: int) -> NewEvents:
        """The events since this was called last."""
        with self._lock:
            happened = list(self._unsent)[-most:]
            self._unsent.clear()
            return NewEvents(False, happened)

    # -- going on and back

    def advance(self, ticks: int) -> int:
        """Goes on by up to so many ticks, but not beyond the last step."""
        before = self.tick
        goal = min(before + ticks, self._newest.tick)
        if goal > before:
            self._now = self._at_hand(goal) or self._next(goal)
        return self.tick - before

    def _next(self, tick: int) -> TickRecord:
        """Where going on to that tick leads; to the last step, where no more could be recorded."""
        past = self._recorded(tick)
        past.advance(tick - past.tick)
        return past.record() if past.tick > self.tick else self._newest

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick up to that of the last step."""
        found = self._at_hand(min(tick, self._newest.tick))
        if found is None:
            past = self._recorded(tick)
            yield from past.seek(tick)
            found = past.record()
        self._now = found

    def _at_hand(self, tick: int) -> TickRecord | None:
        """The record of a tick that is not long ago."""
        with self._lock:
            at = tick - self._recent[0].tick
            found = self._recent[at] if 0 <= at < len(self._recent) else None
        return found if found is not None and found.tick == tick else None

    def seek_back(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """As `RunSource.seek_back`."""
        past = self._recorded(self.tick)

        def here() -> bool:
            self._now = past.record()
            return wanted()

        yield from past.seek_back(here)
        self._now = past.record()

    def _recorded(self, tick: int) -> RecordingSource:
        """What is recorded so far, at the current tick; with this tick, where that could be written."""
        if self._past is None or self._past.latest < tick:
            with self._lock:
                if self._ended is None:
                    self._write(self._writer.settle)
            self._close_past()
            self._past = RecordingSource(TraceReader(self._path))
        if self._past.tick != self.tick:
            walk(self._past.seek(self.tick))
        return self._past

    # -- from outside

    def stop(self) -> None:
        """The emergency stop."""
        self._stop()

    def record_to(self, path: Path) -> None:
        """Writes what was recorded so far into another file, whole; the recording goes on.

        Raises:
            TraceError: it cannot be written there, or could not be recorded.
        """
        with self._lock:
            if self._ended is None:
                self._write(self._writer.settle)
            if self._broken is not None:
                raise self._broken
            try:
                shutil.copyfile(self._path, path)
                if self._ended is None:
                    TraceWriter.end(path, self._outcome())
            except OSError as error:
                raise TraceError(Sentence("the recording cannot be saved: {reason}", Word(error.strerror))) from error

    def close(self) -> None:
        """Nobody looks at it any more: the emergency stop."""
        self._stop()
        self._close_past()

    def _close_past(self) -> None:
        past, self._past = self._past, None
        if past is not None:
            past.close()
