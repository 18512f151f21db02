"""A switch for something that the simulator does not know: it only remembers whether it is on."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Actuator, Stage, Standing, Values


class Switch(Actuator):
    """`SwitchOn()`, `SwitchOff()`; `on[k]` is 1 while it is on."""

    name = "switch"
    procedures = frozenset({"SwitchOn", "SwitchOff"})
    settings = (LATENCY,)

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.on: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.on.append(0)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        self.on[device] = 1 if procedure == "SwitchOn" else 0
