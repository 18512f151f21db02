"""From the commands of the machines to what the devices do: late or lost, as their settings say.

A command that says again what a device took last is no news and goes no further, unless it is one that takes longer.
A command that is late waits in its device's queue: when it is due, its procedure (the device's number for it), whether
it takes longer, how many arguments it has, and the first, second and last of them, which is all that devices read.
"""

from __future__ import annotations

from kitrobot.sim.chance import gauss, happens
from kitrobot.sim.columns import (
    A_DELAY,
    A_DONE,
    A_DRAWS,
    A_DROPOUT,
    A_FRESH,
    A_HEAD,
    A_KEY_A,
    A_KEY_B,
    A_KIND,
    A_NOISE,
    A_Q,
    A_QUEUE,
    A_QUEUED,
    A_QUEUED_LATER,
    A_R,
    A_ROBOT,
    A_SIZE,
    A_TAKEN,
    ARM,
    DOWN,
    FAILED,
    LAMP,
    LOST,
    SPEED,
    TARGET,
    tell,
)
from kitrobot.sim.devices.arm import ARM_DEVICE, take_arm
from kitrobot.sim.devices.display import DISPLAY, take_display
from kitrobot.sim.devices.door import DOOR, take_door
from kitrobot.sim.devices.drive import DRIVE, take_drive
from kitrobot.sim.devices.lamp import LAMP_DEVICE, take_lamp
from kitrobot.sim.devices.music import MUSIC, take_music
from kitrobot.sim.devices.pin_out import PIN_OUT, take_pin_out
from kitrobot.sim.devices.switch import SWITCH, take_switch
from kitrobot.sim.devices.turn import TURN_DEVICE, take_turn
from kitrobot.sim.devices.wheel import WHEEL_DEVICE, take_wheel

QUEUE = 7
"""Numbers a queued command has."""

COMMAND = 3
"""Numbers in `commands` for each command of a program: the device's procedure, how many arguments, takes longer?"""


def give(
    step: int,
    k: int,
    number: int,
    out: list[int],
    at: int,
    commands: list[int],
    taken: list[int],
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    faces: list[list[int]],
    queue: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Sends command `number` of a machine, its arguments at `out[at]`, on its way to actuator k.

    `taken` are the arguments that the actuator took last.
    """
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
    if actuator_real[A_DROPOUT][k] > 0.0:
        lost = happens(actuator[A_KEY_A][k], actuator[A_KEY_B][k], actuator[A_DRAWS][k], actuator_real[A_DROPOUT][k])
        actuator[A_DRAWS][k] += 1
        if lost:
            tell(events, clock, LOST, actuator[A_ROBOT][k], k, 0)
            return
    actuator[A_TAKEN][k] = number
    actuator[A_FRESH][k] = step + 1
    for n in range(count):
        taken[n] = out[at + n]
    first = out[at] if count > 0 else 0
    second = out[at + 1] if count > 1 else 0
    last = out[at + count - 1] if count > 0 else 0
    if actuator[A_DELAY][k] == 0:
        take(k, procedure, count, first, second, last, actuator, actuator_real, real, whole, faces)
        return
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


def take(
    k: int,
    procedure: int,
    count: int,
    first: int,
    second: int,
    last: int,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    faces: list[list[int]],
) -> None:
    """Actuator k begins to do what a command says, in place of what it did before."""
    deviate = 0.0
    if actuator_real[A_NOISE][k] > 0.0:
        deviate = gauss(actuator[A_KEY_A][k], actuator[A_KEY_B][k], actuator[A_DRAWS][k])
        actuator[A_DRAWS][k] += 3
    kind = actuator[A_KIND][k]
    if kind == DRIVE:
        take_drive(k, procedure, first, deviate, actuator, actuator_real, real[TARGET])
    elif kind == TURN_DEVICE:
        take_turn(k, procedure, count, first, last, deviate, actuator, actuator_real)
    elif kind == LAMP_DEVICE:
        take_lamp(actuator[A_ROBOT][k], procedure, whole[LAMP])
    elif kind == SWITCH:
        take_switch(k, procedure, actuator)
    elif kind == DOOR:
        take_door(k, procedure, deviate, actuator, actuator_real)
    elif kind == WHEEL_DEVICE:
        take_wheel(k, procedure, first, deviate, actuator_real)
    elif kind == ARM_DEVICE:
        take_arm(k, procedure, deviate, actuator, actuator_real, whole[ARM])
    elif kind == DISPLAY:
        take_display(k, procedure, first, second, last, actuator, actuator_real, faces[k])
    elif kind == MUSIC:
        take_music(k, procedure, count, first, last, actuator, actuator_real, faces[k])
    elif kind == PIN_OUT:
        take_pin_out(procedure, first, faces[k])


def deliver(
    step: int,
    late: list[int],
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    faces: list[list[int]],
    queue: list[int],
) -> None:
    """Hands over the commands whose time has come; those to a failed robot wait."""
    down = whole[DOWN]
    for n in range(len(late)):
        k = late[n]
        while actuator[A_QUEUED][k] > 0 and down[actuator[A_ROBOT][k]] != FAILED:
            q = actuator[A_QUEUE][k] + QUEUE * actuator[A_HEAD][k]
            if queue[q] > step:
                break
            actuator[A_HEAD][k] = (actuator[A_HEAD][k] + 1) % actuator[A_SIZE][k]
            actuator[A_QUEUED][k] -= 1
            actuator[A_QUEUED_LATER][k] -= queue[q + 2]
            take(
                k,
                queue[q + 1],
                queue[q + 3],
                queue[q + 4],
                queue[q + 5],
                queue[q + 6],
                actuator,
                actuator_real,
                real,
                whole,
                faces,
            )


def busy(
    k: int,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
) -> bool:
    """Whether actuator k will change something without a new command, or one is on its way to it."""
    i = actuator[A_ROBOT][k]
    if whole[DOWN][i] == FAILED:
        return real[SPEED][i] != 0.0
    if actuator[A_QUEUED][k] > 0:
        return True
    kind = actuator[A_KIND][k]
    if kind == TURN_DEVICE:
        # A turn at speed 0 is never done, and nothing comes of it.
        return actuator_real[A_Q][k] != 0.0
    if kind == WHEEL_DEVICE:
        return actuator_real[A_Q][k] != 0.0 or actuator_real[A_R][k] != 0.0
    if kind == DRIVE:
        return real[SPEED][i] != 0.0 or real[TARGET][i] != 0.0
    if kind == ARM_DEVICE and actuator_real[A_R][k] != 0.0:
        # It waits for room in a storehouse.
        return False
    return actuator[A_DONE][k] == 0
