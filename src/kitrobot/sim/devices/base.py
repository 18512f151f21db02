"""What every simulated device is: a bank of all devices of one kind in a run, with flat lists, one entry a device.

A module of this package that defines a subclass with a `name` is a device; nobody keeps a list. `settings` says which
attributes of the robot's XML it understands, with their units and bounds, so that every number of its behaviour is in
the XML. An actuator takes commands by the names of its procedures and raises `done` again when something that takes
longer has ended; a sensor fills `values`. What all of them share, latency and noise, is done by the agents (see
agents).

Left to others: clamping to the sensor's range (the machine), when to sample (simulation).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from random import Random
from typing import ClassVar

from kitrobot.primitives import RobotObject
from kitrobot.sim.bodies import Bodies, Ways
from kitrobot.world import Dock, World


@dataclass(frozen=True)
class Setting:
    """An attribute of a device: a number with a unit and bounds, or one of a few words."""

    name: str
    default: float | str
    help: str
    unit: str = ""
    least: float = 0.0
    most: float = 1_000_000.0
    words: tuple[str, ...] = ()


LATENCY = Setting("latency", 0.0, "how much later it works, or how old what it reads is", "ms", most=60_000.0)


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
        """A setting that is a word."""
        value = self._values[name]
        assert isinstance(value, str), f"{name} is a number"
        return value

    def says(self, name: str, word: str) -> bool:
        """Whether there is such a setting and it is that word."""
        return self._values.get(name) == word


@dataclass(frozen=True)
class Standing:
    """Where an agent was put: its road and dock and storehouse, as numbers in the world's lists, -1 for none."""

    road: int = -1
    dock: int = -1
    storehouse: int = -1


@dataclass
class Stage:
    """What all devices of a run share: the robots, the roads, the walls, the stock.

    `stock[h]` is the number of boxes in the storehouse h; `delivered[i]` how many boxes robot i brought to a dock.
    Boxes are never made or lost: `total` stays the sum of all stock and all loads.
    """

    world: World
    bodies: Bodies = field(default_factory=Bodies)
    ways: Ways = field(init=False)
    stock: list[int] = field(init=False)
    capacity: list[int] = field(init=False)
    delivered: list[int] = field(default_factory=list)
    wall_x1: list[float] = field(init=False)
    wall_y1: list[float] = field(init=False)
    wall_x2: list[float] = field(init=False)
    wall_y2: list[float] = field(init=False)
    dt: float = 0.02
    total: int = 0
    happened: list[tuple[str, int, str]] = field(default_factory=list)
    """What happened in this step: kind, agent, text."""

    def __post_init__(self) -> None:
        world = self.world
        self.ways = Ways(world.roads)
        self.stock = [house.stock for house in world.storehouses]
        self.capacity = [house.capacity for house in world.storehouses]
        self.wall_x1 = [wall.x1_mm for wall in world.walls]
        self.wall_y1 = [wall.y1_mm for wall in world.walls]
        self.wall_x2 = [wall.x2_mm for wall in world.walls]
        self.wall_y2 = [wall.y2_mm for wall in world.walls]
        self.total = sum(self.stock)

    def still_there(self) -> bool:
        """Whether no box was made or lost."""
        return self.total == sum(self.stock) + sum(self.bodies.load)

    def road_distance(self, road: int, start: float, end: float) -> float:
        """The way between two places on a road, the shorter one on a ring."""
        distance = abs(end - start)
        return min(distance, self.ways.length[road] - distance) if self.ways.closed[road] else distance

    def carrier_in(self, dock: Dock, road: int) -> int:
        """The robot with a bed that stands still in the dock, or -1; the nearest when there are several."""
        bodies, best, found = self.bodies, dock.reach_mm, -1
        for robot in range(len(bodies)):
            if bodies.bed[robot] and bodies.road[robot] == road and bodies.speed[robot] == 0.0:
                distance = self.road_distance(road, bodies.at[robot], dock.at_mm)
                if distance <= best and (found < 0 or distance < best):
                    best, found = distance, robot
        return found


class Device:
    """A bank. `robot[k]` is the robot that device k is part of."""

    name: ClassVar[str] = ""
    settings: ClassVar[tuple[Setting, ...]] = ()
    needs: ClassVar[str] = ""
    """Where its robot must start: "road", "dock", "storehouse", or anywhere."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.robot: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        """Adds one device and gives its number in this bank. `chance` is its own, from the run's seed."""
        self.robot.append(robot)
        return len(self.robot) - 1


class Actuator(Device):
    """A bank of devices that do something."""

    procedures: ClassVar[frozenset[str]] = frozenset()

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.done: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.done.append(1)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        """Begins to do what a command says, in place of what it did before."""
        raise NotImplementedError

    def move(self, dt: float) -> None:
        """Goes on for one step."""

    def busy(self, device: int) -> bool:
        """Whether it will change something without a new command."""
        return self.done[device] == 0


class Sensor(Device):
    """A bank of devices that measure."""

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.values: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.values.append(0)
        return super().add(robot, part, values, standing, chance)

    def sense(self) -> None:
        """Measures, for all devices of this bank."""
        raise NotImplementedError


def ticks(time_ms: float, dt: float) -> int:
    """A time in steps, rounded up."""
    return math.ceil(time_ms / (dt * 1000.0) - 1e-9)
