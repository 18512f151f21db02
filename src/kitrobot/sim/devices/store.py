"""Counts the boxes in a storehouse."""

from __future__ import annotations

from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Stage, Standing, Values


class Store(Sensor):
    """The number of boxes in the storehouse where the robot starts, or whose dock it stands at."""

    name = "store"
    settings = (LATENCY,)
    needs = "storehouse"

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.storehouse: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.storehouse.append(standing.storehouse)
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        stock = self.stage.stock
        for device, storehouse in enumerate(self.storehouse):
            self.values[device] = stock[storehouse]
