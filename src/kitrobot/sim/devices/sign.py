"""Reads the sign of the road section the robot is in."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import AT, ROAD, S_CUT, S_P, S_ROBOT, S_VALUE
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.physics import CLOSED, CUT_FIRST, CUT_LAST

SIGN = 10


class Sign(Sensor):
    """The number of the section under the sensor; 0 on a road without sections."""

    name = "sign"
    kind = SIGN
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("ahead", 0.0, "how far in front of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
    )
    needs = "road"

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("ahead"),)


def sense_signs(
    first: int,
    last: int,
    sensor: list[list[int]],
    sensor_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    roads: list[list[int]],
    road_length: list[float],
    cut_from: list[float],
    cut_sign: list[int],
) -> None:
    """Measures with the devices `first` … `last` - 1. P is how far ahead it looks."""
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    cuts = sensor[S_CUT]
    aheads = sensor_real[S_P]
    for k in range(first, last):
        i = robots[k]
        road = whole[ROAD][i]
        if road < 0:
            continue
        low = roads[CUT_FIRST][road]
        high = roads[CUT_LAST][road]
        if low == high:
            continue
        at = real[AT][i] + aheads[k]
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
