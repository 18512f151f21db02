"""The program file: what a board's loop needs to know of a robot's devices, and the image (docs/reference/link.md)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from kitrobot.deploy.errors import DeployError, PackageError
from kitrobot.deploy.package import PROGRAM, name_of
from kitrobot.image import Image, Layout
from kitrobot.primitives import Robot
from kitrobot_onboard.link import checksum

_FIRST = "KRP1"


class Device(NamedTuple):
    """A line of the table: `a` or `s`, the driver, and the words after it."""

    kind: str
    driver: str
    words: tuple[str, ...]


@dataclass(frozen=True)
class ProgramFile:
    """The devices, in the order of the robot's file, and an image's bytes."""

    devices: tuple[Device, ...]
    image: bytes

    @property
    def drivers(self) -> list[str]:
        """The drivers that it needs, each once."""
        return list(dict.fromkeys(device.driver for device in self.devices))

    def to_bytes(self, modules: Mapping[str, str] | None = None) -> bytes:
        """The file. `modules`: what the drivers are called on a board."""
        rows = [
            " ".join((kind, driver if modules is None else modules[driver], *words))
            for kind, driver, words in self.devices
        ]
        rest = "".join(f"{row}\n" for row in rows).encode() + b"\n" + self.image
        return f"{_FIRST} {checksum(rest)}\n".encode() + rest


def program_name(data: bytes) -> str:
    """The name of a program file by its content."""
    return name_of(data, PROGRAM)


def make_program_file(image: Image, robot: Robot) -> ProgramFile:
    """The program file of an image that was compiled for this robot.

    Raises:
        PackageError: a part of the robot names no driver and no device.
    """
    layout = Layout(robot)
    devices = []
    for part in (*robot.actuators, *robot.sensors):
        driver = part.board.driver or part.device
        if not driver or not driver.replace("-", "_").isidentifier():
            raise PackageError(
                f"`{part.name}` of the robot `{robot.name}` has no driver for a real board",
                f'write `<board driver="…"/>` into `{part.name}` in the XML of the robot `{robot.name}`',
            )
        settings = [f"{name}={value}" for name, value in part.board.settings.items()]
        if part.name in layout.sensors and part in robot.sensors:
            numbers = (layout.sensors[part.name], part.minimum, part.maximum)
            devices.append(Device("s", driver, (*map(str, numbers), *settings)))
        else:
            calls = [
                f"{method.name}/{len(method.parameters)}{'+' if method.completes_later else ''}"
                for method in part.methods
            ]
            words = (str(layout.done.get(part.name, "-")), ",".join(calls) or "-", *settings)
            devices.append(Device("a", driver, words))
    return ProgramFile(tuple(devices), image.to_bytes())


def read_program_file(data: bytes) -> ProgramFile:
    """Reads a program file.

    Raises:
        DeployError: it is damaged.
    """
    first, _, rest = data.partition(b"\n")
    text, blank, image = (b"\n" + rest).partition(b"\n\n")
    if first != f"{_FIRST} {checksum(rest)}".encode() or not blank:
        raise DeployError("this program file is damaged", "make it anew from the mission")
    devices = []
    for line in text.decode("utf-8", errors="replace").split("\n")[1:]:
        kind, driver, *words = line.split(" ")
        devices.append(Device(kind, driver, tuple(words)))
    return ProgramFile(tuple(devices), image)
