"""Notices another robot close by in the direction of travel."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import (
    ALARM,
    DIRECTED,
    ENDED,
    GAP_AHEAD,
    GAP_BEHIND,
    RADIUS,
    ROAD,
    S_P,
    S_ROBOT,
    S_VALUE,
    SPEED,
    TARGET,
    TOUCHING,
    UX,
    UY,
    X,
    Y,
)
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Setting, Values
from kitrobot.sim.sight import ray_to_discs

COLLISION_SENSOR = 3


class Collision(Sensor):
    """1 while a robot is nearer than `reach`, bumper to bumper along the road, or touches; 0 otherwise."""

    name = "collision"
    kind = COLLISION_SENSOR
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("reach", 120.0, "how far it looks in front of the bumper", "mm", 0.0, 100_000.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("reach"),)

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        whole[DIRECTED][robot] = 1


def sense_collisions(
    first: int,
    last: int,
    sensor: list[list[int]],
    sensor_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    frame: list[float],
    shape: list[int],
    starts: list[int],
    items: list[int],
    cells: list[int],
    exits: list[float],
) -> None:
    """Measures with the devices `first` … `last` - 1, and lights the alarm of their robots."""
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    reaches = sensor_real[S_P]
    ended = whole[ENDED]
    road = whole[ROAD]
    touching = whole[TOUCHING]
    alarm = whole[ALARM]
    speed = real[SPEED]
    target = real[TARGET]
    for k in range(first, last):
        i = robots[k]
        near = 0
        if ended[i] == 0:
            backwards = speed[i] < 0.0 or (speed[i] == 0.0 and target[i] < 0.0)
            if touching[i]:
                near = 1
            elif road[i] >= 0:
                if (real[GAP_BEHIND][i] if backwards else real[GAP_AHEAD][i]) <= reaches[k]:
                    near = 1
            elif len(items) > 0:
                side = -1.0 if backwards else 1.0
                reach = reaches[k] + real[RADIUS][i]
                far = ray_to_discs(
                    real[X][i],
                    real[Y][i],
                    side * real[UX][i],
                    side * real[UY][i],
                    reach + 1.0,
                    i,
                    real[X],
                    real[Y],
                    real[RADIUS],
                    frame,
                    shape,
                    starts,
                    items,
                    cells,
                    exits,
                )
                if far <= reach:
                    near = 1
        values[k] = near
        alarm[i] = near
