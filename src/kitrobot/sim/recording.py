"""A run as a trace: which numbers are recorded, and driving a run to its end with a recorder.

Recorded after each step: of each agent x and y (tenths of a mm), heading (thousandths of a rad), load, flags, fault,
its inputs and variables, and where its threads stand; of the team the stock, what was delivered, and collisions.
Nothing depends on a clock or on this machine, so the same run gives the same bytes.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

from kitrobot.mission import write_mission
from kitrobot.sim.simulation import Simulation
from kitrobot.trace import (
    TEAM,
    Column,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceEvent,
    TraceHeader,
    TraceWriter,
)

PROGRESS_STEPS = 250
"""How often `simulate` reports how far it is."""


class Recorder:
    """Turns a simulation into a trace's header and records."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._carriers = [agent.index for agent in simulation.members if agent.kind == "carrier"]
        self._cells = [(agent.machine, 1 + agent.machine.layout.inputs) for agent in simulation.members]
        self.header = self._header()

    def _header(self) -> TraceHeader:
        simulation = self._simulation
        columns: list[Column] = []
        for agent in simulation.members:
            layout = agent.machine.layout
            columns += [Column(agent.name, "x_mm", 0.1), Column(agent.name, "y_mm", 0.1)]
            columns.append(Column(agent.name, "heading_rad", 0.001))
            columns += [Column(agent.name, name) for name in ("load", "flags", "fault")]
            columns += [Column(agent.name, f"input {name}") for name in layout.sensors]
            columns += [Column(agent.name, f"done {name}") for name in layout.done]
            columns += [Column(agent.name, f"variable {name}") for name in layout.variables]
        columns += [Column(TEAM, f"stock {house.name}") for house in simulation.world.storehouses]
        columns += [Column(TEAM, f"delivered {simulation.members[index].name}") for index in self._carriers]
        columns.append(Column(TEAM, "collisions"))
        agents = tuple(TraceAgent(agent.name, agent.program, agent.robot.name) for agent in simulation.members)
        mission = hashlib.sha256(write_mission(simulation.mission)).hexdigest()
        return TraceHeader(mission, simulation.seed, simulation.world.name, simulation.tick_ms, agents, tuple(columns))

    def record(self) -> TickRecord:
        """What is true after the last step, and what happened in it."""
        simulation, stage = self._simulation, self._simulation.stage
        bodies = stage.bodies
        numbers: list[int] = []
        commands: list[TraceCommand] = []
        tick = simulation.tick - 1
        for agent in simulation.members:
            i = agent.index
            numbers.append(round(bodies.x[i] * 10))
            numbers.append(round(bodies.y[i] * 10))
            numbers.append(round(bodies.heading[i] * 1000))
            numbers.append(bodies.load[i])
            numbers.append(simulation.flags(i))
            layout = agent.machine.layout
            numbers += agent.machine.cells[: layout.cells]
            if agent.commands and tick % agent.period == 0:
                commands += [
                    TraceCommand(i, command.actuator, command.procedure, tuple(command.arguments))
                    for command in agent.commands
                ]
        numbers += stage.stock
        numbers += [stage.delivered[index] for index in self._carriers]
        numbers.append(simulation.collisions)
        active = [agent.active for agent in simulation.members]
        events = [TraceEvent(kind, index, text) for kind, index, text in stage.happened]
        return TickRecord(tick, numbers, active, commands, events)


def simulate(
    simulation: Simulation,
    trace: Path | None = None,
    progress: Callable[[Simulation], bool | None] | None = None,
) -> Simulation:
    """Runs a simulation to its end, as fast as it goes.

    Args:
        simulation: a run with a time limit, or one that surely ends.
        trace: where to record it, if anywhere.
        progress: called now and then; when it gives True the run is broken off, without an outcome.

    Raises:
        TraceError: the trace cannot be written.
    """
    if trace is None:
        _drive(simulation, None, None, progress)
        return simulation
    recorder = Recorder(simulation)
    with TraceWriter(trace, recorder.header) as writer:
        _drive(simulation, recorder, writer, progress)
        writer.finish(
            {
                "outcome": simulation.outcome or "stopped",
                "sentence": simulation.sentence,
                "ticks": simulation.tick,
                "delivered": simulation.delivered,
                "collisions": simulation.collisions,
            }
        )
    return simulation


def _drive(
    simulation: Simulation,
    recorder: Recorder | None,
    writer: TraceWriter | None,
    progress: Callable[[Simulation], bool | None] | None,
) -> None:
    while simulation.outcome is None:
        simulation.step()
        if recorder is not None and writer is not None:
            writer.record(recorder.record())
        if progress is not None and simulation.tick % PROGRESS_STEPS == 0 and progress(simulation):
            return
