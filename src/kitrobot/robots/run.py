"""Several real robots as one run: the changes of their sessions at the ticks of one clock, as a `RunSource`.

The clock begins with the run, so several robots share one timeline, and silence takes its time. The robot's own count
of ticks is beside its numbers. Robots send only what changed, a few times a second, so a record holds what was
heard last. News that comes from one robot twice within a tick, as when it was held up on its way, is of two ticks, so
that no place of a thread is lost. Robots go on at their own pace, whatever the run shows: with sessions,
what was heard is stored, and the run can show a moment of it. When a robot is started while none runs, the run
begins anew.
"""

from __future__ import annotations

import threading
import time
from bisect import bisect_left, bisect_right
from collections import deque
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple, Protocol

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.model import LARGEST_VALUE
from kitrobot.robots.records import RecordedBoard, active_of, first_row, header_of, row_of, sentence_of
from kitrobot.robots.session import RobotSession
from kitrobot.robots.state import Change, ChangeKind, RobotState
from kitrobot.text.sentences import Recorded, Sentence, clipped
from kitrobot.trace.drawing import Drawing
from kitrobot.trace.model import Threads, TickRecord, TraceCommand, TraceEvent, TraceHeader
from kitrobot.trace.source import Ability, AbilityError, NewEvents

LONGEST_TEXT = 500
MOST_EVENTS = 5000
"""Events that are stored; the oldest go first."""
MOST_MOMENTS = 50_000
"""Moments that are stored, about half a kilobyte each; the oldest go first. One robot has ten of them a second."""

TickListener = Callable[[TickRecord, int], None]
"""Called with the record of a tick that is over, and the tick that follows it: the numbers hold up to that."""


def _ignored(record: TickRecord, following: int) -> None:
    """Does nothing."""


class RobotControl(Protocol):
    """The control of a robot: a `RobotSession` in its own thread, or what passes requests on to that thread."""

    def force(self, sensor: str, value: int | None) -> None: ...

    def set_variable(self, variable: str, value: int) -> None: ...

    def stop(self) -> None: ...


class _Moment(NamedTuple):
    """All robots as they stand at a tick and until the next moment."""

    tick: int
    rows: tuple[list[int], ...]
    active: tuple[Threads, ...]
    commands: list[TraceCommand]
    events: list[TraceEvent]

    def record(self, tick: int) -> TickRecord:
        """As the record of a tick."""
        happened = tick == self.tick
        return TickRecord(
            tick,
            [*(number for row in self.rows for number in row), 0],
            list(self.active),
            [*self.commands] if happened else [],
            [*self.events] if happened else [],
        )


def _tick_of(moment: _Moment) -> int:
    return moment.tick


class RobotsRun:
    """A run of real robots. `sessions` are theirs, in the same order, and `controls` take their requests (the
    sessions, where nothing is given); without them nothing can be done to the run. Safe to use from many threads.
    """

    def __init__(
        self,
        robots: Sequence[RecordedBoard],
        sessions: Sequence[RobotSession] = (),
        clock: Callable[[], float] = time.monotonic,
        on_tick: TickListener = _ignored,
        controls: Sequence[RobotControl] = (),
    ) -> None:
        self.lock = threading.RLock()
        """Guards the run; whoever reads more than one thing of it takes it."""
        self.header: TraceHeader = header_of(robots)
        self._robots = tuple(robots)
        self.abilities: frozenset[Ability] = frozenset({"force", "set", "seek", "step"} if sessions else ())
        self._controls = {
            robot.name: (robot, session, through)
            for robot, session, through in zip(robots, sessions, controls or sessions, strict=False)
        }
        self._clock = clock
        self._drawing = Drawing()
        self._on_tick = on_tick
        self._states = [RobotState()] * len(robots)
        self._rows = [first_row(one) for one in robots]
        self._active: list[Threads] = [()] * len(robots)
        self._past: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self._unsent: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self.beginnings = 0
        """How often it began anew, the first time included."""
        self._failures: dict[int, str] = {}
        """Why robots go on no more, the first one first."""
        self._begin()
        self._has_restarted = False
        self._subscribed = [(one, partial(self._heard, number)) for number, one in enumerate(sessions)]
        with self.lock:
            for session, heard in self._subscribed:
                session.subscribe(heard)
                heard(Change(ChangeKind.LOOKED, session.state))

    def _begin(self) -> None:
        self.beginnings += 1
        self._began = self._clock()
        self._tick = self._at = 0
        """The newest tick, and the tick that is shown."""
        self._commands: list[TraceCommand] = []
        self._events: list[TraceEvent] = []
        self._updated: set[int] = set()
        """Of the newest tick; the robots that sent news or were started in it."""
        self._history: list[_Moment] = []
        self._past.clear()
        self._unsent.clear()
        self._has_restarted = True

    def _heard(self, number: int, change: Change) -> None:
        """Takes a change from a session. A robot that has another program meanwhile is idle in this run."""
        with self.lock:
            was, state = self._states[number], change.state
            if change.kind is ChangeKind.QUIET:
                return
            if was.installed not in ("", state.installed):
                change = Change(change.kind, replace(was, doing="ready", threads={}, fault=None, lost=""))
            elif change.kind is ChangeKind.STARTED and not self._is_running():
                self._begin()
            if self._is_running() or any(one.lost for one in self._states):
                self._advance_to_now()
            self._take(number, change)

    def robot_changed(self, number: int, change: Change) -> None:
        """Takes a change of a robot, known by its place in the run; sessions that were given do this by themselves."""
        with self.lock:
            self._advance_to_now()
            self._take(number, change)

    def _take(self, number: int, change: Change) -> None:
        robot, state = self._robots[number], change.state
        if change.kind in (ChangeKind.NEWS, ChangeKind.STARTED):
            if number in self._updated:
                self._advance_to(self._tick + 1)
            self._updated.add(number)
        self._states[number] = state
        self._rows[number] = row_of(robot, state)
        self._active[number] = active_of(state)
        sentence = sentence_of(robot, state)
        if sentence:
            self._failures[number] = sentence
        else:
            self._failures.pop(number, None)
        self._commands += [TraceCommand(number, *command) for command in change.commands]
        happened = [
            TraceEvent(self._tick, event.kind, number, clipped(event.text, LONGEST_TEXT), event.cause)
            for event in change.events
        ]
        self._events += happened
        self._past += happened
        self._unsent += happened

    # -- where it stands

    @property
    def tick(self) -> int:
        """The tick that is shown."""
        return self._at

    @property
    def drawing(self) -> Drawing:
        """Nothing: nobody knows where a real robot is."""
        return self._drawing

    @property
    def latest(self) -> int:
        """The tick of the clock, while a robot runs."""
        with self.lock:
            self._catch_up()
            return self._tick

    @property
    def outcome(self) -> str | None:
        """How it ended, while no robot runs."""
        return None if self._at < self._tick or self._is_running() else self.ending[0]

    def _is_running(self) -> bool:
        return any(state.doing == "running" and not state.lost for state in self._states)

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self.ending[1] if self.outcome is not None else ""

    @property
    def ending(self) -> tuple[str, str]:
        """How it ended so far, though robots may run: "failed", "done" or "stopped", and a sentence."""
        if self._failures:
            number, sentence = next(iter(self._failures.items()))
            several = len(self._robots) > 1
            return "failed", Recorded(
                "{robot}: {sentence}", self._robots[number].name, sentence
            ) if several else sentence
        if all(state.doing == "ended" for state in self._states):
            return "done", Recorded("the program of each robot has ended")
        return "stopped", ""

    def _present(self) -> _Moment:
        return _Moment(self._tick, tuple(self._rows), tuple(self._active), self._commands, self._events)

    def _moment(self) -> _Moment:
        if self._at >= self._tick or not self._history:
            return self._present()
        return self._history[max(0, bisect_right(self._history, self._at, key=_tick_of) - 1)]

    def record(self, in_full: Collection[int] | None = None) -> TickRecord:
        """What was heard last up to the shown tick, with what happened in that tick."""
        with self.lock:
            return self._moment().record(self._at)

    def records(self) -> list[TickRecord]:
        """All stored moments of its past, and the present."""
        with self.lock:
            return [one.record(one.tick) for one in (*self._history, self._present())]

    def active(self) -> Sequence[Threads]:
        """Where the threads of each robot stand."""
        with self.lock:
            return self._moment().active

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events."""
        with self.lock:
            return list(self._past)[-most:]

    def new_events(self, most: int) -> NewEvents:
        """The events since this was called last; all of them when the run began anew."""
        with self.lock:
            again, self._has_restarted = self._has_restarted, False
            happened = list(self._unsent)[-most:]
            self._unsent.clear()
            return NewEvents(again, happened)

    # -- going on and back

    def advance(self, ticks: int) -> int:
        """Goes on by up to so many ticks, but not beyond the clock's."""
        with self.lock:
            self._catch_up()
            before, self._at = self._at, min(self._at + ticks, self._tick)
            return self._at - before

    def end_tick(self) -> None:
        """Goes to the tick of the clock and ends that one too: what comes next belongs to the following one."""
        with self.lock:
            self._advance_to_now()
            self._advance_to(self._tick + 1)

    def _catch_up(self) -> None:
        """Goes to the tick of the clock, while a robot runs. Silence is over when something is heard."""
        if self._is_running():
            self._advance_to_now()

    def _advance_to_now(self) -> None:
        self._advance_to(int((self._clock() - self._began) * 1000 / self.header.tick_ms))

    def _advance_to(self, tick: int) -> None:
        if tick <= self._tick:
            return
        now = self._present()
        self._on_tick(now.record(self._tick), tick)
        if not self._controls:
            self._at = tick
        elif not self._history or now.commands or now.events or self._history[-1][1:3] != now[1:3]:
            self._history.append(now)
            if len(self._history) > MOST_MOMENTS:
                del self._history[: MOST_MOMENTS // 10]
        self._commands, self._events = [], []
        self._updated.clear()
        self._tick = tick

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick up to the latest, or to the first one that is stored: one piece."""
        with self.lock:
            first = self._history[0].tick if self._history else self._tick
            self._at = min(max(tick, first), self._tick)
        yield

    def seek_back(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """As `RunSource.seek_back`."""
        with self.lock:
            end = self._at
            earlier = self._history[: bisect_left(self._history, end, key=_tick_of)]
        for moment in reversed(earlier):
            with self.lock:
                self._at, end = end - 1, moment.tick
                if wanted():
                    return
            yield
        yield from self.seek(0)

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """As `RobotSession.force`; the control decides in which thread.

        Raises:
            KitRobotError: there is no such robot or sensor, or the value is none for a robot.
        """
        robot, _, through = self._control_of(agent, value)
        robot.names.input(sensor)
        through.force(sensor, value)

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """As `RobotSession.set_variable`; the control decides in which thread.

        Raises:
            KitRobotError: there is no such robot or variable, or the value is none for a robot.
        """
        robot, _, through = self._control_of(agent, value)
        robot.names.variable(variable)
        through.set_variable(variable, value)

    def _control_of(self, agent: str, value: int | None) -> tuple[RecordedBoard, RobotSession, RobotControl]:
        if agent not in self._controls:
            raise AbilityError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        if value is not None and abs(value) > LARGEST_VALUE:
            raise KitRobotError(
                Sentence("a robot has no room for the number {value}", value),
                Sentence("the largest one is {largest}", LARGEST_VALUE),
            )
        return self._controls[agent]

    def fail(self, agent: str, kind: str) -> None:
        """Cannot be done."""
        raise AbilityError(Sentence("these are real robots: that can only be done in the simulator"))

    def stop(self) -> None:
        """Stops every robot that there is a link to."""
        for _, session, through in self._controls.values():
            if session.is_open:
                through.stop()

    def close(self) -> None:
        """Hears nothing any more; the sessions are their owners'."""
        for session, heard in self._subscribed:
            session.unsubscribe(heard)
