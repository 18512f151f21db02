"""Worlds from XML: what only the whole file can tell, that is names, places, and what lies where.

A part with a mistake is reported and left out; everything else of the world stays usable, for showing it. Whoever runs
a world looks at the diagnostics first.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import TypeVar

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.world import rules
from kitrobot.world.geometry import Corner, distance_to_stretch
from kitrobot.world.model import Ball, Box, ColouredLine, Dock, Floor, Road, Start, Storehouse, Wall, World, Zone
from kitrobot.world.parts import PARTS, SIZE, has_shape, in_mm, mm
from kitrobot.world.xml_writer import write_world
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import needed, version
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

VERSION = 1

WALL_CLEARANCE_MM = 10.0
"""A start nearer to a wall than this is in it, whatever the robot's size."""

MAX_ZONES = 200
"""Each sensor looks at every zone of its kind at each tick."""

P = TypeVar("P")
N = TypeVar("N", Road, Storehouse, Dock, Start)

_NAMED: Mapping[str, type[Road] | type[Storehouse] | type[Dock]] = {
    "road": Road,
    "storehouse": Storehouse,
    "dock": Dock,
}

KINDS: Mapping[str, tuple[str, type[object]]] = {
    "wall": ("walls", Wall),
    "floor": ("floors", Floor),
    "line": ("lines", ColouredLine),
    "road": ("roads", Road),
    "storehouse": ("storehouses", Storehouse),
    "dock": ("docks", Dock),
    "start": ("starts", Start),
    "box": ("boxes", Box),
    "ball": ("balls", Ball),
    "zone": ("zones", Zone),
}
"""Kind of thing → the field of a world that holds them, and what they are."""


def _open(element: Element) -> None:
    element.version(VERSION)


class _UnknownXml(str):
    """XML of a world that we do not know."""

    __slots__ = ()


def keep_unknown(element: Element, raw: str) -> None:
    """Keeps an element of a world that nobody knows, word for word."""
    element.values.append((_UnknownXml(raw), element))


ATTRIBUTES = {"version": version(VERSION), "name": needed(), "width": needed(SIZE), "height": needed(SIZE)}
WORLD = {
    "world": Tag(
        attributes=ATTRIBUTES,
        children={**TEXTS, **PARTS},
        open=_open,
        keep=keep_unknown,
        keeps_foreign=True,
        unique=("road", "storehouse", "dock", "start"),
        about="A world, in mm and degrees: x to the right, y up, heading 0 looks right and grows counter-clockwise.",
    )
}
"""The first element of a world's file."""


def read_world(data: bytes, name: str) -> tuple[World | None, list[Diagnostic]]:
    """A world and what is wrong with it; None when nothing of the file can be used.

    Args:
        data: the file as it is.
        name: what people call it, for messages.
    """
    reader = Reader(data, name)
    root = reader.read(WORLD)
    if root is None:
        return None, reader.diagnostics
    frame = _frame(root)
    if frame is None:
        return None, reader.diagnostics
    frame = replace(frame, prolog=tuple(reader.prolog), unknown=(*frame.unknown, *reader.epilog))
    world = _WorldBuilder(root, frame).world()
    return world, with_things(root, reader.diagnostics)


def _frame(root: Element) -> World | None:
    """The world without what is in it; None without a size: then nothing can be said about where things are."""
    found_before = len(root.reader.diagnostics)
    world_name, width, height = root.required("name"), in_mm(root, "width"), in_mm(root, "height")
    if len(root.reader.diagnostics) > found_before:
        return None
    texts, unknown = root.texts, tuple(str(raw) for raw in root.found(_UnknownXml))
    label, help = texts.get("label", {}), texts.get("help", {})
    return World(world_name, width, height, unknown=unknown, help=help, label=label, attributes=root.foreign)


def read_plan(root: Element) -> World | None:
    """The world that an element inside another file describes, with the parts that do not fit: a plan to work on.

    What does not fit is reported as for a file. None when the plan would not say what the element says (a number that
    is none, an attribute that is missing): whoever writes the file keeps the element then.
    """
    if "version" in root.attributes and root.between("version", 1, 10**9, 1) > VERSION:
        message = Sentence(
            "expected version {newest} or older, found version {found}", VERSION, root.attributes["version"]
        )
        root.report(xml_rules.NEWER_VERSION, message, "version", Sentence("open it with a newer KitRobot"))
        return None
    frame = _frame(root)
    if frame is None:
        return None
    _WorldBuilder(root, frame).world()
    return _plan(root, frame) if _is_complete(root) else None


def _plan(root: Element, frame: World) -> World:
    return replace(
        frame,
        **{kind: tuple(root.found(part)) for kind, part in KINDS.values()},  # type: ignore[arg-type]
    )


def _is_complete(root: Element) -> bool:
    """Whether everything wrong inside is about what fits together, so that the values are those of the file."""
    here = _where(root)
    for item in root.reader.diagnostics:
        inside = item.place is not None and (item.place.line, item.place.column) >= here
        if inside and item.is_error and not item.code.startswith("world-") and item.code != xml_rules.DUPLICATE.code:
            return False
        if item.code == xml_rules.TOO_MANY.code:
            return False
    placed = all(start.road or start.dock or start.storehouse or start.pose for start in root.found(Start))
    placed &= all(has_shape(element) for _, element in root.found_at(Zone))
    return placed and not any(
        element.found(Corner) and not {"x", "y", "width", "height"}.isdisjoint(element.attributes)
        for _, element in root.found_at(Floor)
    )


def _where(element: Element) -> tuple[int, int]:
    place = element.place()
    return place.line, place.column


def with_things(root: Element, diagnostics: list[Diagnostic]) -> list[Diagnostic]:
    """The diagnostics, those about a thing of the world `root` with its kind and number: `road:0`."""
    starts: list[tuple[int, int, str]] = [(*_where(root), "world:0")]
    for name, (_, kind) in KINDS.items():
        found = root.found_at(kind)
        starts += [(*_where(element), f"{name}:{at}") for at, (_, element) in enumerate(found)]
    starts.sort()

    def thing(item: Diagnostic) -> str:
        if item.thing or item.place is None:
            return item.thing
        at = bisect_right(starts, (item.place.line, item.place.column, "\uffff"))
        return starts[at - 1][2] if at else ""

    return [replace(item, thing=thing(item)) for item in diagnostics]


@lru_cache(maxsize=16)
def _checked(data: bytes, name: str) -> tuple[World | None, tuple[Diagnostic, ...]]:
    world, diagnostics = read_world(data, name)
    return world, tuple(replace(item, place=None) for item in diagnostics)


def check_plan(plan: World) -> tuple[World | None, tuple[Diagnostic, ...]]:
    """The world of all parts of a plan that fit, and what is wrong with the others; the diagnostics have no place.

    A plan is held against the very rules of files: what is said here is said when it is read again.
    """
    return _checked(write_world(plan), plan.name)


class _WorldBuilder:
    """The parts put together: each is checked against the world so far, and left out when it does not fit."""

    def __init__(self, root: Element, frame: World) -> None:
        self.root = root
        self.so_far = frame
        self._declared: dict[str, dict[str, None]] = {}

    @cached_property
    def walls(self) -> _WallIndex:
        """The sound walls; asked for when there are no more to come."""
        return _WallIndex(self.so_far.walls)

    def declared(self, kind: str) -> Mapping[str, None]:
        """The names of all parts of a kind, sound or not, in the order of the file."""
        if kind not in self._declared:
            self._declared[kind] = dict.fromkeys(part.name for part in self.root.found(_NAMED[kind]))
        return self._declared[kind]

    def world(self) -> World:
        """The world of all sound parts."""
        self.so_far = replace(self.so_far, walls=tuple(self._sound(Wall, self._wall)))
        self.so_far = replace(self.so_far, floors=tuple(self._sound(Floor, self._line)))
        self.so_far = replace(self.so_far, lines=tuple(self._sound(ColouredLine, self._line)))
        self.so_far = replace(self.so_far, roads=tuple(self._named(Road, "road", self._line)))
        self.so_far = replace(self.so_far, storehouses=tuple(self._named(Storehouse, "storehouse", self._storehouse)))
        self.so_far = replace(self.so_far, docks=tuple(self._named(Dock, "dock", self._dock)))
        self.so_far = replace(self.so_far, starts=tuple(self._named(Start, "start", self._start)))
        boxes, balls = tuple(self._sound(Box, self._thing)), tuple(self._sound(Ball, self._thing))
        return replace(self.so_far, boxes=boxes, balls=balls, zones=tuple(self._zones()))

    def _zones(self) -> list[Zone]:
        for _, element in self.root.found_at(Zone)[MAX_ZONES:]:
            element.report(rules.ZONE, Sentence("expected at most {most} zones, found more", MAX_ZONES))
            break
        return self._sound(Zone, self._thing)[:MAX_ZONES]

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

    def _thing(self, thing: Box | Ball | Zone, where: Element) -> None:
        self._inside(where, [(thing.x_mm, thing.y_mm)])

    def _storehouse(self, house: Storehouse, where: Element) -> None:
        far = (house.x_mm + house.width_mm, house.y_mm + house.height_mm)
        self._inside(where, [(house.x_mm, house.y_mm), far])

    def _dock(self, dock: Dock, where: Element) -> None:
        self._exists(where, "storehouse", dock.storehouse, self.so_far.storehouse(dock.storehouse))
        road = self.so_far.road(dock.road)
        self._exists(where, "road", dock.road, road)
        if road is not None and dock.at_mm > road.line.length_mm:
            message = Sentence(
                "expected the dock on its road, from 0 to {length} mm, found {found}",
                mm(road.line.length_mm),
                mm(dock.at_mm),
            )
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
            message = Sentence(
                "expected a start on the road, from 0 to {length} mm, found {found}",
                mm(road.line.length_mm),
                mm(start.at_mm),
            )
            where.report(rules.START, message, "at")
            return
        pose = world.start_pose(start)
        self._inside(where, [(pose.x_mm, pose.y_mm)])
        for wall in self.walls.around(pose.x_mm, pose.y_mm):
            away, _ = distance_to_stretch(pose.x_mm, pose.y_mm, wall.x1_mm, wall.y1_mm, wall.x2_mm, wall.y2_mm)
            if away < WALL_CLEARANCE_MM:
                where.report(
                    rules.START,
                    Sentence("{agent} starts in a wall", start.name),
                    help=Sentence("move the start away from the wall"),
                )
                return

    # -- what they have in common

    def _exists(self, where: Element, attribute: str, name: str, found: object) -> None:
        """Whether `name` stands for something; one that was declared but left out has been reported already."""
        if found is not None:
            return
        declared = self.declared(attribute)
        if name in declared:
            where.faulty = True
        else:
            message = Sentence(
                "expected the name of a <{element}> of this world, found {found}", attribute, shown(name)
            )
            where.report(rules.UNKNOWN, message, attribute, where.did_you_mean(name, declared))

    def _inside(self, where: Element, points: Iterable[tuple[float, float]]) -> None:
        width, height = self.so_far.width_mm, self.so_far.height_mm
        for x_mm, y_mm in points:
            if not (0 <= x_mm <= width and 0 <= y_mm <= height):
                message = Sentence(
                    "({x}, {y}) is outside the world, which is {width} × {height} mm",
                    mm(x_mm),
                    mm(y_mm),
                    mm(width),
                    mm(height),
                )
                where.report(rules.OUTSIDE, message)
                return


class _WallIndex:
    """The walls of a world by where they are, so that of very many walls only the near ones are looked at.

    Squares of several sizes, each twice as wide as the one before: a wall is in those squares of one size, at most
    four, which it and `WALL_CLEARANCE_MM` around it touch and than which it is not wider.
    """

    def __init__(self, walls: Iterable[Wall]) -> None:
        self.squares: dict[tuple[int, int, int], list[Wall]] = {}
        self.sizes: set[int] = set()
        for wall in walls:
            left, right = sorted((wall.x1_mm, wall.x2_mm))
            bottom, top = sorted((wall.y1_mm, wall.y2_mm))
            spare = WALL_CLEARANCE_MM
            size = math.frexp(max(right - left, top - bottom) + 2 * spare)[1]
            self.sizes.add(size)
            for column in {_square(left - spare, size), _square(right + spare, size)}:
                for row in {_square(bottom - spare, size), _square(top + spare, size)}:
                    self.squares.setdefault((size, column, row), []).append(wall)

    def around(self, x_mm: float, y_mm: float) -> Iterator[Wall]:
        """Every wall that is within `WALL_CLEARANCE_MM` of a point, and others."""
        for size in self.sizes:
            yield from self.squares.get((size, _square(x_mm, size), _square(y_mm, size)), ())


def _square(at_mm: float, size: int) -> int:
    return math.floor(math.ldexp(at_mm, -size))
