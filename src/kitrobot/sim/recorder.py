"""A run as a trace: which numbers are recorded, and driving a run to its end with a recorder.

Recorded before the first step and after each: of each agent x and y (tenths of a mm), heading (thousandths of a rad),
load, flags, what it is doing, which of its sensors are forced (a bit each, in the order of its robot), its fault,
inputs and variables, what its displays, its pens and the like show, and where its threads stand; of the team the
stock, what was delivered, and collisions. Nothing depends on a clock or on this machine, so the same run gives the
same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from pathlib import Path
from typing import Any

from kitrobot.mission.writer import write_mission
from kitrobot.sim.agent_views import all_flags, commanded
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import DELIVERED, HEADING, LOAD, X, Y
from kitrobot.sim.tables.state import numbers
from kitrobot.sim.team_record import TeamRecord
from kitrobot.sim.timeline import Timeline
from kitrobot.trace.drawing import PEN, Drawing, Stroke
from kitrobot.trace.model import TEAM, Column, TickRecord, TraceAgent, TraceCommand, TraceEvent, TraceHeader, TracePart
from kitrobot.trace.writer import TraceWriter
from kitrobot.world.geometry import normalised
from kitrobot.world.xml_writer import write_world

PROGRESS_STEPS = 250
"""How often `simulate` reports how far it is."""
POSE = (("x_mm", 0.1), ("y_mm", 0.1), ("heading_rad", 0.001), ("load", 1.0), ("flags", 1.0))
"""The first numbers of each agent, with their units."""
DOING = ("idle", "waiting", "running", "failed", "stalled")
"""What an agent does, in the order of the numbers that are recorded for it."""
STOPPED = "stopped"
"""The outcome of a run that was still on when its recording ended."""


class Recorder:
    """Turns a simulation into a trace's header and records. `parts` are the XML files that its mission needs."""

    def __init__(self, simulation: Simulation, parts: Sequence[TracePart] = ()) -> None:
        self._simulation = simulation
        self._carriers = [agent.index for agent in simulation.members if agent.kind == "carrier"]
        self._widths: list[int] = []
        """How many numbers each agent has."""
        self.header = self._header(tuple(parts))

    def _header(self, parts: tuple[TracePart, ...]) -> TraceHeader:
        simulation = self._simulation
        columns: list[Column] = []
        for agent in simulation.members:
            layout = agent.machine.layout
            before = len(columns)
            columns += [Column(agent.name, name, scale) for name, scale in POSE]
            columns += [Column(agent.name, name) for name in ("doing", "forced", "fault")]
            columns += [Column(agent.name, f"input {name}") for name in layout.sensors]
            columns += [Column(agent.name, f"done {name}") for name in layout.done]
            columns += [Column(agent.name, f"variable {name}") for name in layout.variables]
            columns += [
                Column(agent.name, f"{PEN if name in agent.pens else 'shown '}{name} {n}")
                for name, output in agent.outputs()
                for n in range(len(output))
            ]
            self._widths.append(len(columns) - before)
        columns += [Column(TEAM, f"stock {house.name}") for house in simulation.world.storehouses]
        columns += [Column(TEAM, f"delivered {simulation.members[index].name}") for index in self._carriers]
        columns.append(Column(TEAM, "collisions"))
        things = range(len(simulation.state.pushables.ints[0]))
        columns += [Column(TEAM, f"thing {n} {word}", 0.1) for n in things for word in ("x_mm", "y_mm")]
        roles = [role.name for role in simulation.mission.team.roles]
        self._team = TeamRecord(simulation.team_plan, roles, simulation.members, simulation.state)
        columns += self._team.columns
        inner = {
            name: tuple(debug.inner_of(name.program)) for name, debug in sorted(simulation.debug.items()) if name.robot
        }
        return TraceHeader(
            write_mission(simulation.mission).decode(),
            simulation.seed,
            write_world(simulation.world).decode(),
            simulation.tick_ms,
            tuple(
                TraceAgent(agent.name, agent.program, agent.robot.name, agent.kind, agent.number)
                for agent in simulation.members
            ),
            tuple(columns),
            {
                name: tuple(debug.vertices_of(name.program) if name.robot else debug.vertices)
                for name, debug in sorted(simulation.debug.items())
            },
            parts,
            simulation.total,
            simulation.fail_rate,
            {name: found for name, found in inner.items() if any(found)},
            self._team.plan,
        )

    def record(self, happened: Iterable[Event] | None = None, in_full: Collection[int] | None = None) -> TickRecord:
        """What is true now, and what happened in the last step.

        Args:
            happened: what is told instead of the simulation's own events.
            in_full: the agents of which everything is recorded; of others, where there are very many, only the pose.
                None: all.
        """
        simulation, state = self._simulation, self._simulation.state
        xs, ys, headings = (numbers(state.robots.floats[column]) for column in (X, Y, HEADING))
        loads, flags = numbers(state.robots.ints[LOAD]), all_flags(state)
        forced, with_commands = simulation.forced_bits(), commanded(state)
        recorded: list[int] = []
        commands: list[TraceCommand] = []
        for agent in simulation.members:
            i = agent.index
            heading = normalised(headings[i])
            recorded += (round(xs[i] * 10), round(ys[i] * 10), round(heading * 1000), loads[i], flags[i])
            if in_full is not None and i not in in_full:
                recorded += [0] * (self._widths[i] - len(POSE))
                continue
            recorded += (DOING.index(agent.doing), forced[i])
            recorded += numbers(agent.machine.cells[: agent.machine.layout.cells])
            for _, output in agent.outputs():
                recorded += output
            if i in with_commands:
                commands += [
                    TraceCommand(i, command.actuator, command.procedure, tuple(command.arguments))
                    for command in agent.commands
                ]
        recorded += numbers(state.docks.stock)
        recorded += [int(state.robots.ints[DELIVERED][index]) for index in self._carriers]
        recorded.append(simulation.collisions)
        for x, y in zip(*map(numbers, state.pushables.floats[:2]), strict=True):
            recorded += (round(x * 10), round(y * 10))
        recorded += self._team.numbers(state)
        active = [agent.active if in_full is None or agent.index in in_full else () for agent in simulation.members]
        events = [
            TraceEvent(event.tick, event.kind, event.index, event.text, event.cause)
            for event in (simulation.events if happened is None else happened)
        ]
        return TickRecord(simulation.tick, recorded, active, commands, events)


def strokes_now(simulation: Simulation, drawing: Drawing) -> list[Stroke]:
    """The lines of a drawing of this run, up to where it stands."""
    places = {at: (x, y) for at, (x, y, *_) in enumerate(simulation.poses())}
    return drawing.strokes(simulation.tick, places)


def outcome_of(simulation: Simulation) -> dict[str, Any]:
    """How a run ended, as a trace says it last."""
    return {
        "outcome": simulation.outcome or STOPPED,
        "sentence": simulation.sentence,
        "ticks": simulation.tick,
        "delivered": simulation.delivered,
        "collisions": simulation.collisions,
    }


def simulate(
    simulation: Simulation,
    trace: Path | None = None,
    progress: Callable[[Simulation], bool | None] | None = None,
    parts: Sequence[TracePart] = (),
    drawing: Drawing | None = None,
    watch: Callable[[], Sequence[Event]] | None = None,
) -> Simulation:
    """Runs a simulation to its end, as fast as it goes.

    Args:
        simulation: a run with a time limit, or one that surely ends.
        trace: where to record it, if anywhere.
        progress: called now and then; when it gives True the run is broken off, without an outcome.
        parts: XML files that the mission needs, for the trace.
        drawing: what pens draw is added to it.
        watch: called after each step; the events that it gives are recorded with those of the step.

    Raises:
        TraceError: the trace cannot be written.
    """
    drawing = Drawing() if drawing is None else drawing
    if trace is None and watch is not None:
        while simulation.outcome is None:
            simulation.step()
            drawing.add(simulation.drawn)
            watch()
            if _is_to_end(simulation, progress):
                break
        return simulation
    if trace is None:
        while simulation.outcome is None:
            simulation.advance(PROGRESS_STEPS - simulation.tick % PROGRESS_STEPS)
            drawing.add(simulation.drawn)
            if _is_to_end(simulation, progress):
                break
        return simulation
    recorder = Recorder(simulation, parts)
    with TraceWriter(trace, recorder.header) as writer:
        writer.record(recorder.record())
        while simulation.outcome is None:
            simulation.step()
            drawing.add(simulation.drawn)
            found = watch() if watch is not None else ()
            writer.record(recorder.record((*simulation.events, *found)))
            if _is_to_end(simulation, progress):
                break
        writer.finish(outcome_of(simulation))
    return simulation


def _is_to_end(simulation: Simulation, progress: Callable[[Simulation], bool | None] | None) -> bool:
    return progress is not None and simulation.tick % PROGRESS_STEPS == 0 and bool(progress(simulation))


def record_again(
    timeline: Timeline,
    simulation: Simulation,
    trace: Path,
    parts: Sequence[TracePart] = (),
    stop: Callable[[], bool] = lambda: False,
) -> None:
    """Records the whole past of a run, by running it once more with all that was done to it.

    Args:
        timeline: the run; it is not touched, and may go on meanwhile.
        simulation: the same mission, world and seed before its first step.
        trace: where to record it.
        parts: XML files that the mission needs.
        stop: asked at each step; when it says so the recording ends there.

    Raises:
        TraceError: the trace cannot be written.
    """
    recorder = Recorder(simulation, parts)
    with TraceWriter(trace, recorder.header) as writer:
        for happened in timeline.done_again(simulation):
            writer.record(recorder.record(happened))
            if stop():
                break
        writer.finish(outcome_of(simulation))
