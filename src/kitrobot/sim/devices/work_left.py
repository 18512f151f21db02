"""Reads how many units of a work of the team are not done."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Discrete, Sensor, Values
from kitrobot.sim.devices.work import NUMBER
from kitrobot.sim.tables.columns import S_OWN, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import W_LEFT

WORK = S_OWN[0]
"""Column: the number of the work."""


class WorkLeft(Sensor):
    """The units of a work that are not done."""

    name = "work"
    settings = (LATENCY, LOST_READINGS, NUMBER)
    discrete = Discrete.TEAM

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("number"),)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    works = state.sensors.floats[WORK]
    left = state.team.works[W_LEFT]
    for k in range(first, last):
        w = int(works[k])
        if w < len(left):
            sensor[S_VALUE][k] = left[w]
