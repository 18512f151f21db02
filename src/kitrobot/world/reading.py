"""Worlds from XML: what only the whole file can tell, that is names, places, and what lies where.

A part with a mistake is reported and left out; everything else of the world stays usable, for showing it. Whoever runs
a world looks at the diagnostics first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

from kitrobot.diagnostics import Diagnostic
from kitrobot.primitives import TEXTS, Element, Reader, Tag, did_you_mean, shown
from kitrobot.world import rules
from kitrobot.world.geometry import distance_to_stretch
from kitrobot.world.model import ColouredLine, Dock, Floor, Road, Start, Storehouse, Wall, World
from kitrobot.world.parts import PARTS, length, mm

VERSION = 1

WALL_CLEARANCE_MM = 10.0
"""A start nearer to a wall than this is in it, whatever the robot's size."""

P = TypeVar("P")
N = TypeVar("N", Road, Storehouse, Dock, Start)

_NAMED: Mapping[str, type[Road] | type[Storehouse] | type[Dock]] = {
    "road": Road,
    "storehouse": Storehouse,
    "dock": Dock,
}


def _open(element: Element) -> None:
    element.version(VERSION)


_ROOTS = {"world": Tag(attributes=("version", "name", "width", "height"), children={**TEXTS, **PARTS}, open=_open)}


def read_world(data: bytes, name: str) -> tuple[World | None, list[Diagnostic]]:
    """A world and what is wrong with it; None when nothing of the file can be used.

    Args:
        data: the file as it is.
        name: what people call it, for messages.
    """
    reader = Reader(data, name)
    root = reader.read(_ROOTS)
    if root is None:
        return None, reader.diagnostics
    found_before = len(reader.diagnostics)
    world_name, width, height = root.required("name"), length(root, "width", 1.0), length(root, "height", 1.0)
    if len(reader.diagnostics) > found_before:
        # Without a size nothing can be said about where things are.
        return None, reader.diagnostics
    frame = World(world_name, width, height, help=root.texts.get("help", {}), label=root.texts.get("label", {}))
    return _Whole(root, frame).world(), reader.diagnostics


class _Whole:
    """The parts put together: each is checked against the world so far, and left out when it does not fit."""

    def __init__(self, root: Element, frame: World) -> None:
        self.root = root
        self.so_far = frame

    def world(self) -> World:
        """The world of all sound parts."""
        self.so_far = replace(self.so_far, walls=tuple(self._sound(Wall, self._wall)))
        self.so_far = replace(self.so_far, floors=tuple(self._sound(Floor, self._line)))
        self.so_far = replace(self.so_far, lines=tuple(self._sound(ColouredLine, self._line)))
        self.so_far = replace(self.so_far, roads=tuple(self._named(Road, "road", self._line)))
        self.so_far = replace(self.so_far, storehouses=tuple(self._named(Storehouse, "storehouse", self._storehouse)))
        self.so_far = replace(self.so_far, docks=tuple(self._named(Dock, "dock", self._dock)))
        return replace(self.so_far, starts=tuple(self._named(Start, "start", self._start)))

    def _sound(self, kind: type[P], check: Callable[[P, Element], None]) -> list[P]:
        sound = []
        for part, element in self.root.found_at(kind):
            if not element.faulty:
                check(part, element)
            if not element.faulty:
                sound.append(part)
        return sound

    def _named(self, kind: type[N], what: str, check: Callable[[N, Element], None]) -> list[N]:
        self.root.distinct(kind, lambda part: part.name, what)
        return self._sound(kind, check)

    # -- one part each

    def _wall(self, wall: Wall, where: Element) -> None:
        self._inside(where, [(wall.x1_mm, wall.y1_mm), (wall.x2_mm, wall.y2_mm)])

    def _line(self, line: Road | ColouredLine | Floor, where: Element) -> None:
        self._inside(where, zip(line.line.xs, line.line.ys, strict=True))

    def _storehouse(self, house: Storehouse, where: Element) -> None:
        far = (house.x_mm + house.width_mm, house.y_mm + house.height_mm)
        self._inside(where, [(house.x_mm, house.y_mm), far])

    def _dock(self, dock: Dock, where: Element) -> None:
        self._exists(where, "storehouse", dock.storehouse, self.so_far.storehouse(dock.storehouse))
        road = self.so_far.road(dock.road)
        self._exists(where, "road", dock.road, road)
        if road is not None and dock.at_mm > road.line.length_mm:
            message = f"expected the dock on its road, from 0 to {mm(road.line.length_mm)} mm, found {mm(dock.at_mm)}"
            where.report(rules.DOCK, message, "at")

    def _start(self, start: Start, where: Element) -> None:
        world = self.so_far
        road = world.road(start.road)
        if start.road:
            self._exists(where, "road", start.road, road)
        if start.dock:
            self._exists(where, "dock", start.dock, world.dock(start.dock))
        if start.storehouse:
            self._exists(where, "storehouse", start.storehouse, world.storehouse(start.storehouse))
        if where.faulty:
            return
        if road is not None and start.at_mm > road.line.length_mm:
            message = f"expected a start on the road, from 0 to {mm(road.line.length_mm)} mm, found {mm(start.at_mm)}"
            where.report(rules.START, message, "at")
            return
        pose = world.start_pose(start)
        self._inside(where, [(pose.x_mm, pose.y_mm)])
        for wall in world.walls:
            away, _ = distance_to_stretch(pose.x_mm, pose.y_mm, wall.x1_mm, wall.y1_mm, wall.x2_mm, wall.y2_mm)
            if away < WALL_CLEARANCE_MM:
                where.report(rules.START, f"{start.name} starts in a wall", help="move the start away from the wall")
                return

    # -- what they have in common

    def _exists(self, where: Element, attribute: str, name: str, found: object) -> None:
        """Whether `name` stands for something; one that was declared but left out has been reported already."""
        declared = [part.name for part in self.root.found(_NAMED[attribute])]
        if found is None and name in declared:
            where.faulty = True
        elif found is None:
            message = f"expected the name of a <{attribute}> of this world, found {shown(name)}"
            where.report(rules.UNKNOWN, message, attribute, did_you_mean(name, declared))

    def _inside(self, where: Element, points: Iterable[tuple[float, float]]) -> None:
        width, height = self.so_far.width_mm, self.so_far.height_mm
        for x_mm, y_mm in points:
            if not (0 <= x_mm <= width and 0 <= y_mm <= height):
                message = f"({mm(x_mm)}, {mm(y_mm)}) is outside the world, which is {mm(width)} × {mm(height)} mm"
                where.report(rules.OUTSIDE, message)
                return
