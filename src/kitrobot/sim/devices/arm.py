"""An arm at a dock: moves one box between the storehouse of the dock and the carrier that stands there.

The box changes hands in one moment, at the end of the swing, and only when everything is as it should be: a carrier
stands still in the dock, with room (or a box), and the storehouse has a box. Else the arm comes back empty and says so.
Over a storehouse that is full it says so once, stays out, and puts the box down as soon as there is room. Boxes are
never made or lost.
"""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, MOVES_BOXES, Actuator, Command, Setting, Values
from kitrobot.sim.physics.docks import carrier_in
from kitrobot.sim.tables.columns import (
    A_ACTION,
    A_DOCK,
    A_DONE,
    A_NOISE,
    A_OWN,
    A_ROBOT,
    A_STORE,
    DELIVERED,
    DOWN,
    FAILED,
    LOAD,
    LOADED,
    NO_BOX,
    NO_EMPTY_CARRIER,
    NO_LOADED_CARRIER,
    NO_ROOM,
    ORIGIN,
    SIGN_ARM,
    SIGNS,
    UNLOADED,
    record_event,
)
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

BOX_S, REMAINING_S, WAITS_FOR_ROOM = A_OWN[:3]
"""Columns of an arm: the seconds a box takes, those left of this box, and 1 while it waits for room."""

_LOAD, _UNLOAD = range(2)


class Arm(Actuator):
    """`Load()` takes a box from the storehouse to the carrier, `Unload()` back. It waits while that is full."""

    name = "arm"
    handles = MOVES_BOXES
    procedures = ("Load", "Unload")
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("time", 2000.0, Sentence("how long one box takes"), "ms", 1.0, 3_600_000.0),
        Setting("noise", 0.0, Sentence("how far that time may be off (one standard deviation)"), "%", 0.0, 50.0),
    )
    needs = "dock"

    @classmethod
    def is_waiting_for_room(cls, k: int, state: State) -> bool:
        return bool(state.actuators.floats[WAITS_FOR_ROOM][k])

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("time") / 1000,)


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.1)
    actuator_floats[REMAINING_S][k] = actuator_floats[BOX_S][k] * factor
    actuator_floats[WAITS_FOR_ROOM][k] = 0.0
    actuator[A_ACTION][k] = command.procedure
    actuator[A_DONE][k] = 0
    state.robots.ints[SIGNS][actuator[A_ROBOT][k]] |= SIGN_ARM


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    ints = state.robots.ints
    stock = state.docks.stock
    capacity = state.docks.capacity
    events = state.events
    clock = state.clock
    done = actuator[A_DONE]
    down = ints[DOWN]
    for k in range(first, last):
        if done[k] or down[actuator[A_ROBOT][k]] == FAILED:
            continue
        if actuator_floats[WAITS_FOR_ROOM][k] == 0.0:
            left = actuator_floats[REMAINING_S][k] - dt
            actuator_floats[REMAINING_S][k] = left
            if left > 1e-9:
                continue
        robot = actuator[A_ROBOT][k]
        house = actuator[A_STORE][k]
        dock = actuator[A_DOCK][k]
        load = ints[LOAD]
        carrier = carrier_in(dock, state.robots, state.roads, state.docks)
        if actuator[A_ACTION][k] == _LOAD:
            if carrier < 0 or load[carrier]:
                record_event(events, clock, NO_EMPTY_CARRIER, robot, dock, 0)
            elif stock[house] == 0:
                record_event(events, clock, NO_BOX, robot, house, 0)
            else:
                stock[house] -= 1
                load[carrier] = 1
                ints[ORIGIN][carrier] = house + 1
                record_event(events, clock, LOADED, robot, house, 0)
        elif carrier < 0 or load[carrier] == 0:
            record_event(events, clock, NO_LOADED_CARRIER, robot, dock, 0)
        elif stock[house] >= capacity[house]:
            if actuator_floats[WAITS_FOR_ROOM][k] == 0.0:
                actuator_floats[WAITS_FOR_ROOM][k] = 1.0
                record_event(events, clock, NO_ROOM, robot, house, 0)
            continue
        else:
            stock[house] += 1
            load[carrier] = 0
            ints[DELIVERED][carrier] += 1
            record_event(events, clock, UNLOADED, robot, house, 0)
        actuator_floats[WAITS_FOR_ROOM][k] = 0.0
        done[k] = 1
        ints[SIGNS][robot] &= ~SIGN_ARM


def is_busy(k: int, state: State) -> bool:
    """Whether it moves; while it waits for room it does not."""
    return state.actuators.floats[WAITS_FOR_ROOM][k] == 0.0 and state.actuators.ints[A_DONE][k] == 0
