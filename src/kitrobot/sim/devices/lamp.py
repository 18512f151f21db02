"""A lamp on the robot, for everybody to see."""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.sim.devices.base import LATENCY, Actuator


class Lamp(Actuator):
    """`LightOn()`, `LightOff()`."""

    name = "lamp"
    procedures = frozenset({"LightOn", "LightOff"})
    settings = (LATENCY,)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        self.stage.bodies.lamp[self.robot[device]] = 1 if procedure == "LightOn" else 0
