"""Reads what the team agreed (see meetings)."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Discrete, Sensor
from kitrobot.sim.tables.columns import S_ROBOT, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import T_ANSWER


class TeamAnswer(Sensor):
    """The last answer of the team."""

    name = "team"
    settings = (LATENCY, LOST_READINGS)
    discrete = Discrete.TEAM


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    answers = state.team.robots[T_ANSWER]
    if len(answers) > 0:
        for k in range(first, last):
            sensor[S_VALUE][k] = answers[sensor[S_ROBOT][k]]
