"""Counts the boxes in a storehouse."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor

STORE = 11


class Store(Sensor):
    """The number of boxes in the storehouse where the robot starts, or whose dock it stands at."""

    name = "store"
    kind = STORE
    settings = (LATENCY, LOST_READINGS, SPREAD)
    needs = "storehouse"


def sense_stores(first: int, last: int, houses: list[int], stock: list[int], values: list[int]) -> None:
    """Measures with the devices `first` … `last` - 1."""
    for k in range(first, last):
        values[k] = stock[houses[k]]
