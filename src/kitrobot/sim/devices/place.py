"""How far it is to a named place of the world: a beacon, a charger, a storehouse."""

from __future__ import annotations

import math
from collections.abc import Sequence

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.tables.columns import ENDED, PERIOD, S_FIRST, S_LEAST, S_MOST, S_OWN, S_ROBOT, S_VALUE, X, Y
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence
from kitrobot.world.model import World

REACH, IS_BOOLEAN = S_OWN[:2]
"""Columns of a place sensor: how far it reaches in mm, and 1 for a boolean one."""


class PlaceSensor(Sensor):
    """From the sensor's least value at a place to its largest `reach` away; a boolean one is 1 within `reach`."""

    name = "place"
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting(
            "of",
            "",
            Sentence("the name of a storehouse, dock or start of the world"),
            Sentence("the name of a storehouse, dock or start"),
            reads=bool,
            required=True,
            names_place=True,
        ),
        Setting("reach", 300.0, Sentence("how far away it is noticed"), "mm", 1.0, 100_000.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return values.number("reach"), 1.0 if part.type == "boolean" else 0.0

    @classmethod
    def table(cls, part: RobotObject, values: Values, world: World) -> Sequence[float]:
        return world.places[values.word("of")]


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1, from the middle of the robot.

    The table is the rectangle of the place: its left, lower, right and upper edge.
    """
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    reaches = state.sensors.floats[REACH]
    within = state.sensors.floats[IS_BOOLEAN]
    numbers = state.sensors.numbers
    xs = state.robots.floats[X]
    ys = state.robots.floats[Y]
    ended = state.robots.ints[ENDED]
    period = state.robots.ints[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        at = sensor[S_FIRST][k]
        dx = max(numbers[at] - xs[i], 0.0, xs[i] - numbers[at + 2])
        dy = max(numbers[at + 1] - ys[i], 0.0, ys[i] - numbers[at + 3])
        away = math.sqrt(dx * dx + dy * dy)
        least = sensor[S_LEAST][k]
        most = sensor[S_MOST][k]
        if within[k] > 0.0:
            values[k] = most if away <= reaches[k] else least
        elif away >= reaches[k]:
            values[k] = most
        else:
            values[k] = least + int(away / reaches[k] * (most - least) + 0.5)
