"""Gives random numbers, out of the run's seed."""

from __future__ import annotations

from kitrobot.sim.chance import drawn
from kitrobot.sim.columns import ENDED, PERIOD, S_KEY_A, S_KEY_B, S_LEAST, S_MOST, S_ROBOT, S_VALUE
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Sensor

RANDOM = 8


class Random(Sensor):
    """A new number at each tick, from the sensor's least value to its largest, each as likely."""

    name = "random"
    kind = RANDOM
    restless = True
    settings = (LATENCY, LOST_READINGS)


def sense_randoms(first: int, last: int, step: int, sensor: list[list[int]], whole: list[list[int]]) -> None:
    """Measures with the devices `first` … `last` - 1. The keys stand the other way round than where readings are lost,
    so the one chance has nothing to do with the other.
    """
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    leasts = sensor[S_LEAST]
    ended = whole[ENDED]
    period = whole[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        several = sensor[S_MOST][k] - leasts[k] + 1
        values[k] = leasts[k] + drawn(sensor[S_KEY_B][k], sensor[S_KEY_A][k], step) % several
