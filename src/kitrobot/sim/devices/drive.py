"""Wheels: drive the robot forward and back, along its road or freely; they also say how large the robot is."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.bodies import FREE
from kitrobot.sim.devices.base import LATENCY, Actuator, Setting, Stage, Standing, Values


class Drive(Actuator):
    """`Advance(speed)`, `Reverse(speed)` in percent of full speed, `Stop()`."""

    name = "drive"
    procedures = frozenset({"Advance", "Reverse", "Stop"})
    settings = (
        LATENCY,
        Setting("speed", 400.0, "full speed", "mm/s", 1.0, 100_000.0),
        Setting("acceleration", 800.0, "how fast it gains speed", "mm/s²", 1.0),
        Setting("braking", 800.0, "how fast it loses speed", "mm/s²", 1.0),
        Setting("length", 135.0, "the robot's length", "mm", 1.0, 10_000.0),
        Setting("width", 95.0, "the robot's width", "mm", 1.0, 10_000.0),
        Setting("guide", "free", "what leads it", words=("free", "road")),
        Setting("noise", 0.0, "how far a speed may be off (one standard deviation)", "%", 0.0, 50.0),
    )

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.speed: list[float] = []
        self.noise: list[float] = []
        self.chance: list[Random] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        bodies = self.stage.bodies
        bodies.acceleration[robot] = values.number("acceleration")
        bodies.braking[robot] = values.number("braking")
        bodies.length[robot] = values.number("length")
        bodies.radius[robot] = values.number("length") / 2
        bodies.solid[robot] = 1
        if values.word("guide") == "road":
            # Robots on different roads keep only their widths apart, else a bend would count as a crash.
            bodies.radius[robot] = values.number("width") / 2
        else:
            bodies.road[robot] = FREE
        self.speed.append(values.number("speed"))
        self.noise.append(values.number("noise") / 100)
        self.chance.append(chance)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        speed = 0.0
        if procedure != "Stop":
            speed = arguments[0] / 100 * self.speed[device]
            if self.noise[device] and speed:
                speed *= max(0.0, 1 + self.chance[device].gauss(0.0, self.noise[device]))
        self.stage.bodies.target[self.robot[device]] = -speed if procedure == "Reverse" else speed

    def busy(self, device: int) -> bool:
        bodies, robot = self.stage.bodies, self.robot[device]
        return bodies.speed[robot] != 0.0 or bodies.target[robot] != 0.0
