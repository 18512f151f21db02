"""Several real robots as one run: the changes of their sessions at the ticks of one clock, as a `RunSource`.

The clock begins with the run, so several robots share one timeline, and silence takes its time. The robot's own count
of ticks stands beside its numbers. Robots send only what changed, a few times a second, so a record holds what was
heard last. Robots go on at their own pace: there is no way back, and no tick by tick.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Collection, Sequence
from functools import partial
from typing import NoReturn

from kitrobot.robots.records import RecordedBoard, active_of, first_row, header_of, row_of, sentence_of
from kitrobot.robots.session import RobotSession
from kitrobot.robots.state import Change, RobotState
from kitrobot.text import Recorded, Sentence
from kitrobot.trace import Ability, AbilityError, NewEvents, Threads, TickRecord, TraceCommand, TraceEvent, TraceHeader

LONGEST_TEXT = 500
MOST_EVENTS = 5000
"""Events that are kept; the oldest go first."""

Left = Callable[[TickRecord, int], None]
"""Is given the record of a tick that is over, and the tick that follows it: the numbers hold up to that."""


def _ignored(record: TickRecord, following: int) -> None:
    """Nobody wants to know."""


class RobotsRun:
    """A run of real robots. `sessions` are theirs, in the same order; without them nothing can be done to the run. Safe
    to use from many threads.

    Raises:
        NoRecordingError: they run programs of several missions.
    """

    def __init__(
        self,
        robots: Sequence[RecordedBoard],
        sessions: Sequence[RobotSession] = (),
        clock: Callable[[], float] = time.monotonic,
        left: Left = _ignored,
    ) -> None:
        self.lock = threading.RLock()
        """Guards the run; whoever reads more than one thing of it takes it."""
        self.header: TraceHeader = header_of(robots)
        self._robots = tuple(robots)
        self.abilities: frozenset[Ability] = frozenset({"force", "set"} if sessions else ())
        self._sessions = {robot.name: session for robot, session in zip(robots, sessions, strict=False)}
        self._clock = clock
        self._left = left
        self._states = [RobotState()] * len(robots)
        self._rows = [first_row(one) for one in robots]
        self._active: list[Threads] = [()] * len(robots)
        self._commands: list[TraceCommand] = []
        self._events: list[TraceEvent] = []
        """Of the tick that it stands at."""
        self._past: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self._untold: deque[TraceEvent] = deque(maxlen=MOST_EVENTS)
        self._wrong: dict[int, str] = {}
        """Why robots go on no more, the first one first."""
        self._tick = 0
        self._began = clock()
        for number, session in enumerate(sessions):
            session.subscribe(partial(self.robot_changed, number))

    def robot_changed(self, number: int, change: Change) -> None:
        """Takes a change of a robot, known by its place in the run; sessions that were given do this by themselves."""
        with self.lock:
            self.advance(0)
            robot, state = self._robots[number], change.state
            self._states[number] = state
            self._rows[number] = row_of(robot, state)
            self._active[number] = active_of(state)
            sentence = sentence_of(robot, state)
            if sentence:
                self._wrong[number] = sentence
            else:
                self._wrong.pop(number, None)
            self._commands += [TraceCommand(number, *command) for command in change.commands]
            happened = [
                TraceEvent(self._tick, event.kind, number, event.text[:LONGEST_TEXT], event.cause)
                for event in change.events
            ]
            self._events += happened
            self._past += happened
            self._untold += happened

    # -- where it stands

    @property
    def tick(self) -> int:
        """The tick of the clock that it was brought to last."""
        return self._tick

    @property
    def latest(self) -> int:
        """The same."""
        return self._tick

    @property
    def outcome(self) -> str | None:
        """How it ended, while no robot runs."""
        running = any(state.doing == "running" and not state.lost for state in self._states)
        return None if running else self.ending[0]

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self.ending[1] if self.outcome is not None else ""

    @property
    def ending(self) -> tuple[str, str]:
        """How it ended so far, though robots may run: "failed", "done" or "stopped", and a sentence."""
        if self._wrong:
            number, sentence = next(iter(self._wrong.items()))
            several = len(self._robots) > 1
            return "failed", Recorded(
                "{robot}: {sentence}", self._robots[number].name, sentence
            ) if several else sentence
        if all(state.doing == "ended" for state in self._states):
            return "done", Recorded("the program of each robot has ended")
        return "stopped", ""

    def record(self, in_full: Collection[int] | None = None) -> TickRecord:
        """What was heard last, with what happened in this tick."""
        with self.lock:
            numbers = [number for row in self._rows for number in row]
            return TickRecord(self._tick, [*numbers, 0], list(self._active), [*self._commands], [*self._events])

    def active(self) -> Sequence[Threads]:
        """Where the threads of each robot stand."""
        return list(self._active)

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events."""
        with self.lock:
            return list(self._past)[-most:]

    def new_events(self, most: int) -> NewEvents:
        """The events since this was called last."""
        with self.lock:
            happened = list(self._untold)[-most:]
            self._untold.clear()
            return NewEvents(False, happened)

    # -- going on

    def advance(self, ticks: int) -> int:
        """Goes to the tick of the clock, however many that are."""
        with self.lock:
            return self._go_to(int((self._clock() - self._began) * 1000 / self.header.tick_ms))

    def end_tick(self) -> None:
        """Goes to the tick of the clock and ends that one too: what comes next belongs to the following one."""
        with self.lock:
            self.advance(0)
            self._go_to(self._tick + 1)

    def _go_to(self, tick: int) -> int:
        gone = max(0, tick - self._tick)
        if gone:
            self._left(self.record(), tick)
            self._commands, self._events = [], []
            self._tick = tick
        return gone

    def seek(self, tick: int, stop: Callable[[], bool]) -> None:
        """Cannot be done."""
        self._refuse()

    def seek_back(self, wanted: Callable[[], bool], stop: Callable[[], bool]) -> None:
        """Cannot be done."""
        self._refuse()

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """As `RobotSession.force`; in the thread of the session."""
        self._session(agent).force(sensor, value)

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """As `RobotSession.set_variable`; in the thread of the session."""
        self._session(agent).set_variable(variable, value)

    def _session(self, agent: str) -> RobotSession:
        if agent not in self._sessions:
            raise AbilityError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return self._sessions[agent]

    def fail(self, agent: str, kind: str) -> None:
        """Cannot be done."""
        self._refuse()

    def _refuse(self) -> NoReturn:
        raise AbilityError(Sentence("these are real robots: that can only be done in the simulator"))

    def stop(self) -> None:
        """Stops every robot that there is a link to; in the thread of their sessions."""
        for session in self._sessions.values():
            if session.is_open:
                session.stop()

    def close(self) -> None:
        """Nothing is held: the sessions are their owners'."""
