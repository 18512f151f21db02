"""A kit: what a robot can be built of, and how the parts of a robot are wired on it. One robot fits many kits.

Representation: frozen values, in the order of the file. A `KitPart` says of which parts of robots it speaks: those of
its category whose device it names and, where it says them, whose name is one of its names and whose settings hold what
`when` says. The one that says most of a part counts, of two the first.

Left to others: reading the XML (kit_xml), which drivers there are and what they understand (deploy).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

from kitrobot.diagnostics.model import Place
from kitrobot.primitives.robot import Board, Category, Robot, RobotObject, Texts

FAMILIES_OF_BOARDS = ("machine", "microbit")
"""What kinds of boards there are: those with the module `machine`, and the micro:bit."""

CHIP_OF_V2 = "nrf52833"
"""The chip of a micro:bit V2."""

CHIPS = ("esp32", CHIP_OF_V2, "rp2040", "rp2350")
"""Chips whose pins are not alike, or share what makes square waves, and that of the micro:bit V2."""

LARGEST_PIN = 127
"""The largest number of a pin."""


class KitEvidence(StrEnum):
    """How it is known that a kit works as its file says."""

    DOCUMENTS = "documents"
    EMULATOR = "emulator"
    HAND = "hand"


@dataclass(frozen=True)
class KitPart:
    """How parts of some devices are wired, or (`is_missing`) that the kit has nothing for them.

    `devices` are names of devices of robots, one at least; `names` those of parts, none for any; `when` is a setting of
    the robot's part as `guide=road`, "" for any. `help` says what it is or why there is none.
    """

    category: Category
    devices: tuple[str, ...]
    names: tuple[str, ...] = ()
    when: str = ""
    board: Board = field(default_factory=Board)
    is_missing: bool = False
    help: Texts = field(default_factory=dict)
    place: Place | None = field(default=None, compare=False, repr=False)

    def speaks_of(self, part: RobotObject) -> bool:
        """Whether it says how that part is wired."""
        meant = part.category is self.category and part.device in self.devices
        name, _, value = self.when.partition("=")
        return meant and (not self.names or part.name in self.names) and (not name or part.settings.get(name) == value)


@dataclass(frozen=True)
class Source:
    """A document that says how the kit is wired: `href` is its address."""

    href: str
    text: str


@dataclass(frozen=True)
class Measurement:
    """How parts of these devices were measured on the floor: settings of the devices of the simulator."""

    devices: tuple[str, ...]
    settings: Mapping[str, str]


@dataclass(frozen=True)
class Wire:
    """A wire of a module: from its terminal, named as printed on it, to a pin of the board (`14`, `3V3`) or to a
    terminal of another module (`batteries +`).
    """

    terminal: str
    to: str


@dataclass(frozen=True)
class Module:
    """A thing that a person holds and wires, such as a motor board; `label` is its name by language."""

    name: str
    wires: tuple[Wire, ...]
    label: Texts = field(default_factory=dict)


@dataclass(frozen=True)
class Kit:
    """A kit.

    Args:
        name: of the kit.
        family: the kind of its board.
        pins: the pins that there are, numbers and names as texts; none where that is not known.
        chip: the kind of chip of its board, one of `CHIPS`; "" for another one.
        micropython: the least version of its firmware, as `1.20`; "" where any does.
        firmware: the page of its maker where that is to be had, "" where none is known.
        parts: how parts are wired, in the order of the file.
        tried: how it is known to work; `tried_by`: who reported it.
        sources: the documents that it is made from.
        supplies: what is needed to build it, and `steps`: what is done then; by language each.
        modules: what is wired to its board, for whoever builds it.
        measured: how its parts were measured.
        unknown: XML of its file that nobody knows, comments among it, kept word for word.
        prolog: what stands before the first element of its file.
        attributes: those of the first element with a prefix.
        place: where its name stands in its file.
    """

    name: str
    family: str
    pins: tuple[str, ...] = ()
    micropython: str = ""
    parts: tuple[KitPart, ...] = ()
    tried: KitEvidence = KitEvidence.DOCUMENTS
    tried_by: str = ""
    sources: tuple[Source, ...] = ()
    supplies: tuple[Texts, ...] = ()
    steps: tuple[Texts, ...] = ()
    modules: tuple[Module, ...] = ()
    measured: tuple[Measurement, ...] = ()
    firmware: str = ""
    chip: str = ""
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    place: Place | None = field(default=None, compare=False, repr=False)
    unknown: tuple[str, ...] = ()
    prolog: tuple[str, ...] = ()
    attributes: Mapping[str, str] = field(default_factory=dict)

    def part_for(self, part: RobotObject) -> KitPart | None:
        """What it says of a robot's part; None when it says nothing."""
        found = [one for one in self.parts if one.speaks_of(part)]
        return max(found, key=lambda one: bool(one.names) + bool(one.when)) if found else None


def on_kit(robot: Robot, kit: Kit) -> Robot:
    """The robot with its parts wired as the kit says. A part that the kit lacks stays as it is."""

    def wired(part: RobotObject) -> RobotObject:
        found = kit.part_for(part)
        if found is None or found.is_missing:
            return part
        return replace(part, board=replace(found.board, driver=found.board.driver or part.device))

    actuators = tuple(wired(part) for part in robot.actuators)
    return replace(robot, actuators=actuators, sensors=tuple(wired(part) for part in robot.sensors))


def as_measured(robot: Robot, kit: Kit) -> Robot:
    """The robot whose parts are, for the simulator, as they were measured on the kit."""

    def on_floor(part: RobotObject) -> RobotObject:
        known = {
            name: value for one in kit.measured if part.device in one.devices for name, value in one.settings.items()
        }
        return replace(part, settings={**part.settings, **known}) if known and part.model == part.device else part

    actuators = tuple(map(on_floor, robot.actuators))
    return replace(robot, actuators=actuators, sensors=tuple(map(on_floor, robot.sensors)))


def lacks(kit: Kit, part: RobotObject) -> bool:
    """Whether a kit has nothing for a part of a robot that needs a driver. Chance and what a team says need no part."""
    found = kit.part_for(part)
    return found.is_missing if found is not None else part.device not in PARTLESS


OF_A_TEAM = frozenset({"team", "work"})
"""Devices that speak for a robot's team."""

PARTLESS = frozenset({"random"}) | OF_A_TEAM
"""Devices that are no parts: every board has them."""
