"""Notices a box on the bed of the robot; a robot with this sensor has a bed and can be loaded."""

from __future__ import annotations

from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Standing, Values


class Cargo(Sensor):
    """1 while a box lies on the bed."""

    name = "cargo"
    settings = (LATENCY,)

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.stage.bodies.bed[robot] = 1
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        load = self.stage.bodies.load
        for device, robot in enumerate(self.robot):
            self.values[device] = load[robot]
