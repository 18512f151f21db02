"""A recording as the page sees it: steered and told like a run that is on, from the records of its file.

It has what `Watch` has, so a session drives the one as the other. All of it has happened: the timeline is known to its
end from the first moment, and nothing can be done to it. It pauses at breakpoints as far as the records show who came
where (recorded_agents).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NoReturn

from kitrobot.diagnostics import Diagnostic, KitRobotError
from kitrobot.mission import Breakpoint
from kitrobot.server.recorded_agents import recorded_agents, testable
from kitrobot.server.shapes import StartedMessage
from kitrobot.server.telling import MOST_EVENTS_TOLD, Teller
from kitrobot.sim.breakpoints import Breakpoints, Hit
from kitrobot.trace import TickRecord, TraceEvent
from kitrobot.trace.reading import kept
from kitrobot.workspace import OpenMission, OpenTrace

ENDED = ("done", "failed", "stuck", "time")
"""Outcomes of runs that came to their end; other recordings just end."""
_RECORDS_BETWEEN_LOOKS = 8


class PlayingError(KitRobotError):
    """Something that cannot be done to a recording."""


class Player:
    """Plays one recording. It closes the file when it is closed. `opened` is its mission with its robots, which
    breakpoints need.

    Raises:
        TraceError: the recording is damaged.
    """

    def __init__(self, trace: OpenTrace, opened: OpenMission | None = None) -> None:
        self._trace = trace
        self._robots = {} if opened is None else opened.catalogue.robots
        self._reader = trace.reader
        self._tick_ms = trace.reader.header.tick_ms
        self._teller = Teller(trace.reader.header)
        self._first = self._now = self._reader.seek(0)
        self._ahead: Iterator[TickRecord] | None = None
        self._again = True
        programs = {} if opened is None else opened.compiled
        self._agents = recorded_agents(trace.reader.header, self._robots, programs)
        self._breakpoints = Breakpoints([], [], {})
        self.hits: list[Hit] = []
        """Why it stands before its time: who came to a breakpoint."""

    @property
    def path(self) -> Path:
        """Its file."""
        return self._reader.path

    @property
    def mission(self) -> None:
        """Not known here: what is open where it is played came with it."""
        return None

    # -- where it stands

    @property
    def tick(self) -> int:
        """The tick that it stands at."""
        return self._now.tick

    @property
    def tick_s(self) -> float:
        """Simulated seconds a tick."""
        return self._tick_ms / 1000

    @property
    def seconds(self) -> float:
        """Simulated time."""
        return self.tick * self._tick_ms / 1000

    @property
    def outcome(self) -> str | None:
        """At its last tick: how the run ended, or "end" when the run was not over yet."""
        if self.tick < self._reader.last_tick:
            return None
        outcome = self._reader.outcome.get("outcome")
        return outcome if outcome in ENDED else "end"

    @property
    def sentence(self) -> str:
        """Why it ended."""
        outcome, sentence = self.outcome, self._reader.outcome.get("sentence")
        if outcome is None:
            return ""
        if outcome != "end" and isinstance(sentence, str):
            return sentence[:1000]
        if self._reader.cut:
            return "the recording ends here: its file was cut off"
        return "the recording ends here; the run was still on"

    @property
    def advice(self) -> list[Diagnostic]:
        """None: a recording stays as it is."""
        return []

    # -- going on and back

    def advance(self, most: int | None, until: float, clock: Callable[[], float]) -> None:
        """Goes on by at most `most` ticks (None: as many as there is time for), not long after `until`, and not beyond
        one in which somebody comes to a breakpoint.
        """
        self.hits = []
        goal = self._reader.last_tick if most is None else min(self.tick + most, self._reader.last_tick)
        read = 0
        while self.tick < goal and self._next():
            read += 1
            if self.hits:
                break
            if read % _RECORDS_BETWEEN_LOOKS == 0 and clock() >= until:
                break
        self._now = kept(self._now)
        self._ahead = None if self.tick >= self._reader.last_tick else self._ahead

    def _next(self) -> bool:
        """Goes to the next record; False when there is none."""
        if self._ahead is None:
            self._ahead = self._reader.walk(self.tick + 1)
        record = next(self._ahead, None)
        if record is None:
            return False
        self._now = record
        if self._breakpoints:
            self._look()
            self.hits = self._breakpoints.after_step(self.tick)
        return True

    def _look(self) -> None:
        for agent in self._agents:
            agent.look(self._now)

    def seek(self, tick: int, stop: Callable[[], bool]) -> None:
        """Goes to a tick."""
        self._stand(self._reader.seek(tick))

    def step(self, agent: str, stop: Callable[[], bool]) -> None:
        """Goes on until the agent ("" for anybody) stands at another vertex, or somebody comes to a breakpoint; at
        most to the end.
        """
        before = self._teller.standing(self._now, agent)
        self.hits = []
        while not stop() and self._next():
            if self.hits or self._teller.standing(self._now, agent) != before:
                break
        self._now = kept(self._now)

    def step_back(self, agent: str, stop: Callable[[], bool]) -> None:
        """Goes back to the last tick at which the agent ("" for anybody) stood at another vertex, or to the first."""
        before = self._teller.standing(self._now, agent)
        for record in self._reader.walk_back(self.tick):
            if stop():
                return
            if self._teller.standing(record, agent) != before:
                self._stand(record)
                return
        self._stand(self._first)

    def _stand(self, record: TickRecord) -> None:
        self._now = record
        self._ahead = None
        self.hits = []
        self._look()
        self._breakpoints.went_to(self.tick)

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Cannot be done."""
        self._refuse()

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Cannot be done."""
        self._refuse()

    def harm(self, agent: str, kind: object) -> None:
        """Cannot be done."""
        self._refuse()

    def _refuse(self) -> NoReturn:
        raise PlayingError(
            "this is a recording: what happened cannot be changed", "run its mission, and do it in that run"
        )

    def stop(self) -> None:
        """There are no motors."""

    def look_at(self, agents: Iterable[str]) -> None:
        """As `Teller.look_at`."""
        self._teller.look_at(agents)

    def pause_at(self, breakpoints: Iterable[Breakpoint]) -> None:
        """These are the breakpoints from now on; visits are counted anew.

        Raises:
            ConditionError: a condition cannot be understood.
            PlayingError: a condition cannot be tested here; its breakpoint pauses at each visit.
        """
        header = self._reader.header
        sensible, all_of_them = testable(breakpoints, header, self._robots)
        self._breakpoints = Breakpoints(sensible, self._agents, header.vertices)
        self._look()
        self._breakpoints.went_to(self.tick)
        if not all_of_them:
            raise PlayingError(
                "a condition of a breakpoint cannot be tested in this recording: its robot is not known as it was",
                "the recording pauses there at every visit",
            )

    # -- telling

    def started(self, run: str) -> StartedMessage:
        """The first message."""
        return self._teller.started(run, self._trace.world, self._first, recording=True)

    def tell(self) -> tuple[bytes, dict[str, Any]]:
        """All poses, as `Teller.frame` gives them, and what changed since the last time, in the shape of a
        `TickMessage`; the first time with all events.
        """
        again, self._again = self._again, False
        happened = self._all_events() if again else []
        news = self._teller.news(self._now, self._reader.last_tick, again, happened)
        return self._teller.frame(self._now), news

    def tell_whole(self) -> tuple[bytes, dict[str, Any]]:
        """All poses and everything that `tell` has told so far, for somebody who joins now."""
        return self._teller.frame(self._now), self._teller.whole(self._now, self._reader.last_tick, self._all_events())

    def _all_events(self) -> list[TraceEvent]:
        return [event for _, event in self._reader.events[-MOST_EVENTS_TOLD:]]

    def close(self) -> None:
        """Lets go of the file."""
        self._reader.close()
