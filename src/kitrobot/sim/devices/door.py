"""A door that takes its time."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Actuator, Setting, Stage, Standing, Values


class Door(Actuator):
    """`Open()` and `Close()`; `place[k]` goes from 0 (closed) to 1 (open)."""

    name = "door"
    procedures = frozenset({"Open", "Close"})
    settings = (LATENCY, Setting("time", 1000.0, "how long it takes from closed to open", "ms", 1.0, 3_600_000.0))

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.place: list[float] = []
        self.goal: list[float] = []
        self.seconds: list[float] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.place.append(0.0)
        self.goal.append(0.0)
        self.seconds.append(values.number("time") / 1000)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        self.goal[device] = 1.0 if procedure == "Open" else 0.0
        self.done[device] = 0

    def move(self, dt: float) -> None:
        for device in range(len(self.robot)):
            if self.done[device]:
                continue
            way, step = self.goal[device] - self.place[device], dt / self.seconds[device]
            if abs(way) <= step + 1e-12:
                self.place[device] = self.goal[device]
                self.done[device] = 1
            else:
                self.place[device] += step if way > 0 else -step
