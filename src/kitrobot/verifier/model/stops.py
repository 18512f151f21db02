"""Whether the action that a marked action (`°…°`) started is stopped when its parallel is over.

The interpreter posts the stop that the robot's XML names, in the tick in which the parallel is over. The stop gives way
to another branch that commands the same actuator in that tick: the actuator then goes on, by that command, until it is
stopped. This module reads the interpreter's arrays (`kitrobot_onboard.interpreter`), in a model and in a run alike.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.image.instructions import ARM
from kitrobot.image.machine import Machine


def stops_in(armed: Sequence[int], machine: Machine) -> tuple[int, int]:
    """What the tick that a machine just made did to actuators with stops, as bits by the actuators' numbers.

    Args:
        armed: `Machine.pars` before the tick.
        machine: the machine after it.

    Returns:
        Those that were told to stop, or something else that a marked action holds; and those whose stop gave way.
    """
    image, pars, out = machine.image, machine.pars, machine.out
    if not image.stops:
        return 0, 0
    first = 4 + 4 * len(image.slots) + 5 * len(image.parallels)
    commands = first + 3 * len(image.stops)
    stop_of: dict[int, set[int]] = {}
    held, over = set(), set()
    for number in range(len(image.stops)):
        row = first + 3 * number
        place = int(pars[commands + pars[row + 2]])
        stop_of.setdefault(place, set()).add(int(pars[row + 2]))
        if pars[row]:
            held.add(place)
        elif armed[row] or _ran(machine, number):
            over.add(place)
    stopped = left = 0
    for place, stops in stop_of.items():
        if not out[place]:
            continue
        bit = 1 << place // machine.width
        if place in held or out[place + 2] in stops:
            stopped |= bit
        elif place in over:
            left |= bit
    return stopped, left


def _ran(machine: Machine, stop: int) -> bool:
    """Whether the marked action of a stop began in this tick; False where nobody watches which instructions run."""
    code = machine.image.code
    return any(ran and code[4 * pc] == ARM and code[4 * pc + 1] == stop for pc, ran in enumerate(machine.seen))
