"""Random input scripts: what the sensors show and which actuators are done, tick by tick."""

from __future__ import annotations

import random
from typing import NamedTuple

from kitrobot.primitives.robot import Robot
from tests.strategies.programs import near


class TickInputs(NamedTuple):
    """What changes before a tick: sensor → value (also outside its range), actuator → done."""

    inputs: dict[str, int]
    done: dict[str, bool]


def random_script(rng: random.Random, robot: Robot, ticks: int) -> list[TickInputs]:
    """Inputs for that many ticks. How restless they are differs from script to script."""
    restless = rng.choice((0.02, 0.1, 0.3, 0.7))
    often_done = rng.choice((0.2, 0.5, 0.9))
    script = []
    for _ in range(ticks):
        inputs = {
            sensor.name: rng.choice(
                [*near(rng, sensor.minimum, sensor.maximum), sensor.minimum - 1, sensor.maximum + 1]
            )
            for sensor in robot.sensors
            if rng.random() < restless
        }
        done = {
            actuator.name: rng.random() < often_done
            for actuator in robot.actuators
            if has_done(robot, actuator.name) and rng.random() < restless
        }
        script.append(TickInputs(inputs, done))
    return script


def has_done(robot: Robot, actuator: str) -> bool:
    """Whether something of this actuator completes later, so that it has a done flag."""
    return any(method.completes_later for part in robot.actuators if part.name == actuator for method in part.methods)
