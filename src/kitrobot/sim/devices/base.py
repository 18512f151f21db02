"""What every simulated device is: its name in robots' XML, its settings, and loops over all devices of its kind.

A module of this package that defines a subclass with a `name` is a device; nobody keeps a list. `settings` says which
attributes of the robot's XML it understands, with their units and bounds, so that every number of its behaviour is in
the XML. The class only describes; a device's state and numbers are its entries in the tables of the run (see columns),
where `initial_floats` fills the columns that are its own (A_OWN, S_OWN), to which its module gives names. What it does
is in functions beside the class, in the Python that Numba compiles, which `dispatch` finds by their names and calls:

- `sense(first, last, step, state)` measures into S_VALUE with the sensors `first` … `last` - 1;
- `start(k, command, deviate, state)` lets actuator k begin what a command says;
- `advance(first, last, dt, state)` goes on for a step of dt seconds with the actuators `first` … `last` - 1;
- `is_busy(k, state)` says whether actuator k will change something without a new command; without it, A_DONE says so.

A module without one of them has nothing to do there. What a device shows to the eye or the ear is its row of `outputs`.

What all of them share, latency, noise and drop-outs, is done in one place each: `sampling` for sensors, `actuation`
for actuators; only how noise changes what an actuator does is its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, ClassVar, Literal, NamedTuple

from kitrobot.primitives.robot import Method, RobotObject
from kitrobot.text.sentences import Sentence
from kitrobot.world.model import World

if TYPE_CHECKING:
    from kitrobot.sim.tables.state import State


@dataclass(frozen=True)
class Setting:
    """An attribute of a device: a number with a unit and bounds, one of a few words, or a text that `reads` accepts.

    Of a text, `unit` says in words what is expected.
    """

    name: str
    default: float | str
    help: str
    unit: str = ""
    least: float = 0.0
    most: float = 1_000_000.0
    words: tuple[str, ...] = ()
    reads: Callable[[str], bool] | None = None
    required: bool = False
    names_place: bool = False
    """Whether it is the name of a place of the world (see `World.places`)."""
    names_agent: bool = False
    """Whether it is the name of an agent of the run, whose number is then the last of its own columns."""


LATENCY = Setting("latency", 0.0, Sentence("how much later it works, or how old what it reads is"), "ms", most=60_000.0)
LOST_READINGS = Setting(
    "dropout", 0.0, Sentence("how often a reading is lost and the one before stays"), "%", 0.0, 100.0
)
LOST_COMMANDS = Setting("dropout", 0.0, Sentence("how often a command does not reach it"), "%", 0.0, 100.0)
MOVES_BOXES, COUNTS_BOXES = "moves", "counts"

DisplayKind = Literal["", "wheels", "lights", "melody", "pin", "lamp", "bar", "sound", "number", "pen"]
"""What the page draws of an actuator: nothing, wheels, a matrix of lights, whether it sounds, a pin's level, its value
as lamp, bar, sound or number, or a pen and its line."""

ManualControl = Literal["", "button", "gesture", "slider"]
"""How a person works a sensor in the arena: not, by a button of the board, by moving the whole board, by a slider."""

SPREAD = Setting("noise", 0.0, Sentence("how far a reading may be off (one standard deviation)"), "", 0.0, 1000.0)
WRONG = Setting("noise", 0.0, Sentence("how often it reads something else than what is there"), "%", 0.0, 100.0)


class Values:
    """The settings of one device, each a number or a word."""

    def __init__(self, values: Mapping[str, float | str]) -> None:
        self._values = values

    def number(self, name: str) -> float:
        """A setting that is a number."""
        value = self._values[name]
        assert isinstance(value, float), f"{name} is a word"
        return value

    def word(self, name: str) -> str:
        """A setting that is a word or a text."""
        value = self._values[name]
        assert isinstance(value, str), f"{name} is a number"
        return value

    def says(self, name: str, word: str) -> bool:
        """Whether there is such a setting and it is that word."""
        return self._values.get(name) == word

    def part(self, name: str) -> float:
        """A setting in percent as a part of 1; 0 when there is no such setting."""
        value = self._values.get(name, 0.0)
        assert isinstance(value, float), f"{name} is a word"
        return value / 100


@dataclass(frozen=True)
class Placement:
    """Where an agent was put: its road and dock and storehouse, as numbers in the world's lists, -1 for none."""

    road: int = -1
    dock: int = -1
    storehouse: int = -1


class Command(NamedTuple):
    """What an actuator is told: its procedure's number, how many arguments, and the first, second and last of them, 0
    where there is none.
    """

    procedure: int
    arguments: int
    first: int
    second: int
    last: int


class Discrete(Enum):
    """The discrete form of a device: how it behaves where time and lengths are abstracted away, for verification."""

    EXACT = "exact"
    """A number that the world holds: boxes on a bed or in a storehouse."""
    ANY = "any"
    """A sensor that may read any value of its range at any time."""
    SECTION = "section"
    """A function of the section of the road on which the robot is."""
    GAP = "gap"
    """A function of the gap to the robot ahead: touching, within reach, or beyond."""
    VISIT = "visit"
    """Whether a robot with the wanted load stands in the dock."""
    MOTION = "motion"
    """An actuator that moves its robot."""
    TEAM = "team"
    """What the team of the robot agreed on: an answer, or units of a work that are left."""
    BUSY = "busy"
    """An actuator that is done at any time after it began, and in the end."""
    INSTANT = "instant"
    """An actuator that nothing in the world depends on."""


class Device:
    """A kind of device; `kind` is its number among the sensors, or among the actuators, in the order of names, which it
    gets when all devices are found.
    """

    name: ClassVar[str] = ""
    kind: ClassVar[int] = -1
    settings: ClassVar[tuple[Setting, ...]] = ()
    discrete: ClassVar[Discrete]
    needs: ClassVar[str] = ""
    """Where its robot must start: "road", "dock", "storehouse", or anywhere."""
    excludes: ClassVar[tuple[str, ...]] = ()
    """Devices that a robot with this one cannot have too: they would move the same thing."""
    handles: ClassVar[str] = ""
    """What it does with boxes, by which its robot is drawn: MOVES_BOXES, COUNTS_BOXES, or nothing."""
    differs_in: ClassVar[str] = ""
    """A setting in which several devices of this kind on one robot differ."""

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        """The initial values of the own columns of one such device (A_OWN or S_OWN); the rest is 0."""
        return ()

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        """What having this device makes of a robot: its size, its bed."""


class Actuator(Device):
    """A device that does something; `procedures` are numbered in the order in which they stand. Without any, it takes
    procedures of every name.
    """

    discrete = Discrete.BUSY
    procedures: ClassVar[tuple[str, ...]] = ()
    drives: ClassVar[bool] = False
    """Whether what it does is the motion of its robot."""
    agrees: ClassVar[bool] = False
    """Whether what it is told changes nothing but what the robots of a team agree on."""
    turns: ClassVar[bool] = False
    """Whether it turns a robot that may have no wheels."""
    draws: ClassVar[bool] = False
    """Whether it is a pen."""
    outputs: ClassVar[int] = 0
    """How many integers of its own it has in the table `outputs`."""
    shown: ClassVar[int] = 0
    """So many of these, the first ones, are for everybody to see: what a display shows, what a buzzer plays."""

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        """How the page draws what it shows."""
        return ""

    @classmethod
    def initial_outputs(cls, values: Values) -> Sequence[int]:
        """What stands in the table `outputs` at the start."""
        return [0] * cls.outputs

    @classmethod
    def procedure_number(cls, part: RobotObject, method: Method, values: Values) -> int:
        """The number by which `start` knows a procedure of the part."""
        return cls.procedures.index(method.name)

    @classmethod
    def commanded_motion(cls, k: int, state: State) -> tuple[float, float]:
        """How actuator k, one that drives its robot, was told to move it last: mm/s forward, rad/s to the left."""
        return 0.0, 0.0

    @classmethod
    def is_waiting_for_room(cls, k: int, state: State) -> bool:
        """Whether actuator k waits for room in its storehouse."""
        return False


class Sensor(Device):
    """A device that measures."""

    discrete = Discrete.ANY
    by_hand: ClassVar[bool] = False
    """Whether it measures what only a person does: a run in which somebody waits for that is not at a standstill."""
    restless: ClassVar[bool] = False
    """Whether what it measures changes although nothing else does."""

    @classmethod
    def sees_robots(cls, on_road: bool) -> bool:
        """Whether it looks for other robots in their grid, on a robot that is on a road or is not."""
        return False

    @classmethod
    def table(cls, part: RobotObject, values: Values, world: World) -> Sequence[float]:
        """Numbers of any count that its settings and the world give; `sense` finds them in `sensors.numbers`, from
        S_FIRST to S_END.
        """
        return ()

    @classmethod
    def manual_control(cls, values: Values) -> ManualControl:
        """How a person works it in the arena."""
        return ""

    @classmethod
    def resting(cls, values: Values) -> int:
        """What it measures where no loop measures for it."""
        return 0

    @classmethod
    def ray(cls, values: Values) -> tuple[float, float] | None:
        """Of one that measures along a straight line: how far it sees from the robot's edge, in mm, and where it looks,
        in radians from the front; None for any other.
        """
        return None


def ticks(time_ms: float, dt: float) -> int:
    """A time in steps, rounded up."""
    return math.ceil(time_ms / (dt * 1000.0) - 1e-9)
