"""Sees the colour of the floor."""

from __future__ import annotations

import math
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Setting, Stage, Standing, Values
from kitrobot.sim.sight import distance_to_path
from kitrobot.world import COLOURS


class Colour(Sensor):
    """The number of the coloured line under it (1 red, 2 green, 3 blue), or 0; the last line is on top."""

    name = "colour"
    settings = (
        LATENCY,
        Setting("ahead", 0.0, "how far in front of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
        Setting("side", 0.0, "how far to the left of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
    )

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.ahead: list[float] = []
        self.side: list[float] = []
        self.lines = [
            (COLOURS[line.colour], line.width_mm / 2, list(line.line.xs), list(line.line.ys))
            for line in reversed(stage.world.lines)
        ]

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.ahead.append(values.number("ahead"))
        self.side.append(values.number("side"))
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        bodies = self.stage.bodies
        for device, robot in enumerate(self.robot):
            self.values[device] = 0
            if not self.lines:
                continue
            ux, uy = math.cos(bodies.heading[robot]), math.sin(bodies.heading[robot])
            x = bodies.x[robot] + self.ahead[device] * ux - self.side[device] * uy
            y = bodies.y[robot] + self.ahead[device] * uy + self.side[device] * ux
            for colour, half, xs, ys in self.lines:
                if distance_to_path(x, y, xs, ys, 0, len(xs) - 1) <= half:
                    self.values[device] = colour
                    break
