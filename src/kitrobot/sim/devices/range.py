"""Measures how far it is to the next wall or robot."""

from __future__ import annotations

import math

from kitrobot.primitives import RobotObject
from kitrobot.sim.angles import direction
from kitrobot.sim.columns import (
    DIRECTED,
    ENDED,
    PERIOD,
    RADIUS,
    S_LEAST,
    S_MOST,
    S_P,
    S_Q,
    S_R,
    S_ROBOT,
    S_VALUE,
    UX,
    UY,
    X,
    Y,
)
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor, Setting, Values
from kitrobot.sim.sight import ray_to_discs, ray_to_walls

RANGE = 9


class Range(Sensor):
    """From the sensor's least value (touching) to its largest (`reach` or more), in a straight line from the front."""

    name = "range"
    kind = RANGE
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("reach", 1000.0, "how far it sees", "mm", 1.0, 100_000.0),
        Setting("angle", 0.0, "where it looks, counter-clockwise from the front", "°", -360.0, 360.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("reach"), *direction(math.radians(values.number("angle"))))

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        whole[DIRECTED][robot] = 1


def sense_ranges(
    first: int,
    last: int,
    step: int,
    sensor: list[list[int]],
    sensor_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    walls: list[list[float]],
    wall_frame: list[float],
    wall_shape: list[int],
    wall_starts: list[int],
    wall_items: list[int],
    frame: list[float],
    shape: list[int],
    starts: list[int],
    items: list[int],
    cells: list[int],
    exits: list[float],
) -> None:
    """Measures with the devices `first` … `last` - 1. P is the reach, (Q, R) where it looks as seen from the robot."""
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    leasts = sensor[S_LEAST]
    mosts = sensor[S_MOST]
    reaches = sensor_real[S_P]
    cosines = sensor_real[S_Q]
    sines = sensor_real[S_R]
    xs = real[X]
    ys = real[Y]
    radii = real[RADIUS]
    ended = whole[ENDED]
    period = whole[PERIOD]
    for k in range(first, last):
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        ux = real[UX][i] * cosines[k] - real[UY][i] * sines[k]
        uy = real[UX][i] * sines[k] + real[UY][i] * cosines[k]
        most = ray_to_walls(
            xs[i],
            ys[i],
            ux,
            uy,
            reaches[k] + radii[i],
            walls,
            wall_frame,
            wall_shape,
            wall_starts,
            wall_items,
            cells,
            exits,
        )
        if len(items) > 0:
            most = ray_to_discs(xs[i], ys[i], ux, uy, most, i, xs, ys, radii, frame, shape, starts, items, cells, exits)
        most -= radii[i]
        if most < 0.0:
            most = 0.0
        values[k] = leasts[k] + int(most / reaches[k] * (mosts[k] - leasts[k]) + 0.5)
