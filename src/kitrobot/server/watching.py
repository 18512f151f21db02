"""A run as the page sees it: frames of poses, and messages of what changed since the last one.

The simulator speaks of instructions, the page of vertices: each agent's threads are brought back to vertices through
the debug map of its program. What is told is remembered, so that an agent that did not change is not told again.
Events are collected over all the ticks between two messages.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from kitrobot.server.shapes import StartedAgentShape, StartedMessage, world_shape
from kitrobot.sim import AgentView, Simulation
from kitrobot.translation import said
from kitrobot.workspace import OpenMission

_TICKS_BETWEEN_LOOKS = 8
"""Ticks run between two looks at the clock."""


class Watch:
    """Watches one simulation of a mission."""

    def __init__(self, opened: OpenMission, simulation: Simulation) -> None:
        self._simulation = simulation
        self._debug = {name: compiled.debug for name, compiled in opened.compiled.items()}
        self._told: dict[str, dict[str, Any]] = {}
        self._events: list[dict[str, Any]] = []

    @property
    def tick(self) -> int:
        """How many ticks were run."""
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
        """How the run ended, if it has."""
        return self._simulation.outcome

    @property
    def sentence(self) -> str:
        """Why it ended."""
        return self._simulation.sentence

    def advance(self, most: int | None, until: float, clock: Callable[[], float]) -> None:
        """Runs ticks: at most `most` (None: as many as there is time for), and none begun long after `until`."""
        simulation, run = self._simulation, 0
        while simulation.outcome is None and (most is None or run < most):
            simulation.step()
            run += 1
            self._events += [
                {"tick": event.tick, "kind": event.kind, "agent": event.agent, "text": event.text}
                for event in simulation.events
            ]
            if run % _TICKS_BETWEEN_LOOKS == 0 and clock() >= until:
                return

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
        for agent in simulation.agents:
            report = self._report(agent)
            if self._told.get(agent.name) != report:
                changed[agent.name] = self._told[agent.name] = report
        events = [{**event, "text": said(event["text"])} for event in self._events]
        self._events = []
        return {
            "type": "tick",
            "tick": simulation.tick,
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
        }
