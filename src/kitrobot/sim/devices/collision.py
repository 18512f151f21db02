"""Notices another robot close by in the direction of travel."""

from __future__ import annotations

import math
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.bodies import FREE
from kitrobot.sim.devices.base import LATENCY, Sensor, Setting, Stage, Standing, Values
from kitrobot.sim.sight import ray_to_discs


class Collision(Sensor):
    """1 while a robot is nearer than `reach`, bumper to bumper along the road, or touches; 0 otherwise."""

    name = "collision"
    settings = (LATENCY, Setting("reach", 120.0, "how far it looks in front of the bumper", "mm", 0.0, 100_000.0))

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.reach: list[float] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.reach.append(values.number("reach"))
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        bodies = self.stage.bodies
        for device, robot in enumerate(self.robot):
            backwards = bodies.speed[robot] < 0.0 or (bodies.speed[robot] == 0.0 and bodies.target[robot] < 0.0)
            reach = self.reach[device]
            if bodies.road[robot] == FREE:
                angle = bodies.heading[robot] + (math.pi if backwards else 0.0)
                radius, x, y = bodies.radius[robot], bodies.x[robot], bodies.y[robot]
                far = ray_to_discs(
                    x, y, angle, reach + radius + 1, robot, bodies.x, bodies.y, bodies.radius, bodies.solid
                )
                near = far - radius <= reach
            else:
                near = (bodies.gap_behind[robot] if backwards else bodies.gap_ahead[robot]) <= reach
            self.values[device] = bodies.alarm[robot] = 1 if near or bodies.touching[robot] else 0
