"""A run that can be gone back in: to any step that was made, and on from there, the same way or another way.

A run is its first state and what was done to it from outside (`Intervention`s), each at its step; everything between
follows. So going to a step is restoring the nearest state that was kept before it and running up to it. States are
kept along the way, as many as there is room for: when there is no more, every other one goes. Going forward from the
past runs the same future again, up to the step where the person does something else: then what was to come is
forgotten, and a new future begins.

Left to others: how a step is made (simulation), pausing, pace, who watches.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal

from kitrobot.mission.trial import FailureKind
from kitrobot.primitives.value_format import held_by_hand, set_by_hand
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.pens import pens_of
from kitrobot.trace.drawing import Drawing, Mark
from kitrobot.trace.source import walk

ROOM_BYTES = 64 * 1024 * 1024
OUTSIDE = "outside"
"""The kind of event that says what somebody did to the run."""
FIRST_SPACING = 25
"""Steps between two kept states, to begin with."""
PIECE = 100
"""Steps of a piece of the way to a step; whoever goes there may leave off after each."""
MOST_EVENTS = 100_000
"""Events of the past that are kept to be told again; the oldest go first."""


@dataclass(frozen=True)
class Intervention:
    """What was done to a run from outside, before the step `tick`. `name` is a sensor's or a variable's, or
    what befalls the agent.
    """

    tick: int
    kind: Literal["force", "set", "harm"]
    agent: str
    name: str
    value: int | None


class Timeline:
    """A simulation with its past. `latest` is the furthest step that was made on this future.

    Nobody else may step, force or restore the simulation meanwhile.
    """

    def __init__(self, simulation: Simulation, room_bytes: int = ROOM_BYTES) -> None:
        self.simulation = simulation
        self.latest = simulation.tick
        self.interventions: list[Intervention] = []
        self.events: list[Event] = []
        """Everything that happened up to `latest`."""
        self.drawing = Drawing(pens_of(simulation.members))
        """What pens drew up to `latest`."""
        self._room = room_bytes
        self._spacing = FIRST_SPACING
        self._ticks = [simulation.tick]
        self._states = [simulation.snapshot()]
        self._bytes = len(self._states[0])

    @property
    def tick(self) -> int:
        """The step that the run stands at."""
        return self.simulation.tick

    def advance(self, steps: int) -> int:
        """Goes on for up to so many steps and gives how many; `simulation.events` is what happened in them."""
        done, events = 0, list[Event]()
        while done < steps and self.simulation.outcome is None:
            made = self._advance_to(min(self.tick + steps - done, self._next_stop()))
            events += self.simulation.events
            if made == 0:
                break
            done += made
        self.simulation.events = events
        return done

    def go_to(self, tick: int) -> None:
        """Goes to a step between the first and `latest`."""
        walk(self.walk_to(tick))

    def walk_to(self, tick: int) -> Iterator[None]:
        """The way to a step between the first and `latest`, in pieces of at most `PIECE` steps."""
        tick = max(self._ticks[0], min(tick, self.latest))
        if tick < self.tick or self._ticks[self._kept_before(tick)] > self.tick:
            self.simulation.restore(self._states[self._kept_before(tick)])
        while self.tick < tick:
            self._advance_to(min(tick, self._next_stop(), self.tick + PIECE))
            yield

    def walk_back_to(self, wanted: Callable[[], bool]) -> Iterator[None]:
        """The way back to the last step before this one at which `wanted` says yes, or to the first step, in pieces."""
        now = self.tick
        for at in range(self._kept_before(max(self._ticks[0], now - 1)), -1, -1):
            self.simulation.restore(self._states[at])
            last = self.tick if wanted() else None
            while self.tick < now - 1:
                self._advance_to(self.tick + 1)
                yield
                if wanted():
                    last = self.tick
            if last is not None:
                yield from self.walk_to(last)
                return
            now = self._ticks[at]
        yield from self.walk_to(self._ticks[0])

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """As `Simulation.force`, and part of the run from this step on.

        Raises:
            KitRobotError: there is no such agent or sensor.
        """
        self._intervene(Intervention(self.tick, "force", agent, sensor, value))

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """As `Simulation.set_variable`, and part of the run from this step on.

        Raises:
            KitRobotError: there is no such agent or variable.
        """
        self._intervene(Intervention(self.tick, "set", agent, variable, value))

    def inject_fault(self, agent: str, kind: FailureKind | str) -> bool:
        """As `Simulation.harm`, and part of the run from this step on; what changes nothing is not.

        Raises:
            KitRobotError: there is no such agent, or too much was done between two steps.
        """
        changed = self.simulation.inject_fault(agent, kind)
        if changed:
            self._note(Intervention(self.tick, "harm", agent, FailureKind(kind).value, None))
        return changed

    def events_until(self, tick: int) -> list[Event]:
        """What happened in the steps before this one, and was done from outside up to it."""
        return [event for event in self.events if event.tick < tick or (event.kind == OUTSIDE and event.tick == tick)]

    def done_again(self, simulation: Simulation) -> Iterator[list[Event]]:
        """The same run once more, up to `latest`, in a simulation at its first step: before each step and after the
        last one it stands as this one did, and what happened since is given.

        What befalls agents by hand is told by the step after it, or at the very end.
        """
        again = Timeline(simulation, room_bytes=1)
        again.interventions, last = list(self.interventions), self.latest
        for one in again.interventions:
            if one.tick == again.tick:
                again._apply(one)
        happened: list[Event] = []
        while True:
            outside = [one for one in again.interventions if one.tick == again.tick]
            happened += [event for one in outside for event in again._told(one)]
            if again.tick >= last or simulation.outcome is not None:
                yield happened + simulation.unreported_events
                return
            yield happened
            again.advance(1)
            happened = list(simulation.events)

    # -- inside

    def _intervene(self, intervention: Intervention) -> None:
        self._apply(intervention)
        self._note(intervention)

    def _note(self, intervention: Intervention) -> None:
        """It was done just now: what was to come is forgotten."""
        self._forget_what_was_to_come()
        self.interventions.append(intervention)
        self.events += self._told(intervention)
        # The state that is kept of this very step is from before it.
        if self._ticks[-1] == self.tick and len(self._ticks) > 1:
            self._drop(-1)
        elif self._ticks[-1] == self.tick:
            self._bytes -= len(self._states[0])
            self._states[0] = self.simulation.snapshot()
            self._bytes += len(self._states[0])

    def _apply(self, intervention: Intervention) -> None:
        if intervention.kind == "force":
            self.simulation.force(intervention.agent, intervention.name, intervention.value)
        elif intervention.kind == "harm":
            self.simulation.inject_fault(intervention.agent, intervention.name)
        else:
            self.simulation.set_variable(intervention.agent, intervention.name, intervention.value or 0)

    def _told(self, intervention: Intervention) -> list[Event]:
        """An intervention as an event; what befalls an agent is told by the run itself."""
        if intervention.kind == "harm":
            return []
        who, value = intervention.agent, intervention.value
        member = next(one for one in self.simulation.members if one.name == who)
        if intervention.kind == "set":
            text = set_by_hand(member.robot, intervention.name, value or 0)
        else:
            text = held_by_hand(member.robot, intervention.name, value)
        return [Event(intervention.tick, OUTSIDE, who, text, member.index, "person")]

    def _forget_what_was_to_come(self) -> None:
        tick = self.tick
        self.interventions = [one for one in self.interventions if one.tick <= tick]
        self.events = self.events_until(tick)
        self.drawing.forget_after(tick)
        while self._ticks[-1] > tick:
            self._drop(-1)
        self.latest = tick

    def _next_stop(self) -> int:
        """The next step at which something is to be done: a known intervention, or a state to keep."""
        tick = self.tick
        known = [one.tick for one in self.interventions if one.tick > tick]
        keep = tick - tick % self._spacing + self._spacing
        return min([keep, *known])

    def _advance_to(self, tick: int) -> int:
        """Runs up to a step between which and now nothing is to be done."""
        simulation = self.simulation
        begin = simulation.tick
        happened: list[Event] = []
        drawn: list[Mark] = []
        while simulation.tick < tick and simulation.outcome is None:
            simulation.advance(tick - simulation.tick)
            happened += simulation.events
            drawn += simulation.drawn
        simulation.events = happened
        now = simulation.tick
        if now > self.latest:
            self.events += [event for event in happened if event.tick >= self.latest]
            del self.events[:-MOST_EVENTS]
            self.drawing.add(mark for mark in drawn if mark.tick > self.latest)
            self.latest = now
        for intervention in self.interventions:
            if intervention.tick == now:
                self._apply(intervention)
        if now > self._ticks[-1] and now % self._spacing == 0:
            self._keep()
        return now - begin

    def _kept_before(self, tick: int) -> int:
        return bisect_right(self._ticks, tick) - 1

    def _keep(self) -> None:
        """Keeps the state of now; it holds what was done at this step already."""
        state = self.simulation.snapshot()
        self._ticks.append(self.tick)
        self._states.append(state)
        self._bytes += len(state)
        while self._bytes > self._room and len(self._ticks) > 2:
            self._spacing *= 2
            for at in range(len(self._ticks) - 1, 0, -1):
                if self._ticks[at] % self._spacing and self._bytes > self._room // 2:
                    self._drop(at)

    def _drop(self, at: int) -> None:
        self._bytes -= len(self._states[at])
        del self._ticks[at], self._states[at]
