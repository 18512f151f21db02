"""Program files (docs/reference/link.md) for boards without hardware, from an image and its robot."""

from __future__ import annotations

from collections.abc import Callable

from kitrobot.image.machine import Layout
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot_onboard.link import checksum

Choose = Callable[[RobotObject], str]
"""A device's driver and its settings, as words."""


def program_file(image: bytes, devices: list[str]) -> bytes:
    """The file of an image and the lines of its devices."""
    body = "".join(line + "\n" for line in [*devices, ""]).encode() + image
    return f"KRP1 {checksum(body)}\n".encode() + body


def device_lines(robot: Robot, actuator: Choose, sensor: Choose) -> list[str]:
    """A line for each device of a robot."""
    layout = Layout(robot)
    lines = []
    for part in robot.actuators:
        driver, _, settings = actuator(part).partition(" ")
        procedures = ",".join(
            f"{method.name}/{len(method.parameters)}{'+' if method.completes_later else ''}" for method in part.methods
        )
        done = layout.done.get(part.name, "-")
        lines.append(" ".join(["a", driver, str(done), procedures or "-", settings]).rstrip())
    for part in robot.sensors:
        driver, _, settings = sensor(part).partition(" ")
        cell = layout.sensors[part.name]
        lines.append(f"s {driver} {cell} {part.minimum} {part.maximum} {settings}".rstrip())
    return lines


def hardwareless(image: Image, robot: Robot) -> bytes:
    """A program file whose drivers any board without hardware has."""
    return program_file(image.to_bytes(), device_lines(robot, lambda part: "stores", lambda part: "zero"))
