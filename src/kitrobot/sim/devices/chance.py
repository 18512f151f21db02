"""A yes or no out of the run's seed, drawn anew at regular times."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Sensor, Setting, Values
from kitrobot.sim.tables.columns import DT, ENDED, PERIOD, S_KEY_A, S_KEY_B, S_LEAST, S_MOST, S_OWN, S_ROBOT, S_VALUE
from kitrobot.sim.tables.random_numbers import happens
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

PROBABILITY, PERIOD_S = S_OWN[:2]
"""Columns of a chance sensor: the probability (0…1), and the period in s."""


class Chance(Sensor):
    """The sensor's largest number with a probability, else its least; drawn anew after each period."""

    name = "chance"
    restless = True
    settings = (
        LATENCY,
        LOST_READINGS,
        Setting("probability", 50.0, Sentence("how often it reads its largest number"), "%", 0.0, 100.0),
        Setting("period", 1000.0, Sentence("how long a number stays"), "ms", 1.0, 3_600_000.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return values.part("probability"), values.number("period") / 1000


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    probabilities = state.sensors.floats[PROBABILITY]
    periods = state.sensors.floats[PERIOD_S]
    ended = state.robots.ints[ENDED]
    period = state.robots.ints[PERIOD]
    time = step * state.fixed_floats[DT]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        draw = int(time / periods[k] + 1e-9)
        # The keys are in the other order than for lost readings, so that the two are independent.
        if happens(sensor[S_KEY_B][k], sensor[S_KEY_A][k], draw, probabilities[k]):
            values[k] = sensor[S_MOST][k]
        else:
            values[k] = sensor[S_LEAST][k]
