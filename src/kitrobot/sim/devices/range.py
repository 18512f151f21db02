"""Measures how far it is to the next wall, robot or thing."""

from __future__ import annotations

import math

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.physics.angles import direction
from kitrobot.sim.physics.pushable import ray_to_pushables
from kitrobot.sim.physics.sight import ray_to_discs, ray_to_walls
from kitrobot.sim.tables.columns import (
    DIRECTED,
    ENDED,
    PERIOD,
    RADIUS,
    S_LEAST,
    S_MOST,
    S_OWN,
    S_ROBOT,
    S_VALUE,
    UX,
    UY,
    X,
    Y,
)
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

REACH, COSINE, SINE = S_OWN
"""Columns of a range sensor: how far it reaches in mm, and cosine and sine of its direction as seen from the robot."""


class Range(Sensor):
    """From the sensor's least value (touching) to its largest (`reach` or more), in a straight line from the front."""

    name = "range"
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("reach", 1000.0, Sentence("how far it sees"), "mm", 1.0, 100_000.0),
        Setting("angle", 0.0, Sentence("where it looks, counter-clockwise from the front"), "°", -360.0, 360.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("reach"), *direction(math.radians(values.number("angle"))))

    @classmethod
    def ray(cls, values: Values) -> tuple[float, float] | None:
        return values.number("reach"), math.radians(values.number("angle"))

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        ints[DIRECTED][robot] = 1

    @classmethod
    def sees_robots(cls, on_road: bool) -> bool:
        return True


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    sensor_floats = state.sensors.floats
    floats = state.robots.floats
    ints = state.robots.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    leasts = sensor[S_LEAST]
    mosts = sensor[S_MOST]
    reaches = sensor_floats[REACH]
    cosines = sensor_floats[COSINE]
    sines = sensor_floats[SINE]
    xs = floats[X]
    ys = floats[Y]
    radii = floats[RADIUS]
    ended = ints[ENDED]
    period = ints[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        ux = floats[UX][i] * cosines[k] - floats[UY][i] * sines[k]
        uy = floats[UX][i] * sines[k] + floats[UY][i] * cosines[k]
        most = ray_to_walls(xs[i], ys[i], ux, uy, reaches[k] + radii[i], state.walls, state.rays)
        if len(state.grid.items) > 0:
            most = ray_to_discs(i, ux, uy, most, state.robots, state.grid, state.rays)
        if len(state.pushables.floats[0]) > 0:
            most = ray_to_pushables(xs[i], ys[i], ux, uy, most, state.pushables)
        most -= radii[i]
        if most < 0.0:
            most = 0.0
        values[k] = leasts[k] + int(most / reaches[k] * (mosts[k] - leasts[k]) + 0.5)
