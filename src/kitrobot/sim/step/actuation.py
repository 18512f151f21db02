"""Actuation: passes the machines' commands to the devices, delayed or dropped as their settings say.

Repeated commands are dropped, except those that take longer than a tick. A delayed command is kept in its device's
queue: the step at which it is due, its procedure (the device's number for it), whether
it takes longer, how many arguments it has, and the first, second and last of them, which is all that devices read.
"""

from __future__ import annotations

from kitrobot.sim.devices.base import Command
from kitrobot.sim.step.dispatch import is_busy, start
from kitrobot.sim.tables.columns import (
    A_DELAY,
    A_DRAWS,
    A_DROPOUT,
    A_FRESH,
    A_HEAD,
    A_KEY_A,
    A_KEY_B,
    A_NOISE,
    A_QUEUE,
    A_QUEUED,
    A_QUEUED_LATER,
    A_ROBOT,
    A_SIZE,
    A_TAKEN,
    DOWN,
    FAILED,
    LOST,
    SPEED,
    record_event,
)
from kitrobot.sim.tables.random_numbers import gauss, happens
from kitrobot.sim.tables.state import State

QUEUE = 7
"""Numbers a queued command has."""

COMMAND = 3
"""Numbers in `commands` for each command of a program: the device's procedure, how many arguments, takes longer?"""


def issue_command(step: int, k: int, number: int, out: list[int], at: int, commands: list[int], state: State) -> None:
    """Sends command `number` of a machine, its arguments at `out[at]`, on its way to actuator k."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    taken = state.actuators.takens[k]
    procedure = commands[COMMAND * number]
    count = commands[COMMAND * number + 1]
    later = commands[COMMAND * number + 2]
    again = later == 0 and actuator[A_TAKEN][k] == number
    if again:
        for n in range(count):
            if taken[n] != out[at + n]:
                again = False
    if again:
        return
    if actuator_floats[A_DROPOUT][k] > 0.0:
        lost = happens(actuator[A_KEY_A][k], actuator[A_KEY_B][k], actuator[A_DRAWS][k], actuator_floats[A_DROPOUT][k])
        actuator[A_DRAWS][k] += 1
        if lost:
            record_event(state.events, state.clock, LOST, actuator[A_ROBOT][k], k, 0)
            return
    actuator[A_TAKEN][k] = number
    actuator[A_FRESH][k] = step + 1
    for n in range(count):
        taken[n] = out[at + n]
    first = out[at] if count > 0 else 0
    second = out[at + 1] if count > 1 else 0
    last = out[at + count - 1] if count > 0 else 0
    if actuator[A_DELAY][k] == 0:
        execute_command(k, Command(procedure, count, first, second, last), state)
        return
    queue = state.actuators.queue
    size = actuator[A_SIZE][k]
    q = actuator[A_QUEUE][k] + QUEUE * ((actuator[A_HEAD][k] + actuator[A_QUEUED][k]) % size)
    queue[q] = step + actuator[A_DELAY][k]
    queue[q + 1] = procedure
    queue[q + 2] = later
    queue[q + 3] = count
    queue[q + 4] = first
    queue[q + 5] = second
    queue[q + 6] = last
    actuator[A_QUEUED][k] += 1
    actuator[A_QUEUED_LATER][k] += later


def execute_command(k: int, command: Command, state: State) -> None:
    """Actuator k begins to do what a command says, in place of what it did before."""
    actuator = state.actuators.ints
    deviate = 0.0
    if state.actuators.floats[A_NOISE][k] > 0.0:
        deviate = gauss(actuator[A_KEY_A][k], actuator[A_KEY_B][k], actuator[A_DRAWS][k])
        actuator[A_DRAWS][k] += 3
    start(k, command, deviate, state)


def deliver_commands(step: int, state: State) -> None:
    """Hands over the commands whose time has come; those to a failed robot wait."""
    late = state.actuators.late
    actuator = state.actuators.ints
    queue = state.actuators.queue
    down = state.robots.ints[DOWN]
    for n in range(len(late)):
        k = late[n]
        while actuator[A_QUEUED][k] > 0 and down[actuator[A_ROBOT][k]] != FAILED:
            q = actuator[A_QUEUE][k] + QUEUE * actuator[A_HEAD][k]
            if queue[q] > step:
                break
            actuator[A_HEAD][k] = (actuator[A_HEAD][k] + 1) % actuator[A_SIZE][k]
            actuator[A_QUEUED][k] -= 1
            actuator[A_QUEUED_LATER][k] -= queue[q + 2]
            execute_command(k, Command(queue[q + 1], queue[q + 3], queue[q + 4], queue[q + 5], queue[q + 6]), state)


def busy(k: int, state: State) -> bool:
    """Whether actuator k will change something without a new command, or one is on its way to it."""
    actuator = state.actuators.ints
    i = actuator[A_ROBOT][k]
    if state.robots.ints[DOWN][i] == FAILED:
        return state.robots.floats[SPEED][i] != 0.0
    if actuator[A_QUEUED][k] > 0:
        return True
    return is_busy(k, state)
