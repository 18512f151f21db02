"""The program file: what a board's loop needs of a robot's devices, and the image (docs/reference/link.md).

It holds only what the program uses: an unused device costs no memory on the board, and its pins stay free, so that one
pin may be an output in one program and an input in another.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from kitrobot.deploy.errors import DeployError, PackageError
from kitrobot.deploy.minification.tree_shaking import UsedParts
from kitrobot.deploy.package.content_names import PROGRAM, TEAM_DRIVER, name_of
from kitrobot.image.instructions import ACT, BY_NUMBER, Role
from kitrobot.image.machine import Layout
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.text.sentences import Sentence
from kitrobot_onboard.link import checksum

_FIRST = "KRP1"
LIMIT_S = 30
"""How long a device may take to be done, when it does not say."""

UNUSED = "unused"
"""The driver of an actuator that the program gives no command."""


class Device(NamedTuple):
    """A line of the table: `a` or `s`, the driver, and the words after it; and the name of the robot's part. `t` says
    that the robot is a member of a team, which ticks when its host asks for it.
    """

    kind: str
    driver: str
    words: tuple[str, ...]
    part: str = ""


@dataclass(frozen=True)
class ProgramFile:
    """The devices, in the order of the robot's file, and an image's bytes."""

    devices: tuple[Device, ...]
    image: bytes

    @cached_property
    def commands(self) -> list[tuple[int, str, int, bool]]:
        """Each command: its device's place in `devices`, its name, how many arguments it has, whether it takes longer.

        A name is empty where the program never gives the command.
        """
        given = used(Image.from_bytes(self.image))[1]
        found: list[tuple[int, str, int, bool]] = []
        for place, device in enumerate(self.devices):
            if device.kind == "a" and device.words[1] != "-":
                for call in device.words[1].split(","):
                    name, _, count = call.partition("/")
                    known = name if len(found) in given else ""
                    found.append((place, known, int(count.rstrip("+")), count.endswith("+")))
        return found

    @property
    def is_member(self) -> bool:
        """Whether it is the program of a member of a team."""
        return any(device.kind == "t" for device in self.devices)

    @property
    def used_actuators(self) -> list[int]:
        """The numbers of the robot's actuators that the program uses."""
        drivers = [device.driver for device in self.devices if device.kind == "a"]
        return [number for number, driver in enumerate(drivers) if driver != UNUSED]

    @property
    def drivers(self) -> dict[str, UsedParts]:
        """The drivers that it needs, and what of them."""
        found: dict[str, UsedParts] = {}
        for device in self.devices:
            if device.driver != UNUSED:
                given = (word.partition("=") for word in device.words if "=" in word)
                used = UsedParts(settings=frozenset((name, value) for name, _, value in given))
                found[device.driver] = found.get(device.driver, UsedParts()) | used
        for place, name, _, later in self.commands:
            if name:
                found[self.devices[place].driver] |= UsedParts(frozenset([name]), later)
        return found

    def to_bytes(self) -> bytes:
        """The file."""
        rows = [" ".join((kind, driver, *words)) for kind, driver, words, _ in self.devices]
        rest = "".join(f"{row}\n" for row in rows).encode() + b"\n" + self.image
        return f"{_FIRST} {checksum(rest)}\n".encode() + rest


def program_name(data: bytes) -> str:
    """The name of a program file by its content."""
    return name_of(data, PROGRAM)


def make_program_file(image: Image, robot: Robot, *, all_devices: bool = False, member: bool = False) -> ProgramFile:
    """The program file of an image that was compiled for this robot.

    `all_devices`: those that the program does not use too. `member`: it is to be one of a team.

    Raises:
        PackageError: a part of the robot that is used names no driver and no device.
    """
    layout = Layout(robot)
    cells, commands = used(image)
    devices = []
    for number, part in enumerate(robot.actuators):
        mine = {at for at, actuator in enumerate(image.commands) if actuator == number}
        if all_devices or mine & commands:
            calls = [
                f"{method.name}/{len(method.parameters)}{'+' if method.completes_later else ''}"
                for method in part.methods
            ]
            done = str(layout.done.get(part.name, "-"))
            devices.append(
                Device("a", _driver(part, robot), (done, ",".join(calls) or "-", *_settings(part)), part.name)
            )
        else:
            # Commands are numbered through, so each keeps its place.
            devices.append(Device("a", UNUSED, ("-", ",".join(["-/0"] * len(mine)) or "-"), part.name))
    for part in robot.sensors:
        cell = layout.sensors[part.name]
        if all_devices or cell in cells:
            words = (str(cell), str(part.minimum), str(part.maximum), *_settings(part))
            devices.append(Device("s", _driver(part, robot), words, part.name))
    if member:
        devices.append(Device("t", TEAM_DRIVER, ()))
    return ProgramFile(tuple(devices), image.to_bytes())


def used(image: Image) -> tuple[set[int], set[int]]:
    """The cells that a program reads, and the commands that it can give."""
    cells: set[int] = set()
    commands = {stop.command for stop in image.stops}
    for at in range(0, len(image.code), 4):
        number, *operands = image.code[at : at + 4]
        op = BY_NUMBER[number]
        for role, operand in zip((op.a, op.b, op.c), operands, strict=True):
            if role is Role.READ:
                cells.add(operand)
            elif role is Role.COMMAND:
                commands.add(operand)
        if number == ACT:
            cells.update(range(operands[1], operands[1] + operands[2]))
    return cells, commands


def _driver(part: RobotObject, robot: Robot) -> str:
    driver = part.board.driver or part.device
    if not driver or not driver.replace("-", "_").isidentifier():
        raise PackageError(
            Sentence("`{part}` of the robot `{robot}` has no driver for a real board", part.name, robot.name),
            Sentence(
                'write `<board driver="…"/>` into `{part}` in the XML of the robot `{robot}`', part.name, robot.name
            ),
        )
    return driver


def _settings(part: RobotObject) -> list[str]:
    return [f"{name}={value}" for name, value in part.board.settings.items()]


def read_program_file(data: bytes) -> ProgramFile:
    """Reads a program file.

    Raises:
        DeployError: it is damaged.
    """
    first, _, rest = data.partition(b"\n")
    text, blank, image = (b"\n" + rest).partition(b"\n\n")
    if first != f"{_FIRST} {checksum(rest)}".encode() or not blank:
        raise DeployError(Sentence("this program file is damaged"), Sentence("make it anew from the mission"))
    devices = []
    for line in text.decode("utf-8", errors="replace").split("\n")[1:]:
        kind, driver, *words = line.split(" ")
        devices.append(Device(kind, driver, tuple(words)))
    return ProgramFile(tuple(devices), image)
