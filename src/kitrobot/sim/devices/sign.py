"""Reads the sign of the road section the robot is in."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Discrete, Sensor, Setting, Values
from kitrobot.sim.tables.columns import AT, CLOSED, CUT_FIRST, CUT_LAST, ROAD, S_OWN, S_ROBOT, S_SECTION, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

AHEAD = S_OWN[0]
"""Column of a sign reader: how far ahead it looks in mm."""


class Sign(Sensor):
    """The number of the section under the sensor; 0 on a road without sections."""

    name = "sign"
    discrete = Discrete.SECTION
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("ahead", 0.0, Sentence("how far in front of the robot's middle it looks"), "mm", -10_000.0, 10_000.0),
    )
    needs = "road"

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("ahead"),)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    floats = state.robots.floats
    ints = state.robots.ints
    roads = state.roads.ints
    road_length = state.roads.length
    cut_from = state.roads.cut_from
    cut_sign = state.roads.cut_sign
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    cuts = sensor[S_SECTION]
    aheads = state.sensors.floats[AHEAD]
    for k in range(first, last):
        i = robots[k]
        road = ints[ROAD][i]
        if road < 0:
            continue
        low = roads[CUT_FIRST][road]
        high = roads[CUT_LAST][road]
        if low == high:
            continue
        at = floats[AT][i] + aheads[k]
        if roads[CLOSED][road]:
            while at >= road_length[road]:
                at -= road_length[road]
            while at < 0.0:
                at += road_length[road]
        # It was in this section a moment ago: look there first.
        cut = cuts[k]
        if cut < low or cut >= high:
            cut = low
        while cut > low and at < cut_from[cut]:
            cut -= 1
        while cut + 1 < high and at >= cut_from[cut + 1]:
            cut += 1
        cuts[k] = cut
        values[k] = cut_sign[cut]
