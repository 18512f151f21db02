"""Notices a carrier that stands still in the dock."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import LOAD, S_DOCK, S_P, S_VALUE
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Setting, Values
from kitrobot.sim.docks import carrier_in

PRESENCE = 7
ANY, EMPTY, LOADED = "any", "empty", "loaded"


class Presence(Sensor):
    """1 while a carrier of the right kind stands in the dock."""

    name = "presence"
    kind = PRESENCE
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("carrier", ANY, "which carriers it notices", words=(ANY, EMPTY, LOADED)),
    )
    needs = "dock"

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (float((EMPTY, LOADED, ANY).index(values.word("carrier"))),)


def sense_presence(
    first: int,
    last: int,
    sensor: list[list[int]],
    sensor_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    carriers: list[int],
    docks: list[list[float]],
    dock_road: list[int],
    road_length: list[float],
    closed: list[int],
) -> None:
    """Measures with the devices `first` … `last` - 1. P is the load it wants: 0, 1, or 2 for any."""
    values = sensor[S_VALUE]
    in_docks = sensor[S_DOCK]
    wanted = sensor_real[S_P]
    load = whole[LOAD]
    for k in range(first, last):
        carrier = carrier_in(in_docks[k], real, whole, carriers, docks, dock_road, road_length, closed)
        value = 0
        if carrier >= 0 and (wanted[k] == 2.0 or wanted[k] == load[carrier]):
            value = 1
        values[k] = value
