"""A simulation as a `RunSource`: it can be gone back in, and everything can be done to it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence

from kitrobot.sim.event_text import Event
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.timeline import Timeline
from kitrobot.trace.drawing import Drawing
from kitrobot.trace.model import Threads, TickRecord, TraceEvent, TraceHeader
from kitrobot.trace.source import Ability, NewEvents


class SimulationSource:
    """Moves a simulation, and takes it back and on. Nobody else may step, force or restore it meanwhile."""

    abilities: frozenset[Ability] = frozenset({"force", "set", "seek", "fail", "step"})

    def __init__(self, simulation: Simulation) -> None:
        simulation.watch_programs()
        self.simulation = simulation
        self.timeline = Timeline(simulation)
        self._recorder = Recorder(simulation)
        self._events: list[Event] = []
        self._early: list[Event] = []
        """What was done by hand and told at once, before the step that tells it."""
        self._again = False

    @property
    def header(self) -> TraceHeader:
        """As it would be recorded."""
        return self._recorder.header

    @property
    def tick(self) -> int:
        """The tick that the run stands at."""
        return self.simulation.tick

    @property
    def latest(self) -> int:
        """The furthest tick that was run on this future."""
        return self.timeline.latest

    @property
    def drawing(self) -> Drawing:
        """What pens drew up to the latest tick."""
        return self.timeline.drawing

    @property
    def outcome(self) -> str | None:
        """How the run ended, if it stands at its end."""
        return self.simulation.outcome

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self.simulation.sentence

    def record(self, in_full: Collection[int] | None = None) -> TickRecord:
        """The run as it stands, as a trace would hold it."""
        return self._recorder.record((), in_full)

    def active(self) -> Sequence[Threads]:
        """Where the threads of each agent stand."""
        return [agent.active for agent in self.simulation.members]

    def events(self, most: int) -> Sequence[TraceEvent]:
        """The last events up to the latest tick."""
        return _recorded([*self.timeline.events[-most:], *self._early])

    def new_events(self, most: int) -> NewEvents:
        """The events since this was called last; all of them after the person changed the run."""
        again, self._again = self._again, False
        events, self._events = self._events, []
        return NewEvents(again, self.events(most) if again else _recorded(events))

    def advance(self, ticks: int) -> int:
        """Runs up to so many ticks."""
        before = self.timeline.latest
        done = self.timeline.advance(ticks)
        happened = self.simulation.events
        self._events += [one for one in happened if one.tick >= before and one not in self._early]
        self._early = []
        return done

    def seek(self, tick: int) -> Iterator[None]:
        """The way to a tick that was run already."""
        return self.timeline.walk_to(tick)

    def seek_back(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """The way back to the last tick at which `wanted` says yes."""
        return self.timeline.walk_back_to(wanted)

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures; None gives it back.

        Raises:
            KitRobotError: there is no such agent or sensor.
        """
        self.timeline.force(agent, sensor, value)
        self._again = True

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Sets a variable.

        Raises:
            KitRobotError: there is no such agent or variable.
        """
        self.timeline.set_variable(agent, variable, value)
        self._again = True

    def fail(self, agent: str, kind: str) -> None:
        """Lets an agent fail, stall or lose its radio, or makes it well again.

        Raises:
            KitRobotError: there is no such agent, or too much was done at once.
        """
        if self.timeline.inject_fault(agent, kind):
            self._again = True
            self._early = self.simulation.unreported_events

    def stop(self) -> None:
        """Stops every motor; the run is not gone on with."""
        self.simulation.stop_motors()

    def close(self) -> None:
        """Nothing is held."""


def _recorded(events: Iterable[Event]) -> list[TraceEvent]:
    return [TraceEvent(one.tick, one.kind, one.index, one.text, one.cause) for one in events]
