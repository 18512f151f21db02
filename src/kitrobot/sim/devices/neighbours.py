"""Counts the robots that hear it, and that it hears."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor
from kitrobot.sim.tables.columns import ENDED, PERIOD, S_LEAST, S_MOST, S_ROBOT, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.sim.team.radio import has_radio, is_on, neighbours


class Neighbours(Sensor):
    """The robots in reach of its radio; all others of the run in a mission without one."""

    name = "neighbours"
    settings = (LATENCY, LOST_READINGS, SPREAD)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Counts with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    ended = state.robots.ints[ENDED]
    period = state.robots.ints[PERIOD]
    by_radio = has_radio(state)
    others = -1
    for j in range(0 if by_radio else len(ended)):
        others += is_on(j, state)
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        found = neighbours(i, state) if by_radio else others if is_on(i, state) else 0
        sensor[S_VALUE][k] = max(sensor[S_LEAST][k], min(sensor[S_MOST][k], found))
