"""A world: its size, walls, coloured floor and lines, roads in numbered sections, docks, storehouses, starts and zones.

Frozen values, in the order of the file, in mm and radians; x goes right, y goes up, heading 0 looks along +x and grows
counter-clockwise. A world made by `read_world` holds: names are unique a kind, every road has a sampled line, sections
cover their road without gap or overlap, docks lie on their road, what is named exists, nobody starts outside or in a
wall. A world made by hand in Python holds what its maker made sure of.

Left to others: motion, and what the stock becomes during a run (sim).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Final

from annotated_types import MaxLen

from kitrobot.primitives.robot import Texts
from kitrobot.world.geometry import Corner, Polyline, Pose, normalised, polyline
from kitrobot.world.limits import (
    MOST_PARTS,
    Coordinate,
    Count,
    DockKind,
    FloorColour,
    Length,
    Percent,
    Side,
    ZoneKind,
)

ARM_CLEARANCE_MM = 40.0
"""How far from the edge of the road someone who starts at a dock stands."""

LOAD: Final = "load"
UNLOAD: Final = "unload"
LEFT: Final = "left"
RIGHT: Final = "right"

COLOURS: dict[FloorColour, int] = {"red": 1, "green": 2, "blue": 3}
"""What a colour sensor reads above a line or a coloured floor; 0 beside them."""


WARM: Final = "warm"
LOUD: Final = "loud"
BRIGHT: Final = "bright"
ZONE_KINDS: tuple[ZoneKind, ...] = (WARM, LOUD, BRIGHT)


Corners = Annotated[tuple[Corner, ...], MaxLen(MOST_PARTS)]


@dataclass(frozen=True)
class Wall:
    """A straight wall without thickness."""

    x1_mm: Coordinate = field(metadata={"alias": "x1"})
    y1_mm: Coordinate = field(metadata={"alias": "y1"})
    x2_mm: Coordinate = field(metadata={"alias": "x2"})
    y2_mm: Coordinate = field(metadata={"alias": "y2"})


@dataclass(frozen=True)
class Floor:
    """A coloured part of the floor inside `corners`, rounded where they have a radius; `colour` is a key of `COLOURS`.

    Where its border crosses itself, what is enclosed twice is not coloured.
    """

    colour: FloorColour
    corners: Corners = field(metadata={"alias": "points"})

    @cached_property
    def line(self) -> Polyline:
        """Its sampled border."""
        return polyline(self.corners, True)

    @property
    def rectangle(self) -> tuple[float, float, float, float] | None:
        """x, y (its lower left corner), width and height of one that is as `rectangle_corners` makes it, or None."""
        if len(self.corners) != 4 or any(corner.radius_mm for corner in self.corners):
            return None
        first, _, last, _ = self.corners
        sides = first.x_mm, first.y_mm, last.x_mm - first.x_mm, last.y_mm - first.y_mm
        for corner, other in zip(self.corners, rectangle_corners(*sides), strict=True):
            if not math.isclose(corner.x_mm, other.x_mm) or not math.isclose(corner.y_mm, other.y_mm):
                return None
        return sides if min(sides[2:]) > 0 else None


def rectangle_corners(x_mm: float, y_mm: float, width_mm: float, height_mm: float) -> tuple[Corner, ...]:
    """The corners of a rectangle, counter-clockwise from its lower left one."""
    right, top = x_mm + width_mm, y_mm + height_mm
    return Corner(x_mm, y_mm), Corner(right, y_mm), Corner(right, top), Corner(x_mm, top)


@dataclass(frozen=True)
class ColouredLine:
    """A line on the floor; `colour` is a key of `COLOURS`."""

    colour: FloorColour
    width_mm: Length
    corners: Corners = field(metadata={"alias": "points"})
    closed: bool = False

    @cached_property
    def line(self) -> Polyline:
        """Its sampled middle."""
        return polyline(self.corners, self.closed)


@dataclass(frozen=True)
class Section:
    """A stretch of a road with the number its signs show."""

    sign: int
    from_mm: float
    to_mm: float


@dataclass(frozen=True)
class Road:
    """A guided way through `corners`, rounded where they have a radius; mm along are counted from the first."""

    name: str
    width_mm: float
    closed: bool
    corners: tuple[Corner, ...]
    sections: tuple[Section, ...] = ()

    @cached_property
    def line(self) -> Polyline:
        """Its sampled middle."""
        return polyline(self.corners, self.closed)

    @property
    def length_mm(self) -> float:
        """How long it is; infinite, as a section without an end of its own, for one that cannot be drawn."""
        try:
            return self.line.length_mm
        except ValueError:
            return math.inf

    def end_mm(self, section: Section) -> float | None:
        """Where a section of it ends; None where that is the end of the road."""
        return None if math.isinf(section.to_mm) or math.isclose(section.to_mm, self.length_mm) else section.to_mm

    def section_at(self, at_mm: float) -> Section | None:
        """The section so many mm along; None on a road without sections."""
        at_mm = self.line.wrapped(at_mm)
        for section in reversed(self.sections):
            if at_mm >= section.from_mm:
                return section
        return self.sections[0] if self.sections else None


@dataclass(frozen=True)
class Dock:
    """Where a carrier stands to be loaded or unloaded: within `reach_mm` of `at_mm` along its road.

    `side` is that of the road.
    """

    name: str
    road: str
    at_mm: Length
    reach_mm: Length
    storehouse: str
    kind: DockKind
    side: Side = LEFT


@dataclass(frozen=True)
class Storehouse:
    """A rectangle (x, y: its lower left corner) with room for `capacity` boxes, `stock` of them there at the start."""

    name: str
    x_mm: Coordinate
    y_mm: Coordinate
    width_mm: Length
    height_mm: Length
    capacity: Count
    stock: Count


@dataclass(frozen=True)
class Start:
    """Where an agent starts: on a road, at a dock, in a storehouse, or at a pose; exactly one of them.

    An agent takes the start of its own name, unless it names another.
    """

    name: str
    road: str = ""
    at_mm: float = 0.0
    dock: str = ""
    storehouse: str = ""
    pose: Pose | None = None


@dataclass(frozen=True)
class Box:
    """A box that can be pushed, around its middle; friction is that of its underside (0: it slides for ever)."""

    x_mm: Coordinate
    y_mm: Coordinate
    width_mm: Length
    height_mm: Length
    mass_g: Length
    friction: Length


@dataclass(frozen=True)
class Ball:
    """A ball that can be pushed, around its middle; friction is what slows it down (0: it rolls for ever)."""

    x_mm: Coordinate
    y_mm: Coordinate
    radius_mm: Length
    mass_g: Length
    friction: Length


@dataclass(frozen=True)
class Zone:
    """Where it is warm, loud or bright, around its middle: a circle, or a rectangle where `radius_mm` is 0.

    Inside it has its value, in °C (warm) or percent; beyond its edge that fades evenly, to nothing at `falloff_mm`.
    """

    kind: ZoneKind
    x_mm: Coordinate
    y_mm: Coordinate
    radius_mm: Length
    width_mm: Length
    height_mm: Length
    value: Percent
    falloff_mm: Length


@dataclass(frozen=True)
class World:
    """A whole world, from 0 to `width_mm` and `height_mm` (to 1 km): x to the right, y up.

    `unknown` is XML of its file that nobody knows, kept word for word. `label` is its title and `help` says in a
    sentence what it is, each by language, "" for English. `prolog` is what stands
    before the first element of its file, `attributes` are those of `<world>` with a prefix.

    Examples:
        >>> World("yard", 1000, 600, starts=(Start("a", pose=Pose(200, 300, 0)),)).places
        {'a': (200, 300, 200, 300)}
    """

    name: str
    width_mm: float
    height_mm: float
    walls: tuple[Wall, ...] = ()
    lines: tuple[ColouredLine, ...] = ()
    roads: tuple[Road, ...] = ()
    docks: tuple[Dock, ...] = ()
    storehouses: tuple[Storehouse, ...] = ()
    starts: tuple[Start, ...] = ()
    floors: tuple[Floor, ...] = ()
    boxes: tuple[Box, ...] = ()
    balls: tuple[Ball, ...] = ()
    zones: tuple[Zone, ...] = ()
    unknown: tuple[str, ...] = ()
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    prolog: tuple[str, ...] = ()
    attributes: Mapping[str, str] = field(default_factory=dict)

    # What is looked up by its name: the first one of a name.

    @cached_property
    def _roads(self) -> dict[str, Road]:
        return {road.name: road for road in reversed(self.roads)}

    @cached_property
    def _docks(self) -> dict[str, Dock]:
        return {dock.name: dock for dock in reversed(self.docks)}

    @cached_property
    def _storehouses(self) -> dict[str, Storehouse]:
        return {house.name: house for house in reversed(self.storehouses)}

    @cached_property
    def _starts(self) -> dict[str, Start]:
        return {start.name: start for start in reversed(self.starts)}

    def road(self, name: str) -> Road | None:
        """The road of that name, or None."""
        return self._roads.get(name)

    def dock(self, name: str) -> Dock | None:
        """The dock of that name, or None."""
        return self._docks.get(name)

    def storehouse(self, name: str) -> Storehouse | None:
        """The storehouse of that name, or None."""
        return self._storehouses.get(name)

    def start(self, name: str) -> Start | None:
        """The start of that name, or None."""
        return self._starts.get(name)

    @cached_property
    def places(self) -> dict[str, tuple[float, float, float, float]]:
        """Left, lower, right and upper edge in mm of storehouses, docks and starts by name; the last two are points."""
        found: dict[str, tuple[float, float, float, float]] = {}
        for house in self.storehouses:
            right, top = house.x_mm + house.width_mm, house.y_mm + house.height_mm
            found.setdefault(house.name, (house.x_mm, house.y_mm, right, top))
        points = [(dock.name, self.dock_pose(dock)) for dock in self.docks]
        points += [(start.name, self.start_pose(start)) for start in self.starts]
        for name, pose in points:
            found.setdefault(name, (pose.x_mm, pose.y_mm, pose.x_mm, pose.y_mm))
        return found

    def dock_pose(self, dock: Dock) -> Pose:
        """Where a carrier stands in the dock, and where it looks."""
        road = self.road(dock.road)
        assert road is not None, f"the dock {dock.name} is on no road"
        return road.line.pose_at(dock.at_mm)

    def start_pose(self, start: Start) -> Pose:
        """Where an agent with this start stands: beside its dock, looking at it, or in the middle of its storehouse."""
        if start.pose is not None:
            return start.pose
        if start.dock:
            dock = self.dock(start.dock)
            assert dock is not None, f"the start {start.name} is at no dock"
            road = self.road(dock.road)
            assert road is not None, f"the dock {dock.name} is on no road"
            pose = self.dock_pose(dock)
            across = pose.heading_rad + (math.pi / 2 if dock.side == LEFT else -math.pi / 2)
            away = road.width_mm / 2 + ARM_CLEARANCE_MM
            x_mm, y_mm = pose.x_mm + away * math.cos(across), pose.y_mm + away * math.sin(across)
            return Pose(x_mm, y_mm, normalised(across + math.pi))
        if start.storehouse:
            house = self.storehouse(start.storehouse)
            assert house is not None, f"the start {start.name} is in no storehouse"
            return Pose(house.x_mm + house.width_mm / 2, house.y_mm + house.height_mm / 2, 0.0)
        road = self.road(start.road)
        assert road is not None, f"the start {start.name} is on no road"
        return road.line.pose_at(start.at_mm)
