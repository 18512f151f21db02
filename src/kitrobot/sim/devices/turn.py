"""A motor that turns the robot on the spot, counter-clockwise."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Actuator, Setting, Stage, Standing, Values


class Turn(Actuator):
    """`AbsoluteTurn(angle, speed)` turns by a part of a full turn, `Turn(speed)` goes on until `Stop()`; in percent."""

    name = "turn"
    procedures = frozenset({"AbsoluteTurn", "Turn", "Stop"})
    settings = (LATENCY, Setting("rate", 180.0, "full turning speed", "°/s", 1.0, 36_000.0))

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.full: list[float] = []
        self.rate: list[float] = []
        self.left: list[float] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.full.append(math.radians(values.number("rate")))
        self.rate.append(0.0)
        self.left.append(0.0)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        self.rate[device] = arguments[-1] / 100 * self.full[device] if arguments else 0.0
        self.left[device] = math.inf
        if procedure == "AbsoluteTurn":
            self.left[device] = arguments[0] / 100 * math.tau
            self.done[device] = 0
        else:
            self.done[device] = 1

    def move(self, dt: float) -> None:
        turn = self.stage.bodies.turn
        for device, robot in enumerate(self.robot):
            rate, left = self.rate[device], self.left[device]
            if self.done[device] and rate == 0.0:
                turn[robot] = 0.0
                continue
            turn[robot] = step = min(rate * dt, left)
            if left == math.inf:
                continue
            self.left[device] = left = left - step
            if left <= 1e-12:
                self.rate[device] = 0.0
                self.done[device] = 1

    def busy(self, device: int) -> bool:
        return self.rate[device] != 0.0
