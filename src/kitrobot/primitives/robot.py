"""A robot as its XML describes it: objects (actuators, sensors, variables), their methods, and their parameters.

Representation: frozen values, in the order of the file, because order has meaning: commands are handed out in the order
of the actuators, cells are numbered in the order of sensors and variables. Two objects may share a name when their
categories differ (the paper's Light is an actuator and a sensor), so a name is looked up together with its method.

Left to others: reading the XML (robot_xml), the meaning of a call (compiler), the behaviour of a device (sim, drivers).
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from kitrobot.diagnostics.model import Place
from kitrobot.primitives.levels import Level
from kitrobot.primitives.meaning import Meaning

LARGEST_VALUE = 2**29 - 1
"""How far from zero a number of a robot may lie: the sum of two still fits the word of the smallest board (31 bits)."""

LAST_PLACE = 1000
"""The place in its tab of the palette of a part that gives none: after all that do, in the order of the file."""

LONGEST_SETTING = 60
"""Characters of a driver's name, of the name of one of its settings and of its value, at most."""

MOST_SETTINGS = 24
"""Settings of one driver, at most."""

Texts = Mapping[str, str]
"""Language tag → text; the empty tag is the default (English)."""

SearchWords = Mapping[str, tuple[str, ...]]
"""Language tag → the words that find a part in the palette, besides its names."""


class Category(StrEnum):
    """What part of a robot an object is."""

    ACTUATOR = "actuator"
    SENSOR = "sensor"
    VARIABLE = "variable"
    SYSTEM = "system"


class Kind(StrEnum):
    """What a method gives: an instruction, true or false, or a number."""

    PROCEDURE = "procedure"
    TEST = "test"
    VALUE = "value"


class ValueType(StrEnum):
    """What a variable holds or a parameter takes."""

    INTEGER = "integer"
    BOOLEAN = "boolean"


@dataclass(frozen=True)
class Parameter:
    """One parameter of a method: whole numbers `minimum`…`maximum` (both included)."""

    name: str
    minimum: int = field(metadata={"alias": "min"})
    maximum: int = field(metadata={"alias": "max"})
    default: int
    type: ValueType = field(default=ValueType.INTEGER, metadata={"alias": "kind"})
    unit: str = ""
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    meaning: Meaning | None = None


@dataclass(frozen=True)
class Method:
    """A procedure of an actuator, an operation of a sensor, or what every variable offers.

    `action` says what a procedure of a variable or of the system does: set, add, sub, clear ("" for a device command).
    `test` is equal, less or greater for a test; `to` is the number it compares with when that is not a parameter.
    `stop` names the procedure that ends the effect of this one (for a marked action), or None. `place` is where it
    stands in the robot's file, None where it stands in none. `alone`: its label says all, without the object's name.
    `group` is its tab of the palette ("": that of its object), `order` its place there; `words` find it.
    """

    name: str
    kind: Kind
    parameters: tuple[Parameter, ...] = ()
    completes_later: bool = False
    stop: str | None = None
    action: str = ""
    test: str = ""
    to: int | None = None
    icon: str = ""
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    phrase: Texts = field(default_factory=dict)
    alone: bool = False
    group: str = ""
    order: int = LAST_PLACE
    words: SearchWords = field(default_factory=dict)
    place: Place | None = field(default=None, compare=False, repr=False)

    @property
    def is_limited(self) -> bool:
        """Whether its parameters must be in their ranges: a device and a variable hold nothing else. A test may compare
        with any number.
        """
        return self.kind is Kind.PROCEDURE and self.action in ("", "set")


@dataclass(frozen=True)
class Board:
    """What the driver of a real robot is told about a part: which driver it is, and its settings (pins and the like).

    The settings are in the order of the file. Names and values are one to `LONGEST_SETTING` printable characters
    without spaces, `=` and `"`, so that `name=value` can stand in a line whose words are parted by spaces; no more than
    `MOST_SETTINGS` of them. A driver that the file names is a word of ASCII letters, digits, `_` and `-`; without one
    it is the device, which may be any text.
    """

    driver: str = ""
    settings: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class RobotObject:
    """A part of the robot: `minimum`…`maximum` is the range of a sensor's or variable's value.

    `model` is the device of the simulator that stands for it, the `device` itself unless `<simulate>` names another,
    and `settings` are its settings. `board` is what the driver of a real robot is told. Variables and the system have
    no model and no driver. `place` is where an actuator or a sensor stands in the robot's file. `unit` and `meaning`
    are those of a sensor's number. `group` is its tab of the palette ("": that of its category); `words` find its
    methods there.
    """

    name: str
    category: Category
    methods: tuple[Method, ...]
    device: str = ""
    model: str = ""
    settings: Mapping[str, str] = field(default_factory=dict)
    board: Board = field(default_factory=Board)
    type: ValueType = ValueType.INTEGER
    minimum: int = 0
    maximum: int = 0
    initial: int = 0
    shared: bool = False
    icon: str = ""
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    unit: str = ""
    meaning: Meaning | None = None
    group: str = ""
    words: SearchWords = field(default_factory=dict)
    place: Place | None = field(default=None, compare=False, repr=False)

    def method(self, name: str) -> Method | None:
        """The method of that name, or None."""
        return next((method for method in self.methods if method.name == name), None)


@dataclass(frozen=True)
class Robot:
    """A kind of robot. `tick_ms` is the period of a reaction, `wait_unit_ms` the unit of WAIT.

    `level` is that of the programs for it: one of several robots only for the target of a team (crew). `figure` is how
    the page draws it; "" leaves that to what it does.
    """

    name: str
    actuators: tuple[RobotObject, ...]
    sensors: tuple[RobotObject, ...]
    variables: tuple[RobotObject, ...]
    system: tuple[RobotObject, ...]
    tick_ms: int = 20
    wait_unit_ms: int = 100
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    level: Level = Level.AGENT
    figure: str = ""

    @property
    def objects(self) -> Iterator[RobotObject]:
        """All objects: actuators, sensors, variables, system, each in the order of the file."""
        yield from self.actuators
        yield from self.sensors
        yield from self.variables
        yield from self.system

    @cached_property
    def calls(self) -> Mapping[tuple[str, str], tuple[RobotObject, Method]]:
        """(object, method) → what that call means; the first in the order of `objects` where two agree."""
        table: dict[tuple[str, str], tuple[RobotObject, Method]] = {}
        for part in self.objects:
            for method in part.methods:
                table.setdefault((part.name, method.name), (part, method))
        return table

    @cached_property
    def fingerprint(self) -> bytes:
        """Eight bytes that change when anything an image depends on changes: names, order, ranges, timing.

        Pins do not count: what a program means is the same on every board.
        """
        words: list[object] = ["robot", self.tick_ms, self.wait_unit_ms]
        for part in self.objects:
            words += [part.category.value, part.name, part.type.value, part.minimum, part.maximum, part.initial]
            for method in part.methods:
                words += [method.name, method.kind.value, method.completes_later, method.stop, method.test, method.to]
                for parameter in method.parameters:
                    words += [parameter.minimum, parameter.maximum]
        return hashlib.sha256("\x1f".join(map(str, words)).encode()).digest()[:8]
