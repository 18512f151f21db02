"""Reads the sign of the road section the robot is in."""

from __future__ import annotations

from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Sensor, Setting, Stage, Standing, Values


class Sign(Sensor):
    """The number of the section under the sensor; 0 on a road without sections."""

    name = "sign"
    settings = (
        LATENCY,
        Setting("ahead", 0.0, "how far in front of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
        Setting("noise", 0.0, "how far a reading may be off (one standard deviation)", "", 0.0, 1000.0),
    )
    needs = "road"

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.ahead: list[float] = []
        self.cut: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.ahead.append(values.number("ahead"))
        self.cut.append(0)
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        bodies, ways = self.stage.bodies, self.stage.ways
        for device, robot in enumerate(self.robot):
            road = bodies.road[robot]
            if road < 0:
                continue
            first, last = ways.cut_first[road], ways.cut_last[road]
            if first == last:
                continue
            at = bodies.at[robot] + self.ahead[device]
            if ways.closed[road]:
                at %= ways.length[road]
            # It was in this section a moment ago: look there first.
            cut = self.cut[device]
            if not first <= cut < last:
                cut = first
            while cut > first and at < ways.cut_from[cut]:
                cut -= 1
            while cut + 1 < last and at >= ways.cut_from[cut + 1]:
                cut += 1
            self.cut[device] = cut
            self.values[device] = ways.cut_sign[cut]
