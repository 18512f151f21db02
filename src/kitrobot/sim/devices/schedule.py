"""Numbers at times that are known before the run: day and night, the temperature of a kiln."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.tables.columns import DT, ENDED, PERIOD, S_END, S_FIRST, S_OWN, S_ROBOT, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence
from kitrobot.world.model import World

IS_LINE, PERIOD_S = S_OWN[:2]
"""Columns of a schedule: 1 for a line between its points, and its period in s, 0 for none."""

_MOST_MOMENTS = 1000
_MOST_VALUE = 1e9


def _read(text: str) -> list[tuple[float, float]] | None:
    """`0:20 5:30.5` → [(0, 20), (5, 30.5)]; None unless times are rising from 0 on."""
    moments = []
    for word in text.split()[: _MOST_MOMENTS + 1]:
        time, colon, value = word.partition(":")
        try:
            moment = (float(time), float(value))
        except ValueError:
            return None
        if not colon or not all(math.isfinite(number) and abs(number) <= _MOST_VALUE for number in moment):
            return None
        moments.append(moment)
    rising = all(one[0] < other[0] for one, other in pairwise(moments))
    return moments if moments and len(moments) <= _MOST_MOMENTS and moments[0][0] >= 0 and rising else None


class Schedule(Sensor):
    """The numbers of `values` at their times: each stays until the next (`steps`) or goes there evenly (`line`)."""

    name = "schedule"
    restless = True
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting(
            "values",
            "",
            Sentence("numbers at seconds, as in 0:20 5:30 9.5:25"),
            Sentence("1 to 1000 seconds:number pairs in the order of time, such as 0:20 5:30"),
            reads=lambda text: _read(text) is not None,
            required=True,
        ),
        Setting("between", "steps", Sentence("how it goes from one number to the next"), words=("steps", "line")),
        Setting("repeat", 0.0, Sentence("after how long it begins anew; 0 for never"), "s", 0.0, 1_000_000.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return 1.0 if values.says("between", "line") else 0.0, values.number("repeat")

    @classmethod
    def table(cls, part: RobotObject, values: Values, world: World) -> Sequence[float]:
        return [number for moment in _read(values.word("values")) or () for number in moment]


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1. The table holds time
    and number in turn.
    """
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    lines = state.sensors.floats[IS_LINE]
    periods = state.sensors.floats[PERIOD_S]
    numbers = state.sensors.numbers
    ended = state.robots.ints[ENDED]
    period = state.robots.ints[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        time = step * state.fixed_floats[DT]
        if periods[k] > 0.0:
            time -= int(time / periods[k] + 1e-9) * periods[k]
        at = sensor[S_FIRST][k]
        end = sensor[S_END][k]
        while at + 2 < end and numbers[at + 2] <= time + 1e-9:
            at += 2
        value = numbers[at + 1]
        if lines[k] > 0.0 and at + 2 < end and time > numbers[at]:
            share = (time - numbers[at]) / (numbers[at + 2] - numbers[at])
            value += share * (numbers[at + 3] - value)
        values[k] = math.floor(value + 0.5)
