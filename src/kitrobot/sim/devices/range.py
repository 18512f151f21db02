"""Measures how far it is to the next wall or robot."""

from __future__ import annotations

import math
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Setting, Stage, Standing, Values
from kitrobot.sim.sight import ray_to_discs, ray_to_walls


class Range(Sensor):
    """From the sensor's least value (touching) to its largest (`reach` or more), in a straight line from the front."""

    name = "range"
    settings = (
        LATENCY,
        Setting("reach", 1000.0, "how far it sees", "mm", 1.0, 100_000.0),
        Setting("angle", 0.0, "where it looks, counter-clockwise from the front", "°", -360.0, 360.0),
        Setting("noise", 0.0, "how far a reading may be off (one standard deviation)", "", 0.0, 1000.0),
    )

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.reach: list[float] = []
        self.angle: list[float] = []
        self.least: list[int] = []
        self.most: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.reach.append(values.number("reach"))
        self.angle.append(math.radians(values.number("angle")))
        self.least.append(part.minimum)
        self.most.append(part.maximum)
        return super().add(robot, part, values, standing, chance)

    def distance_mm(self, device: int) -> float:
        """From the edge of the robot to what it sees, `reach` at most."""
        stage, robot = self.stage, self.robot[device]
        bodies = stage.bodies
        x, y, radius = bodies.x[robot], bodies.y[robot], bodies.radius[robot]
        angle, most = bodies.heading[robot] + self.angle[device], self.reach[device] + radius
        most = ray_to_walls(x, y, angle, most, stage.wall_x1, stage.wall_y1, stage.wall_x2, stage.wall_y2)
        most = ray_to_discs(x, y, angle, most, robot, bodies.x, bodies.y, bodies.radius, bodies.solid)
        return max(0.0, most - radius)

    def sense(self) -> None:
        for device in range(len(self.robot)):
            part = self.distance_mm(device) / self.reach[device]
            least, most = self.least[device], self.most[device]
            self.values[device] = least + int(part * (most - least) + 0.5)
