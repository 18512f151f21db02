"""Feels the zones of the world: how warm, how loud, how bright it is where the robot is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.tables.columns import ENDED, PERIOD, S_END, S_FIRST, S_LEAST, S_MOST, S_OWN, S_ROBOT, S_VALUE, X, Y
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence
from kitrobot.world.model import BRIGHT, LOUD, WARM, World

AMBIENT, IS_BOOLEAN = S_OWN[:2]
"""Columns of a zone sensor: what it measures far from all zones, and 1 for a boolean one."""

_NUMBERS = 7
"""How many numbers a zone has in the table: its middle, half of width and height, radius, value, falloff."""

_ELSEWHERE = Sentence("what it measures far from all zones")


class _ZoneSensor(Sensor):
    """What all three have in common. Walls and robots keep nothing off, and of several zones the one that changes most
    counts. A boolean sensor is 1 inside a zone.
    """

    zone: ClassVar[str] = ""

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return values.number("ambient"), 1.0 if part.type == "boolean" else 0.0

    @classmethod
    def table(cls, part: RobotObject, values: Values, world: World) -> Sequence[float]:
        numbers: list[float] = []
        for one in world.zones:
            if one.kind == cls.zone:
                numbers += one.x_mm, one.y_mm, one.width_mm / 2, one.height_mm / 2
                numbers += one.radius_mm, one.value, one.falloff_mm
        return numbers


class Temperature(_ZoneSensor):
    """How warm it is in °C: `ambient`, and in warm zones what they say."""

    name = "temperature"
    zone = WARM
    settings = (LATENCY, LOST_READINGS, SPREAD, Setting("ambient", 20.0, _ELSEWHERE, "°C", 0.0, 100.0))


class Sound(_ZoneSensor):
    """How loud it is in percent: `ambient`, and in loud zones what they say."""

    name = "sound"
    zone = LOUD
    settings = (LATENCY, LOST_READINGS, SPREAD, Setting("ambient", 0.0, _ELSEWHERE, "%", 0.0, 100.0))


class Brightness(_ZoneSensor):
    """How bright it is in percent: `ambient`, and in bright zones what they say."""

    name = "brightness"
    zone = BRIGHT
    settings = (LATENCY, LOST_READINGS, SPREAD, Setting("ambient", 0.0, _ELSEWHERE, "%", 0.0, 100.0))


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1, at the middle of the robot.

    The table is the zones of their kind.
    """
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    ambients = state.sensors.floats[AMBIENT]
    inside = state.sensors.floats[IS_BOOLEAN]
    numbers = state.sensors.numbers
    xs = state.robots.floats[X]
    ys = state.robots.floats[Y]
    ended = state.robots.ints[ENDED]
    period = state.robots.ints[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        change = 0.0
        nearest = 1.0
        for at in range(sensor[S_FIRST][k], sensor[S_END][k], _NUMBERS):
            dx = max(abs(xs[i] - numbers[at]) - numbers[at + 2], 0.0)
            dy = max(abs(ys[i] - numbers[at + 1]) - numbers[at + 3], 0.0)
            off = math.sqrt(dx * dx + dy * dy) - numbers[at + 4]
            nearest = min(nearest, off)
            if off < numbers[at + 6] or off <= 0.0:
                here = numbers[at + 5] - ambients[k]
                if off > 0.0:
                    here *= 1.0 - off / numbers[at + 6]
                if abs(here) > abs(change):
                    change = here
        least = sensor[S_LEAST][k]
        most = sensor[S_MOST][k]
        if inside[k] > 0.0:
            values[k] = most if nearest <= 0.0 else least
        else:
            values[k] = min(max(math.floor(ambients[k] + change + 0.5), least), most)
