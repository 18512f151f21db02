"""Counts the boxes in a storehouse."""

from __future__ import annotations

from kitrobot.sim.devices.base import COUNTS_BOXES, LATENCY, LOST_READINGS, SPREAD, Discrete, Sensor
from kitrobot.sim.tables.columns import S_STORE, S_VALUE
from kitrobot.sim.tables.state import State


class Store(Sensor):
    """The number of boxes in the storehouse where the robot starts, or whose dock it stands at."""

    name = "store"
    discrete = Discrete.EXACT
    handles = COUNTS_BOXES
    settings = (LATENCY, LOST_READINGS, SPREAD)
    needs = "storehouse"


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    houses = sensor[S_STORE]
    values = sensor[S_VALUE]
    stock = state.docks.stock
    for k in range(first, last):
        values[k] = stock[houses[k]]
