"""Where a run comes from, as everybody sees it who shows, records or steers it: a simulation, a recording, real
robots, a team of processes.

A source stands at one tick of its run. `record` is the run there, `advance` and `seek` move it as far as its
`abilities` allow. Sources: `sim.SimulationSource`, `RecordingSource`, `robots.RobotsRun`,
`fleet.FleetSource`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from typing import ClassVar, Literal, NamedTuple, NoReturn, Protocol

from kitrobot.text.sentences import Recorded, Sentence
from kitrobot.trace.drawing import Drawing, DrawingReader
from kitrobot.trace.model import Threads, TickRecord, TraceError, TraceEvent, TraceHeader
from kitrobot.trace.reader import TraceReader, kept

Ability = Literal["force", "set", "seek", "fail", "step"]
"""What can be done to a run: force a sensor, set a variable, go to another tick, let an agent fail, go on tick by tick
instead of at the run's own pace.
"""

ENDED = ("done", "failed", "stuck", "time")
"""Outcomes of runs that came to their end; other recordings just end."""


class NewEvents(NamedTuple):
    """What happened since the last call; with `again` everything up to the latest tick: the past is another."""

    again: bool
    events: Sequence[TraceEvent]


class AbilityError(TraceError):
    """Something that cannot be done to a run."""


def walk(way: Iterator[None]) -> None:
    """Goes a way of a source (`RunSource.seek`) to its end."""
    for _ in way:
        pass


class RunSource(Protocol):
    """A run. What is not among its `abilities` raises an `AbilityError`."""

    @property
    def header(self) -> TraceHeader:
        """What holds for the whole run."""

    @property
    def abilities(self) -> frozenset[Ability]:
        """What can be done to it."""

    @property
    def tick(self) -> int:
        """The tick that it stands at."""

    @property
    def latest(self) -> int:
        """The furthest tick that is known of it."""

    @property
    def outcome(self) -> str | None:
        """How the run ended, if it stands at its end."""

    @property
    def sentence(self) -> str:
        """Why it ended."""

    @property
    def drawing(self) -> Drawing:
        """What pens drew, at least up to the tick that it stands at."""

    def record(self, in_full: Collection[int] | None = None) -> TickRecord:
        """The run as it stands. `in_full`: the agents of which more than the pose is wanted; None: all."""

    def active(self) -> Sequence[Threads]:
        """Where the threads of each agent stand."""

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events up to the latest tick."""

    def new_events(self, most: int) -> NewEvents:
        """The events since this was called last."""

    def advance(self, ticks: int) -> int:
        """Goes on by up to so many ticks; by how many it did, 0 at the end."""

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick up to the latest, in short pieces: each that is taken goes on."""

    def seek_back(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """The way back to the last tick before this one at which `wanted` says yes, or to the first; as `seek`."""

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures; None gives it back."""

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Sets a variable."""

    def fail(self, agent: str, kind: str) -> None:
        """Lets an agent fail, stall or lose its radio, or makes it well again."""

    def stop(self) -> None:
        """Stops every motor; the run is not gone on with."""

    def close(self) -> None:
        """Releases what it holds."""


class UnchangeableSource:
    """What sources have in common that stand at a record, and in whose run nothing can be changed.

    `refusal`: why not, and what can be done instead.
    """

    abilities: frozenset[Ability] = frozenset({"seek", "step"})
    refusal: ClassVar[tuple[Sentence, Sentence]]
    _now: TickRecord

    @property
    def tick(self) -> int:
        """The tick that it stands at."""
        return self._now.tick

    def record(self, in_full: Collection[int] | None = None) -> TickRecord:
        """The record of the tick that it stands at, whole."""
        return self._now

    def active(self) -> Sequence[Threads]:
        """Where the threads of each agent stand."""
        return self._now.active

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Cannot be done."""
        self._refuse()

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Cannot be done."""
        self._refuse()

    def fail(self, agent: str, kind: str) -> None:
        """Cannot be done."""
        self._refuse()

    def _refuse(self) -> NoReturn:
        raise AbilityError(*self.refusal)


class RecordingSource(UnchangeableSource):
    """A recording: all of it has happened, and nothing can be done to it. It closes the file when it is closed.

    Raises:
        TraceError: the recording is damaged.
    """

    refusal = (
        Sentence("this is a recording: what happened cannot be changed"),
        Sentence("run its mission, and do it in that run"),
    )

    def __init__(self, reader: TraceReader) -> None:
        self.reader = reader
        self._first = self._now = reader.seek(0)
        self._ahead: Iterator[TickRecord] | None = None
        self._again = True
        self._drawn = DrawingReader(reader.header)

    @property
    def header(self) -> TraceHeader:
        """As recorded."""
        return self.reader.header

    @property
    def latest(self) -> int:
        """Its last tick: the timeline is known to its end from the first moment."""
        return self.reader.last_tick

    @property
    def outcome(self) -> str | None:
        """At its last tick: how the run ended, or "end" when the run was not over yet."""
        if self.tick < self.latest:
            return None
        outcome = self.reader.outcome.get("outcome")
        return outcome if outcome in ENDED else "end"

    @property
    def sentence(self) -> str:
        """Why it ended."""
        outcome, sentence = self.outcome, self.reader.outcome.get("sentence")
        if outcome is None:
            return ""
        if outcome != "end" and isinstance(sentence, str):
            return Recorded(sentence[:1000])
        if self.reader.cut:
            return Sentence("the recording ends here: its file was cut off")
        return Sentence("the recording ends here; the run was still on")

    @property
    def drawing(self) -> Drawing:
        """What pens drew up to the tick that it stands at, or further, where it was further before."""
        drawn = self._drawn
        if drawn.has_pens and drawn.tick < self.tick:
            for record in self.reader.walk(drawn.tick + 1):
                if record.tick > self.tick:
                    break
                drawn.take(record)
        return drawn.drawing

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events of the recording."""
        return [event for _, event in self.reader.events[-most:]]

    def new_events(self, most: int) -> NewEvents:
        """All events the first time, then none."""
        again, self._again = self._again, False
        return NewEvents(again, self.events(most) if again else ())

    def advance(self, ticks: int) -> int:
        """Goes on by up to so many ticks; further where the recording has none for a while."""
        began = self.tick
        goal = min(began + ticks, self.latest)
        if self._ahead is None:
            self._ahead = self.reader.walk(began + 1)
        while self.tick < goal and (record := next(self._ahead, None)) is not None:
            self._now = record
        self._now = kept(self._now)
        if self.tick >= self.latest:
            self._ahead = None
        return self.tick - began

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick: one piece."""
        self._show_record(self.reader.seek(tick))
        yield

    def seek_back(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """As `RunSource.seek_back`."""
        for record in self.reader.walk_back(self._now.tick):
            self._show_record(record)
            if wanted():
                return
            yield
        self._show_record(self._first)

    def _show_record(self, record: TickRecord) -> None:
        self._now = record
        self._ahead = None

    def stop(self) -> None:
        """There are no motors."""

    def close(self) -> None:
        """Closes the file."""
        self.reader.close()
