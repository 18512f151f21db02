"""A run as the page sees it: steered, paused at breakpoints, and sent as frames and messages, whatever its source.

The messages come from records of a trace (run_encoder). Events are collected over all the ticks
between two messages.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from kitrobot.diagnostics.model import Diagnostic, KitRobotError
from kitrobot.live.run_encoder import MOST_EVENTS_SENT, MOST_REPORTED, RunEncoder
from kitrobot.mission.model import Mission
from kitrobot.mission.trial import Breakpoint
from kitrobot.sim.breakpoints import Breakpoints, Hit, ObservedAgent
from kitrobot.text.sentences import Sentence
from kitrobot.trace.source import RunSource
from kitrobot.wire.run import StartedMessage
from kitrobot.world.model import World

_TICKS_BETWEEN_LOOKS = 8
"""Ticks run between two looks at the clock; fewer of very many robots, so that Stop is obeyed soon."""
_ROBOT_TICKS_BETWEEN_LOOKS = 4000

_PATH_INTERVAL_TICKS = 8
"""Ticks between two points of the path that robots took since the last update, where more were run; a lamp that is on
for longer is seen there."""
_MAX_PATH_BYTES = 64_000
"""Bytes of that path; a longer one has its points further apart."""
LONGEST_STEP_S = 600
"""How far in the run a step to another vertex goes, forward or back, where the agent stays where it is."""


class StepError(KitRobotError):
    """No agent came to another vertex."""


class WatchedRun(ABC):
    """One run. `agents` are queried by breakpoints; `recording`: all of it has happened.

    Raises:
        ConditionError: the condition of a breakpoint cannot be understood.
        TraceError: the header lacks a number that the page needs.
    """

    recording = False
    fleet = False
    """Whether its agents are processes."""
    follows = False
    """Whether it goes on to the latest tick each time, and not by the pace."""

    def __init__(
        self, source: RunSource, world: World, agents: Sequence[ObservedAgent], breakpoints: Iterable[Breakpoint] = ()
    ) -> None:
        self._source = source
        self._world = world
        self._agents = agents
        self._encoder = RunEncoder(source.header)
        self._breakpoints = self._parse_breakpoints(breakpoints)
        members = len(source.header.agents)
        self._longest_step = LONGEST_STEP_S * 1000 // source.header.tick_ms
        self._portion = max(1, min(_TICKS_BETWEEN_LOOKS, _ROBOT_TICKS_BETWEEN_LOOKS // max(1, members)))
        self._path_frames: list[bytes] = []
        self._path_tick = 0
        self._path_interval = _PATH_INTERVAL_TICKS
        self.hits: list[Hit] = []
        """Why `advance` came to an end before its time: the agents at breakpoints."""

    @property
    def real(self) -> bool:
        """Whether it goes on by itself now, as real robots and fleets do; while it does, it does not end for good."""
        return False

    @property
    def mission(self) -> Mission | None:
        """What runs, where that is known here."""
        return None

    @property
    def advice(self) -> list[Diagnostic]:
        """Hints on a run that ended before anything could be seen."""
        return []

    @property
    def tick(self) -> int:
        """The tick that the run is at."""
        return self._source.tick

    @property
    def tick_s(self) -> float:
        """Seconds of simulated time per tick."""
        return self._source.header.tick_ms / 1000

    @property
    def seconds(self) -> float:
        """Time of the run."""
        return self._source.tick * self._source.header.tick_ms / 1000

    @property
    def outcome(self) -> str | None:
        """How the run ended, if it is at its end."""
        return self._source.outcome

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self._source.sentence

    # -- going on and back

    def advance(self, most: int | None, until: float, clock: Callable[[], float]) -> None:
        """Goes on: at most `most` ticks (None: as many as there is time for), none begun long after `until`, and none
        after one in which somebody comes to a breakpoint.
        """
        run = looked = 0
        self.hits = []
        while self.outcome is None and not self.hits and (most is None or run < most):
            portion = self._portion if most is None else min(self._portion, most - run)
            made = self._advance(1 if self._breakpoints else portion)
            run, looked = run + made, looked + 1
            if made == 0 or ((not self._breakpoints or looked % self._portion == 0) and clock() >= until):
                return

    def _advance(self, ticks: int) -> int:
        made = self._source.advance(ticks)
        if self.tick - self._path_tick >= self._path_interval:
            self._keep_path_frame()
        if self._breakpoints:
            self._observe()
            self.hits = self._breakpoints.after_step(self.tick)
        return made

    def _keep_path_frame(self) -> None:
        """Stores the robots' poses and used parts between two updates, for a few robots: of many nobody sees them."""
        self._path_tick = self.tick
        if len(self._source.header.agents) > MOST_REPORTED:
            return
        record = self._source.record(self._encoder.with_unused_parts)
        self._encoder.note_used_parts(record)
        self._path_frames.append(self._encoder.encode_frame(record))
        if len(self._path_frames) * len(self._path_frames[0]) > _MAX_PATH_BYTES:
            del self._path_frames[::2]
            self._path_interval *= 2

    def _observe(self) -> None:  # noqa: B027 (members of a simulation are always at its tick)
        """Brings the agents that breakpoints ask to the tick that the run is at."""

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick, in short pieces, as those of `RunSource.seek`."""
        yield from self._source.seek(tick)
        self._after_seek()

    def follow(self) -> Iterator[None]:
        """The way to the latest tick."""
        return self.seek(self._source.latest)

    def has_restarted(self) -> bool:
        """Whether it has restarted since the last call, as robots do that are started again. Its earlier state is gone
        then; it goes on from its beginning, and visits are counted anew.
        """
        return False

    def hold(self) -> None:
        """It is not gone on with for a while; what real robots do meanwhile is for later."""
        self.follows = False

    def step(self, agent: str) -> Iterator[None]:
        """The way on until the agent ("" for anybody) is at another vertex, or an agent comes to a breakpoint.

        Raises:
            StepError: it is still at the same vertex after `LONGEST_STEP_S` of the run; the run stays there.
        """
        before, last = self._thread_positions(agent), self.tick + self._longest_step
        self.hits = []
        while self.outcome is None and not self.hits:
            if self._advance(1) == 0 or self._thread_positions(agent) != before:
                return
            if self.tick >= last:
                raise StepError(
                    Sentence("nobody came to another part within {minutes} minutes of the run", LONGEST_STEP_S // 60)
                    if agent == ""
                    else Sentence(
                        "`{agent}` came to no other part within {minutes} minutes of the run",
                        agent,
                        LONGEST_STEP_S // 60,
                    ),
                    Sentence("step once more to go on as long again, or let the run go on"),
                )
            yield

    def step_back(self, agent: str) -> Iterator[None]:
        """The way back to the last tick at which the agent ("" for anybody) stood at another vertex, to the first, or
        by `LONGEST_STEP_S`.
        """
        before, last = self._thread_positions(agent), self.tick - self._longest_step
        yield from self._source.seek_back(lambda: self.tick <= last or self._thread_positions(agent) != before)
        self._after_seek()

    def _thread_positions(self, agent: str) -> list[tuple[str, tuple[str | None, ...]]]:
        return self._encoder.thread_positions(self._source.active(), agent)

    def _after_seek(self) -> None:
        self._observe()
        self._breakpoints.went_to(self.tick)
        self.hits = []
        # The robots did not drive from where they were.
        self._path_frames, self._path_tick = [], self.tick

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """As `RunSource.force`."""
        self._source.force(agent, sensor, value)

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """As `RunSource.set_variable`."""
        self._source.set_variable(agent, variable, value)

    def inject_fault(self, agent: str, kind: str) -> None:
        """As `RunSource.fail`."""
        self._source.fail(agent, kind)

    def stop(self) -> None:
        """As `RunSource.stop`."""
        self._source.stop()

    def look_at(self, agents: Iterable[str]) -> None:
        """As `RunEncoder.look_at`."""
        self._encoder.look_at(agents)

    def pause_at(self, breakpoints: Iterable[Breakpoint]) -> None:
        """These are the breakpoints from now on; visits are counted anew.

        Raises:
            ConditionError: a condition cannot be understood.
        """
        self._breakpoints = self._parse_breakpoints(breakpoints)
        self._observe()
        self._breakpoints.went_to(self.tick)

    def _parse_breakpoints(self, breakpoints: Iterable[Breakpoint]) -> Breakpoints:
        return Breakpoints(breakpoints, self._agents, self._source.header.places)

    # -- messages

    def started(self, run: str) -> StartedMessage:
        """The first message."""
        first = self._source.record()
        pens = self._source.drawing.pens
        message = self._encoder.started(run, self._world, first, self._source.abilities, self.recording, pens)
        return message.model_copy(update={"fleet": self.fleet})

    def encode_update(self) -> tuple[bytes, dict[str, Any]]:
        """All poses, as `RunEncoder.encode_frame` gives them, after those of the path there if that was long, and the
        changes since the last update, in the shape of a `TickMessage`.
        """
        again, events = self._source.new_events(MOST_EVENTS_SENT)
        record = self._source.record(self._encoder.reported)
        drawn = self._source.drawing.news(record.tick)
        frames = b"".join([*self._path_frames, self._encoder.encode_frame(record)])
        self._path_frames, self._path_tick, self._path_interval = [], record.tick, _PATH_INTERVAL_TICKS
        return frames, self._encoder.encode_changes(record, self._source.latest, again, events, drawn)

    def encode_snapshot(self) -> tuple[bytes, dict[str, Any]]:
        """All poses and everything that `encode_update` has sent so far, for a watcher that joins now."""
        events = self._source.events(MOST_EVENTS_SENT)
        record = self._source.record(self._encoder.reported)
        marks = self._source.drawing.until(record.tick)
        return self._encoder.encode_frame(record), self._encoder.encode_snapshot(
            record, self._source.latest, events, marks
        )

    # -- recording

    @abstractmethod
    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """Writes its whole past into a file, or the part that was written when `stop` returns True. The run may go on
        meanwhile, in another thread.

        Raises:
            TraceError: the trace cannot be written.
        """

    def close(self) -> None:
        """As `RunSource.close`."""
        self._source.close()
