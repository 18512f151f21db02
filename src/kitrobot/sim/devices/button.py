"""A button at the bumper."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, Sensor


class Button(Sensor):
    """1 while the robot touches a wall or another robot."""

    name = "button"
    settings = (LATENCY,)

    def sense(self) -> None:
        touching = self.stage.bodies.touching
        for device, robot in enumerate(self.robot):
            self.values[device] = touching[robot]
