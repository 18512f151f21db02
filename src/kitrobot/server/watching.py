"""A run as the page sees it: frames of poses, and messages of what changed since the last one.

The simulator speaks of instructions, the page of vertices: each agent's threads are brought back to vertices through
the debug map of its program. What is told is remembered, so that an agent that did not change is not told again.
Events are collected over all the ticks between two messages.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable
from typing import Any

from kitrobot.mission import Breakpoint
from kitrobot.server.shapes import StartedAgentShape, StartedMessage, world_shape
from kitrobot.sim import AgentView, Event, Simulation
from kitrobot.sim.breakpoints import Breakpoints, Hit
from kitrobot.sim.timeline import Timeline
from kitrobot.translation import said
from kitrobot.workspace import OpenMission

MOST_EVENTS_TOLD = 5000
"""Events that are told at once when all of them are told again."""

MOST_REPORTED = 100
"""In a run of more agents than this, only those that are looked at are reported; all are in the frames."""

_TICKS_BETWEEN_LOOKS = 8
"""Ticks run between two looks at the clock."""


class Watch:
    """Watches one simulation of a mission, and takes it back and on.

    Raises:
        ConditionError: the condition of a breakpoint cannot be understood.
    """

    def __init__(self, opened: OpenMission, simulation: Simulation) -> None:
        simulation.watch_programs()
        self._simulation = simulation
        self._timeline = Timeline(simulation)
        self._compiled = opened.compiled
        self._debug = {name: compiled.debug for name, compiled in opened.compiled.items()}
        self._told: dict[str, dict[str, Any]] = {}
        self._events: list[Event] = []
        self._early: list[Event] = []
        """What was done by hand and told at once, before the step that tells it."""
        self._looked_at = self._first_ones()
        self._again = False
        self._breakpoints = Breakpoints(opened.mission.breakpoints, simulation.members, opened.compiled)
        self.hits: list[Hit] = []
        """Why `advance` came to an end before its time: who came to a breakpoint."""

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

    # -- going on and back

    def advance(self, most: int | None, until: float, clock: Callable[[], float]) -> None:
        """Runs ticks: at most `most` (None: as many as there is time for), none begun long after `until`, and none
        after one in which somebody comes to a breakpoint.
        """
        simulation, run = self._simulation, 0
        self.hits = []
        while simulation.outcome is None and not self.hits and (most is None or run < most):
            portion = _TICKS_BETWEEN_LOOKS if most is None else min(_TICKS_BETWEEN_LOOKS, most - run)
            run += self._advance(1 if self._breakpoints else portion)
            if (not self._breakpoints or run % _TICKS_BETWEEN_LOOKS == 0) and clock() >= until:
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
        """Of very many agents these are reported from now on; the first one of each program always is."""
        self._looked_at = self._first_ones() | frozenset(agents)

    def _first_ones(self) -> frozenset[str]:
        first: dict[str, str] = {}
        for agent in self._simulation.members:
            first.setdefault(agent.program, agent.name)
        return frozenset(first.values())

    def stop(self) -> None:
        """Stops every motor; the run is not gone on with."""
        self._simulation.stop_motors()

    def pause_at(self, breakpoints: Iterable[Breakpoint]) -> None:
        """These are the breakpoints from now on; visits are counted anew.

        Raises:
            ConditionError: a condition cannot be understood.
        """
        self._breakpoints = Breakpoints(breakpoints, self._simulation.members, self._compiled)
        self._breakpoints.went_to(self.tick)

    # -- telling

    def started(self, run: str) -> StartedMessage:
        """The first message."""
        simulation = self._simulation
        agents = [
            StartedAgentShape(
                name=agent.name, program=agent.program, robot=agent.robot, number=agent.number, kind=agent.kind
            )
            for agent in simulation.agents
        ]
        return StartedMessage(
            run=run,
            tick_ms=simulation.tick_ms,
            seed=simulation.seed,
            world=world_shape(simulation.world),
            agents=agents,
            stock=simulation.stock,
            total=simulation.total,
        )

    def frame(self) -> bytes:
        """All poses: float32, little-endian: tick, how many, then x, y, heading, load, flags of each."""
        poses = self._simulation.poses()
        numbers = [number for pose in poses for number in pose]
        return struct.pack(f"<{2 + len(numbers)}f", self._simulation.tick, len(poses), *numbers)

    def news(self) -> dict[str, Any]:
        """What changed since the last time, in the shape of a `TickMessage`."""
        simulation = self._simulation
        changed = {}
        everybody = len(simulation.members) <= MOST_REPORTED
        for member in simulation.members:
            if not everybody and member.name not in self._looked_at:
                continue
            agent = simulation.view(member.index)
            report = self._report(agent)
            if self._told.get(agent.name) != report:
                changed[agent.name] = self._told[agent.name] = report
        again = self._again
        happened = [*self._timeline.events[-MOST_EVENTS_TOLD:], *self._early] if again else self._events
        events = [
            {"tick": event.tick, "kind": event.kind, "agent": event.agent, "text": said(event.text)}
            for event in happened
        ]
        self._events, self._again = [], False
        return {
            "type": "tick",
            "tick": simulation.tick,
            "latest": self._timeline.latest,
            "again": again,
            "seconds": simulation.seconds,
            "agents": changed,
            "stock": simulation.stock,
            "delivered": simulation.delivered,
            "collisions": simulation.collisions,
            "events": events,
        }

    def _report(self, agent: AgentView) -> dict[str, Any]:
        debug = self._debug[agent.program]
        stands = [(slot, debug.vertex(instruction)) for slot, instruction in agent.active]
        return {
            "active": [[slot, vertex] for slot, vertex in stands if vertex is not None],
            "state": agent.state,
            "values": agent.values,
            "inputs": agent.inputs,
            "fault": agent.fault,
            "forced": self._simulation.forced(agent.name),
        }
