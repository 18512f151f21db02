"""Notices a carrier that stands still in the dock."""

from __future__ import annotations

from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Setting, Stage, Standing, Values


class Presence(Sensor):
    """1 while a carrier of the right kind stands in the dock."""

    name = "presence"
    settings = (LATENCY, Setting("carrier", "any", "which carriers it notices", words=("any", "empty", "loaded")))
    needs = "dock"

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.wanted: list[str] = []
        self.dock: list[int] = []
        self.road: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.wanted.append(values.word("carrier"))
        self.dock.append(standing.dock)
        self.road.append(standing.road)
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        for device, wanted in enumerate(self.wanted):
            carrier = self.stage.carrier_in(self.stage.world.docks[self.dock[device]], self.road[device])
            loaded = carrier >= 0 and self.stage.bodies.load[carrier] > 0
            fits = carrier >= 0 and (wanted == "any" or loaded == (wanted == "loaded"))
            self.values[device] = 1 if fits else 0
