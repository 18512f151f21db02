"""Notices another robot close by in the direction of travel."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Discrete, Sensor, Setting, Values
from kitrobot.sim.physics.sight import ray_to_discs
from kitrobot.sim.physics.wall_contacts import TOUCH_MM
from kitrobot.sim.tables.columns import (
    DIRECTED,
    ENDED,
    GAP_AHEAD,
    GAP_BEHIND,
    RADIUS,
    ROAD,
    S_OWN,
    S_ROBOT,
    S_VALUE,
    SIGN_ALARM,
    SIGNS,
    SPEED,
    TARGET,
    TOUCHING,
    UX,
    UY,
)
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

REACH = S_OWN[0]
"""Column of a collision sensor: how far it reaches in mm."""


class Collision(Sensor):
    """1 while a robot is nearer than `reach`, bumper to bumper along the road, or touches; 0 otherwise.

    On a road a robot that touches it from behind does not press it: the way ahead is free.
    """

    name = "collision"
    discrete = Discrete.GAP
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("reach", 120.0, Sentence("how far it looks in front of the bumper"), "mm", 0.0, 100_000.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("reach"),)

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        ints[DIRECTED][robot] = 1

    @classmethod
    def sees_robots(cls, on_road: bool) -> bool:
        return not on_road


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1, and lights the alarm of their robots."""
    sensor = state.sensors.ints
    floats = state.robots.floats
    ints = state.robots.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    reaches = state.sensors.floats[REACH]
    ended = ints[ENDED]
    road = ints[ROAD]
    touching = ints[TOUCHING]
    signs = ints[SIGNS]
    speed = floats[SPEED]
    target = floats[TARGET]
    for k in range(first, last):
        i = robots[k]
        near = 0
        if ended[i] == 0:
            backwards = speed[i] < 0.0 or (speed[i] == 0.0 and target[i] < 0.0)
            if road[i] >= 0:
                ahead = floats[GAP_BEHIND][i] if backwards else floats[GAP_AHEAD][i]
                behind = floats[GAP_AHEAD][i] if backwards else floats[GAP_BEHIND][i]
                if ahead <= reaches[k] or ahead <= TOUCH_MM or (touching[i] and behind > TOUCH_MM):
                    near = 1
            elif touching[i]:
                near = 1
            elif len(state.grid.items) > 0:
                side = -1.0 if backwards else 1.0
                reach = reaches[k] + floats[RADIUS][i]
                ux = side * floats[UX][i]
                uy = side * floats[UY][i]
                far = ray_to_discs(i, ux, uy, reach + 1.0, state.robots, state.grid, state.rays)
                if far <= reach:
                    near = 1
        values[k] = near
        signs[i] = signs[i] & ~SIGN_ALARM | SIGN_ALARM * near
