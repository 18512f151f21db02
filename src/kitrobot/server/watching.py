"""A run as the page sees it: frames of poses, and messages of what changed since the last one.

What the page is told comes from records as a trace holds them (telling). Events are collected over all the ticks
between two messages.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from kitrobot.diagnostics import Diagnostic
from kitrobot.mission import Breakpoint, Mission
from kitrobot.server.shapes import StartedMessage
from kitrobot.server.telling import MOST_EVENTS_TOLD, Teller
from kitrobot.sim import Event, Recorder, Simulation, record_again
from kitrobot.sim.breakpoints import Breakpoints, Hit
from kitrobot.sim.timeline import Timeline
from kitrobot.trace import TickRecord
from kitrobot.workspace import OpenMission, advice, once_more, parts_of

_TICKS_BETWEEN_LOOKS = 8
"""Ticks run between two looks at the clock; fewer of very many robots, so that Stop is obeyed soon."""
_ROBOT_TICKS_BETWEEN_LOOKS = 4000


class Watch:
    """Watches one simulation of a mission, and takes it back and on.

    Raises:
        ConditionError: the condition of a breakpoint cannot be understood.
    """

    def __init__(self, opened: OpenMission, simulation: Simulation) -> None:
        simulation.watch_programs()
        self._simulation = simulation
        self._timeline = Timeline(simulation)
        self._debug = {name: compiled.debug for name, compiled in opened.compiled.items()}
        self._opened = opened
        self._recorder = Recorder(simulation)
        self._teller = Teller(self._recorder.header)
        self._events: list[Event] = []
        self._early: list[Event] = []
        """What was done by hand and told at once, before the step that tells it."""
        self._again = False
        self._breakpoints = self._armed(opened.mission.breakpoints)
        self._portion = max(1, min(_TICKS_BETWEEN_LOOKS, _ROBOT_TICKS_BETWEEN_LOOKS // len(simulation.members)))
        self.hits: list[Hit] = []
        """Why `advance` came to an end before its time: who came to a breakpoint."""

    @property
    def mission(self) -> Mission:
        """What runs."""
        return self._opened.mission

    @property
    def tick(self) -> int:
        """The tick that the run stands at."""
        return self._simulation.tick

    @property
    def tick_s(self) -> float:
        """Simulated seconds a tick."""
        return self._simulation.tick_ms / 1000

    @property
    def seconds(self) -> float:
        """Simulated time."""
        return self._simulation.seconds

    @property
    def outcome(self) -> str | None:
        """How the run ended, if it stands at its end."""
        return self._simulation.outcome

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self._simulation.sentence

    @property
    def advice(self) -> list[Diagnostic]:
        """Hints on a run that ended before anything could be seen."""
        return advice(self._opened, self._simulation)

    # -- going on and back

    def advance(self, most: int | None, until: float, clock: Callable[[], float]) -> None:
        """Runs ticks: at most `most` (None: as many as there is time for), none begun long after `until`, and none
        after one in which somebody comes to a breakpoint.
        """
        simulation, run = self._simulation, 0
        self.hits = []
        while simulation.outcome is None and not self.hits and (most is None or run < most):
            portion = self._portion if most is None else min(self._portion, most - run)
            run += self._advance(1 if self._breakpoints else portion)
            if (not self._breakpoints or run % self._portion == 0) and clock() >= until:
                return

    def _advance(self, ticks: int) -> int:
        before = self._timeline.latest
        done = self._timeline.advance(ticks)
        happened = self._simulation.events
        self._events += [one for one in happened if one.tick >= before and one not in self._early]
        self._early = []
        if self._breakpoints:
            self.hits = self._breakpoints.after_step(self.tick)
        return done

    def seek(self, tick: int, stop: Callable[[], bool]) -> None:
        """Goes to a tick that was run already."""
        self._timeline.go_to(tick, stop)
        self._breakpoints.went_to(self.tick)
        self.hits = []

    def step(self, agent: str, stop: Callable[[], bool]) -> None:
        """Runs ticks until the agent ("" for anybody) stands at another vertex, or somebody comes to a breakpoint."""
        before = self._standing(agent)
        self.hits = []
        while self._simulation.outcome is None and not self.hits and not stop():
            self._advance(1)
            if self._standing(agent) != before:
                return

    def step_back(self, agent: str, stop: Callable[[], bool]) -> None:
        """Goes back to the last tick at which the agent ("" for anybody) stood at another vertex."""
        before = self._standing(agent)
        self._timeline.go_back_to(lambda: self._standing(agent) != before, stop)
        self._breakpoints.went_to(self.tick)
        self.hits = []

    def _standing(self, agent: str) -> list[tuple[str, tuple[str | None, ...]]]:
        """Where the agent stands, or everybody."""
        members = self._simulation.members
        return [
            (one.name, tuple(self._debug[one.program].vertex(instruction) for _, instruction in one.active))
            for one in members
            if agent in ("", one.name)
        ]

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures; None gives it back.

        Raises:
            KitRobotError: there is no such agent or sensor.
        """
        self._timeline.force(agent, sensor, value)
        self._again = True

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Sets a variable.

        Raises:
            KitRobotError: there is no such agent or variable.
        """
        self._timeline.set_variable(agent, variable, value)
        self._again = True

    def harm(self, agent: str, kind: str) -> None:
        """Lets an agent fail, stall or lose its radio, or makes it well again.

        Raises:
            KitRobotError: there is no such agent, or too much was done at once.
        """
        if self._timeline.harm(agent, kind):
            self._again = True
            self._early = self._simulation.untold

    def look_at(self, agents: Iterable[str]) -> None:
        """As `Teller.look_at`."""
        self._teller.look_at(agents)

    def stop(self) -> None:
        """Stops every motor; the run is not gone on with."""
        self._simulation.stop_motors()

    def pause_at(self, breakpoints: Iterable[Breakpoint]) -> None:
        """These are the breakpoints from now on; visits are counted anew.

        Raises:
            ConditionError: a condition cannot be understood.
        """
        self._breakpoints = self._armed(breakpoints)
        self._breakpoints.went_to(self.tick)

    def _armed(self, breakpoints: Iterable[Breakpoint]) -> Breakpoints:
        return Breakpoints(breakpoints, self._simulation.members, self._recorder.header.vertices)

    # -- telling

    def started(self, run: str) -> StartedMessage:
        """The first message."""
        return self._teller.started(run, self._simulation.world, self._record(), recording=False)

    def tell(self) -> tuple[bytes, dict[str, Any]]:
        """All poses, as `Teller.frame` gives them, and what changed since the last time, in the shape of a
        `TickMessage`.
        """
        again, self._again = self._again, False
        happened = [*self._timeline.events[-MOST_EVENTS_TOLD:], *self._early] if again else self._events
        self._events = []
        record = self._record(happened)
        news = self._teller.news(record, self._timeline.latest, again, record.events)
        return self._teller.frame(record), news

    def tell_whole(self) -> tuple[bytes, dict[str, Any]]:
        """All poses and everything that `tell` has told so far, for somebody who joins now."""
        record = self._record([*self._timeline.events[-MOST_EVENTS_TOLD:], *self._early])
        return self._teller.frame(record), self._teller.whole(record, self._timeline.latest, record.events)

    def _record(self, happened: Iterable[Event] = ()) -> TickRecord:
        """The run as it stands, as a trace would hold it."""
        return self._recorder.record(happened, self._teller.reported)

    # -- keeping

    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """Records the whole past of this run. It may go on meanwhile, in another thread.

        Raises:
            TraceError: the trace cannot be written.
        """
        was, opened = self._simulation, self._opened
        record_again(self._timeline, once_more(opened, was), path, parts_of(opened), stop)

    def close(self) -> None:
        """Nothing is held."""
