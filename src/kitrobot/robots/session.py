"""The session with one real robot: its link, polling, reboot detection, and its state from what it sends.

Whoever shows, records or steers a robot subscribes to its session and gets each `Change`; nobody else reads its link.
A session has no thread: its owner calls `poll` again and again, and everything is called from that one thread. The
link may be lost and replaced; state and subscribers stay. Left to others: opening links (deploy), names (names), what a
recording holds (records, recording).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace

from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.news import Fault, News, Text
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.value_format import held_by_hand, set_by_hand
from kitrobot.robots.board_link import Link
from kitrobot.robots.faults import fault_event
from kitrobot.robots.names import BoardNames
from kitrobot.robots.recording_context import RecordingContext
from kitrobot.robots.state import Change, ChangeKind, RobotEvent, RobotState
from kitrobot.text.sentences import Recorded, Sentence
from kitrobot.trace.model import LINK, PERSON, PROGRAM, ROBOT

LOOK_S = 0.5
"""How often a robot's state is looked at; it is queried only while it does not report that itself."""

Subscriber = Callable[[Change], None]
_STOPPED = RobotEvent("outside", Recorded("it was stopped from here"), PERSON)


class NotConnectedError(KitRobotError):
    """There is no link to the robot, or it has another program."""


@dataclass(frozen=True)
class InstalledProgram:
    """What is known of the program on a robot: its names, and what recordings of it embed (None: of no mission)."""

    names: BoardNames
    recording_context: RecordingContext | None = None

    def first_values(self) -> dict[int, int]:
        """The cells of variables with their first values, as far as these are known."""
        if self.recording_context is None:
            return {}
        return {cell: self.recording_context.first[cell] for cell in self.names.variables.values()}


class RobotSession:
    """One robot. `state` is replaced as a whole with each change, and subscribers are called then."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.state = RobotState()
        self.known: InstalledProgram | None = None
        self.news: News | Fault | Text | None = None
        """What `poll` read last, None for nothing."""
        self._clock = clock
        self._link: Link | None = None
        self._subscribers: list[Subscriber] = []
        self._looked = 0.0
        self._period_ms = 0

    def subscribe(self, subscriber: Subscriber) -> None:
        """Calls the subscriber with each change from now on."""
        self._subscribers = [*self._subscribers, subscriber]

    def unsubscribe(self, subscriber: Subscriber) -> None:
        """Ends a subscription; this and `subscribe` may come from any thread."""
        self._subscribers = [one for one in self._subscribers if one != subscriber]

    # -- the link

    @property
    def is_open(self) -> bool:
        """Whether there is a link."""
        return self._link is not None

    @property
    def link(self) -> Link:
        """The link.

        Raises:
            NotConnectedError: there is none.
        """
        if self._link is None:
            raise NotConnectedError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return self._link

    def open(self, link: Link, hello: Hello, known: InstalledProgram | None) -> None:
        """Takes a link to a robot, with its greeting and what is known of its program."""
        was, self._link, self.known = self.state, link, known
        state = RobotState.from_hello(hello)
        self._looked = self._clock()
        self._period_ms = 0
        events = []
        if was.lost and state.installed == was.installed:
            events.append(RobotEvent("revival", Recorded("the link is back"), LINK))
        self._apply_state(state, was, events, ChangeKind.GREETED)

    def watch(self, period_ms: int) -> None:
        """Has it send what changes, at most so often, also after a reboot; 0 ends it."""
        self._period_ms = period_ms
        self.link.watch(period_ms)

    def lose(self, message: str) -> None:
        """The link broke; `message` describes that and what becomes of the robot."""
        self.close()
        state = replace(self.state, threads={}, lost=message)
        self._change(ChangeKind.LOST, state, RobotEvent("failure", message, LINK))

    def close(self) -> None:
        """Ends the link, if there is one; the robot goes on, unless it is held."""
        link, self._link = self._link, None
        if link is not None:
            with suppress(KitRobotError, OSError):
                link.close()

    # -- requests

    def start(self, held: bool = False) -> None:
        """Begins the program that it has. Held: it stops when it hears nothing from here."""
        self.link.start(held=held)
        first = self.known.first_values() if self.known is not None else {}
        event = RobotEvent("outside", Recorded("its program was started from here"), PERSON)
        self._change(ChangeKind.STARTED, self.state.after_start(held, first), event)

    def stop(self) -> None:
        """Stops it."""
        self.link.stop()
        self._change(ChangeKind.STOPPED, self.state.after_stop(), _STOPPED)

    def replaced(self) -> None:
        """Another program is being put on it, which stops it; nothing is known of it until it is opened again."""
        self._change(ChangeKind.STOPPED, self.state.after_stop(), _STOPPED)
        self.known = None
        self._change(ChangeKind.LOOKED, replace(self.state, fault=None))

    def force(self, sensor: str, value: int | None) -> None:
        """Holds a sensor at a value; None releases it.

        Raises:
            NoNameError: there is no such sensor.
            NotConnectedError: there is no link, or its program is not known.
        """
        names = self._names()
        self.link.force(names.input(sensor), value)
        forced = {name: held for name, held in self.state.forced.items() if name != sensor}
        if value is not None:
            forced[sensor] = value
        self._change(ChangeKind.FORCED, replace(self.state, forced=forced), held_event(names, sensor, value))

    def set_variable(self, variable: str, value: int) -> None:
        """Sets a variable.

        Raises:
            NoNameError: there is no such variable.
            NotConnectedError: there is no link, or its program is not known.
        """
        names = self._names()
        cell = names.variable(variable)
        self.link.set(cell, value)
        state = replace(self.state, cells={**self.state.cells, cell: value})
        event = RobotEvent("outside", set_by_hand(names.made_of, variable, value), PERSON)
        self._change(ChangeKind.SET, state, event)

    def _names(self) -> BoardNames:
        if self.known is None:
            raise NotConnectedError(
                Sentence("the robot has another program than the one that is open here"),
                Sentence("send this one first"),
            )
        return self.known.names

    # -- what it sends

    def poll(self, timeout_s: float) -> None:
        """Looks at its state when that is due, then waits for news at most so long; `news` is what came.

        Raises:
            KitRobotError: the link broke, or the robot refused.
        """
        self.news = None
        if self._clock() - self._looked >= LOOK_S:
            self._look()
        self.news = news = self.link.news(timeout_s)
        if news is None:
            self._change(ChangeKind.QUIET, self.state)
        elif isinstance(news, Text):
            self._change(ChangeKind.TEXT, self.state, RobotEvent("message", news.text.strip(), PROGRAM))
        elif isinstance(news, Fault):
            self._apply_fault(news, ChangeKind.FAULT)
        else:
            context = self.known.recording_context if self.known is not None else None
            calls = context.calls if context is not None else {}
            commands = tuple(calls[at] for at in sorted(news.ran) if at in calls)
            self._change(ChangeKind.NEWS, self.state.after_news(news), commands=commands)

    def _look(self) -> None:
        self._looked = self._clock()
        hello, was = self.link.look(), self.state
        now = was.after_look(hello)
        if now.doing == was.doing == "running" and now.tick < was.tick:
            self._handle_reboot()
        elif now != was or (now.doing == "fault" and now.fault is None):
            self._apply_state(now, was, [], ChangeKind.LOOKED)

    def _apply_state(self, now: RobotState, was: RobotState, events: list[RobotEvent], kind: ChangeKind) -> None:
        """Takes a state that was looked at; an end and a fault that were not reported are found then."""
        if now.doing == "ended" != was.doing:
            events.append(RobotEvent("end", Recorded("its program has ended"), PROGRAM))
        self._change(kind, now, *events)
        if now.doing == "fault" and now.fault is None:
            fault = self.link.last_fault()
            if fault is not None:
                self._apply_fault(fault, ChangeKind.FAULT)

    def _apply_fault(self, fault: Fault, kind: ChangeKind) -> None:
        if not fault.number or fault == self.state.fault:
            return
        event = fault_event(fault, self.known.names if self.known is not None else None)
        self._change(kind, self.state.after_fault(fault), event)

    def _handle_reboot(self) -> None:
        """It was without power for a moment, and runs by itself as it does when that comes back. One that is held is
        stopped; another one is watched again, which it has forgotten.
        """
        event = RobotEvent("message", Recorded("it began anew by itself"), ROBOT)
        if self.state.held:
            self.link.stop()
            self._change(ChangeKind.REBOOTED, self.state.after_reboot().after_stop(), event, _STOPPED)
            return
        if self._period_ms:
            self.link.watch(self._period_ms)
        self._change(ChangeKind.REBOOTED, self.state.after_reboot(), event)

    def _change(
        self,
        kind: ChangeKind,
        state: RobotState,
        *events: RobotEvent,
        commands: tuple[tuple[str, str, tuple[int, ...]], ...] = (),
    ) -> None:
        self.state = state
        change = Change(kind, state, events, commands)
        for subscriber in self._subscribers:
            subscriber(change)


def held_event(names: BoardNames, sensor: str, value: int | None) -> RobotEvent:
    """A sensor is held at a value from here; None: it measures again."""
    return RobotEvent("outside", held_by_hand(names.made_of, sensor, value), PERSON)
