"""The step of a world whose programs run elsewhere: each robot's `tick` is another process's, or a board's.

Such a host sends every robot the readings of its tick (`begin_hosted_step`), and puts the result of the tick back into
the tables with the next step (`finish_hosted_step`): where the program is, and its commands. The host also updates the
team's part of the tables; all that belongs to bodies is done here, by the functions and in the order of `step_loop`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from kitrobot.sim.physics.step import move
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.actuation import deliver_commands, issue_command
from kitrobot.sim.step.dispatch import AGREES, advance_all
from kitrobot.sim.step.step_loop import inject_faults, sample_sensors
from kitrobot.sim.tables.columns import A_FRESH, A_KIND, ACTUATOR_INDEX, DT, PROGRAM, TICK, WRITTEN, record_event
from kitrobot.sim.team.shared_variables import SHARED_VALUE


class TickResult(NamedTuple):
    """What came of a robot's tick.

    Attributes:
        cells, threads: the first of each, as they are after it: inputs and variables, and where its threads stand.
        out: the numbers of its commands, a row as wide as the machine's for each, with the number of the actuator
            before it.
    """

    cells: tuple[int, ...]
    threads: tuple[int, ...]
    out: tuple[tuple[int, ...], ...] = ()


def begin_hosted_step(simulation: Simulation) -> None:
    """What befalls robots at this step, then what their sensors measure; it is put into the cells of their machines."""
    state = simulation.state
    step = state.clock[TICK]
    inject_faults(step, state)
    sample_sensors(step, state)


def finish_hosted_step(simulation: Simulation, ticked: Mapping[int, Sequence[TickResult]]) -> None:
    """The rest of the step: devices take the commands, and bodies move.

    Args:
        simulation: a run that is stepped by this and `begin_hosted_step` alone, in turn.
        ticked: by the number of the robot, what came of its ticks since the last step, in their order. They must fit
            the robot (see `fits`).
    """
    state = simulation.state
    step = state.clock[TICK]
    for i, ticks in ticked.items():
        for one in ticks:
            _take_in(step, i, one, simulation)
    if len(state.actuators.late) > 0:
        deliver_commands(step, state)
    advance_all(state.fixed_floats[DT], state)
    move(state)
    state.clock[TICK] = step + 1


def fits(simulation: Simulation, robot: int, ticked: TickResult) -> bool:
    """Whether the numbers can be those of a tick of this robot."""
    machines, ints = simulation.state.machines, simulation.state.robots.ints
    machine = simulation.members[robot].machine
    parts, width = machines.parts[ints[PROGRAM][robot]], machine.width
    commands = machine.layout.commands
    return (
        len(ticked.cells) == machine.layout.cells
        and len(ticked.threads) == 2 * len(machine.image.slots)
        and all(-1 <= at < machine.image.instructions for at in ticked.threads[::2])
        and len(ticked.out) <= parts
        and all(
            len(row) == 1 + width
            and 0 <= row[0] < parts
            and 0 <= row[3] < len(commands)
            and commands[row[3]][0] == row[0]
            for row in ticked.out
        )
    )


def _take_in(step: int, i: int, ticked: TickResult, simulation: Simulation) -> None:
    """Puts what came of a tick into the tables, and its commands on their way."""
    state = simulation.state
    machines, ints = state.machines, state.robots.ints
    program = ints[PROGRAM][i]
    inputs = simulation.members[i].machine.layout.inputs
    # What its sensors read has gone on since.
    machines.cells[i][0] = ticked.cells[0]
    machines.cells[i][1 + inputs : len(ticked.cells)] = ticked.cells[1 + inputs :]
    machines.threads[i][: len(ticked.threads)] = ticked.threads
    out = machines.out[i]
    width = machines.pars[i][3]
    out[:] = [0] * len(out)
    for number, *row in ticked.out:
        at = number * width
        out[at : at + width] = row
        k = state.actuators.actuator_index[ints[ACTUATOR_INDEX][i] + number]
        if AGREES[state.actuators.ints[A_KIND][k]]:
            state.actuators.ints[A_FRESH][k] = step + 1
        else:
            issue_command(step, k, out[at + 2], out, at + 3, machines.commands[program], state)


def report_write(simulation: Simulation, robot: int, variable: int, value: int) -> None:
    """A robot wrote a shared variable; the copies of the others are what their machines say."""
    state = simulation.state
    state.shared.ints[SHARED_VALUE][variable] = value
    record_event(state.events, state.clock, WRITTEN, robot, variable, value)
