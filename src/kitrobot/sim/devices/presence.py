"""Notices a carrier that stands still in the dock."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Discrete, Sensor, Setting, Values
from kitrobot.sim.physics.docks import carrier_in
from kitrobot.sim.tables.columns import LOAD, S_DOCK, S_OWN, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

WANTED_LOAD = S_OWN[0]
"""Column of a presence sensor: the load that it waits for, 0, 1, or 2 for any."""

ANY, EMPTY, LOADED = "any", "empty", "loaded"


class Presence(Sensor):
    """1 while a carrier of the right kind stands in the dock."""

    name = "presence"
    discrete = Discrete.VISIT
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("carrier", ANY, Sentence("which carriers it notices"), words=(ANY, EMPTY, LOADED)),
    )
    needs = "dock"

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (float((EMPTY, LOADED, ANY).index(values.word("carrier"))),)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    values = sensor[S_VALUE]
    in_docks = sensor[S_DOCK]
    wanted = state.sensors.floats[WANTED_LOAD]
    load = state.robots.ints[LOAD]
    for k in range(first, last):
        carrier = carrier_in(in_docks[k], state.robots, state.roads, state.docks)
        value = 0
        if carrier >= 0 and (wanted[k] == 2.0 or wanted[k] == load[carrier]):
            value = 1
        values[k] = value
