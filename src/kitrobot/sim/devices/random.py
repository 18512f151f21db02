"""Gives random numbers, out of the run's seed."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Sensor
from kitrobot.sim.tables.columns import ENDED, PERIOD, S_KEY_A, S_KEY_B, S_LEAST, S_MOST, S_ROBOT, S_VALUE
from kitrobot.sim.tables.random_numbers import drawn
from kitrobot.sim.tables.state import State


class Random(Sensor):
    """A new number at each tick, from the sensor's least value to its largest, each as likely."""

    name = "random"
    restless = True
    settings = (LATENCY, LOST_READINGS)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1. The keys stand the other way round than where readings are lost,
    so the one chance has nothing to do with the other.
    """
    sensor = state.sensors.ints
    ints = state.robots.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    leasts = sensor[S_LEAST]
    ended = ints[ENDED]
    period = ints[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        several = sensor[S_MOST][k] - leasts[k] + 1
        values[k] = leasts[k] + drawn(sensor[S_KEY_B][k], sensor[S_KEY_A][k], step) % several
