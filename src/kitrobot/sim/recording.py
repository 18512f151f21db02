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
from kitrobot.sim.columns import DELIVERED, HEADING, LOAD, X, Y
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.state import numbers
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
        simulation, state = self._simulation, self._simulation.state
        rows = [numbers(state.real[column]) for column in (X, Y, HEADING)]
        xs, ys, headings = rows
        loads = numbers(state.whole[LOAD])
        recorded: list[int] = []
        commands: list[TraceCommand] = []
        for agent in simulation.members:
            i = agent.index
            recorded.append(round(xs[i] * 10))
            recorded.append(round(ys[i] * 10))
            recorded.append(round(headings[i] * 1000))
            recorded.append(loads[i])
            recorded.append(simulation.flags(i))
            recorded += numbers(agent.machine.cells[: agent.machine.layout.cells])
            commands += [
                TraceCommand(i, command.actuator, command.procedure, tuple(command.arguments))
                for command in agent.commands
            ]
        recorded += numbers(state.stock)
        recorded += [int(state.whole[DELIVERED][index]) for index in self._carriers]
        recorded.append(simulation.collisions)
        active = [agent.active for agent in simulation.members]
        events = [TraceEvent(event.kind, event.index, event.text) for event in simulation.events]
        return TickRecord(simulation.tick - 1, recorded, active, commands, events)


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
        if recorder is None or writer is None:
            simulation.advance(PROGRESS_STEPS - simulation.tick % PROGRESS_STEPS)
        else:
            simulation.step()
            writer.record(recorder.record())
        if progress is not None and simulation.tick % PROGRESS_STEPS == 0 and progress(simulation):
            return
