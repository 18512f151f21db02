"""The elements of a world's XML, each turned into its part by itself.

A part with a mistake is made all the same, so that what names it is not blamed too; its element says that it is faulty.
Left to others: what needs the whole file (reading).
"""

from __future__ import annotations

import math
from dataclasses import replace

from kitrobot.primitives import Element, Tag
from kitrobot.primitives import rules as xml_rules
from kitrobot.world import rules
from kitrobot.world.geometry import Corner, Pose, normalised
from kitrobot.world.model import (
    COLOURS,
    LEFT,
    LOAD,
    RIGHT,
    UNLOAD,
    ColouredLine,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    rectangle_corners,
)

MAX_SIZE_MM = 1_000_000.0
"""A kilometre; worlds are table tops and halls."""

MAX_NUMBER = 65535
"""The largest sign, stock or capacity: what the language can write."""

SECTION_SLACK_MM = 1.0
"""How far a section may miss the end of the one before: lengths of arcs are irrational, files are not."""


def length(element: Element, name: str, least: float = 0.0, default: float | None = None) -> float:
    """An attribute in mm, `least` or more, to the thousandth that is written."""
    return round(element.decimal(name, least, MAX_SIZE_MM, default), 3)


def _coordinate(element: Element, name: str) -> float:
    return round(element.decimal(name, -MAX_SIZE_MM, MAX_SIZE_MM), 3)


def mm(value: float) -> str:
    """A length as messages show it."""
    return f"{value:.1f}".removesuffix(".0")


def _point(element: Element) -> Corner:
    return Corner(_coordinate(element, "x"), _coordinate(element, "y"), length(element, "radius", default=0.0))


def _wall(element: Element) -> Wall:
    return Wall(*(_coordinate(element, name) for name in ("x1", "y1", "x2", "y2")))


def _line(element: Element) -> ColouredLine:
    colour = element.choice("colour", COLOURS)
    corners = tuple(element.found(Corner))
    line = ColouredLine(colour, length(element, "width", 0.1), corners, element.flag("closed"))
    _is_drawn(element, line)
    return line


def _floor(element: Element) -> Floor:
    colour = element.choice("colour", COLOURS)
    corners = tuple(element.found(Corner))
    sides = [side for side in ("x", "y", "width", "height") if side in element.attributes]
    if sides and corners:
        element.report(rules.LINE, "expected points or x, y, width and height on <floor>, found both", sides[0])
    elif sides:
        x_mm, y_mm = _coordinate(element, "x"), _coordinate(element, "y")
        corners = rectangle_corners(x_mm, y_mm, length(element, "width", 0.1), length(element, "height", 0.1))
    floor = Floor(colour, corners)
    _is_drawn(element, floor)
    return floor


def _section(element: Element) -> Section:
    sign = element.integer("sign", 0, MAX_NUMBER)
    end = length(element, "to") if "to" in element.attributes else math.inf
    return Section(sign, length(element, "from"), end)


def _road(element: Element) -> Road:
    name, width, closed = element.required("name"), length(element, "width", 1.0), element.flag("closed")
    corners = tuple(element.found(Corner))
    road = Road(name, width, closed, corners)
    if not _is_drawn(element, road):
        return replace(road, sections=tuple(element.found(Section)))
    return replace(road, sections=_sections(element, road.line.length_mm))


def _is_drawn(element: Element, line: Road | ColouredLine | Floor) -> bool:
    """Whether the line has a shape; says why not."""
    if element.faulty:
        return False
    try:
        return line.line.length_mm > 0
    except ValueError as error:
        element.report(rules.LINE, f"this <{element.name}> cannot be drawn: {error}")
        return False


def _sections(element: Element, road_mm: float) -> tuple[Section, ...]:
    """The sections of a road, checked one after another: each begins where the one before ended."""
    found = element.found_at(Section)
    sections: list[Section] = []
    signs: set[int] = set()
    at = 0.0
    for number, (section, where) in enumerate(found, 1):
        final = number == len(found)
        start, end = section.from_mm, road_mm if final and math.isinf(section.to_mm) else section.to_mm
        if abs(start - at) > SECTION_SLACK_MM:
            what = "a gap" if start > at else "an overlap"
            message = f"expected section {section.sign} to begin at {mm(at)} mm, found {mm(start)}"
            where.report(rules.SECTIONS, f"{message}: {what} of {mm(abs(start - at))} mm", "from")
        elif math.isinf(end):
            where.report(xml_rules.MISSING, 'expected to="…" on every <section> but the last, found none')
        elif end <= start:
            where.report(rules.SECTIONS, f"section {section.sign} ends at {mm(end)} mm, before it begins", "to")
        elif final and abs(end - road_mm) > SECTION_SLACK_MM:
            message = f"expected the last section to end with its road at {mm(road_mm)} mm, found {mm(end)}"
            where.report(rules.SECTIONS, message, "to", "without `to` the last section ends with its road")
        if section.sign in signs:
            where.report(xml_rules.DUPLICATE, f"the sign {section.sign} stands on this road already", "sign")
        at = start if math.isinf(end) else end
        signs.add(section.sign)
        sections.append(Section(section.sign, start, end))
    return tuple(sections)


def _dock(element: Element) -> Dock:
    return Dock(
        element.required("name"),
        element.required("road"),
        length(element, "at"),
        length(element, "reach", 0.1),
        element.required("storehouse"),
        element.choice("kind", (LOAD, UNLOAD)),
        element.choice("side", (LEFT, RIGHT), LEFT),
    )


def _storehouse(element: Element) -> Storehouse:
    capacity = element.integer("capacity", 0, MAX_NUMBER)
    stock = element.integer("stock", 0, MAX_NUMBER, 0)
    if stock > capacity and not element.faulty:
        message = f"expected at most {capacity} boxes, the capacity, found a stock of {stock}"
        element.report(rules.STOREHOUSE, message, "stock")
    x_mm, y_mm = _coordinate(element, "x"), _coordinate(element, "y")
    width, height = length(element, "width", 1.0), length(element, "height", 1.0)
    return Storehouse(element.required("name"), x_mm, y_mm, width, height, capacity, stock)


def _start(element: Element) -> Start:
    name = element.required("name")
    ways = [way for way in ("road", "dock", "storehouse", "x") if way in element.attributes]
    if len(ways) != 1:
        found = " and ".join(ways) if ways else "none of them"
        element.report(rules.START, f"expected one of road, dock, storehouse, or x and y on <start>, found {found}")
        return Start(name)
    if ways == ["road"]:
        return Start(name, road=element.required("road"), at_mm=length(element, "at"))
    if ways == ["dock"]:
        return Start(name, dock=element.required("dock"))
    if ways == ["storehouse"]:
        return Start(name, storehouse=element.required("storehouse"))
    heading = math.radians(round(element.decimal("heading", -360.0, 360.0, 0.0), 3))
    return Start(name, pose=Pose(_coordinate(element, "x"), _coordinate(element, "y"), normalised(heading)))


_POINT = Tag(close=_point, attributes=("x", "y", "radius"))

PARTS = {
    "wall": Tag(close=_wall, attributes=("x1", "y1", "x2", "y2")),
    "floor": Tag(close=_floor, attributes=("colour", "x", "y", "width", "height"), children={"point": _POINT}),
    "line": Tag(close=_line, attributes=("colour", "width", "closed"), children={"point": _POINT}),
    "road": Tag(
        close=_road,
        attributes=("name", "width", "closed"),
        children={"point": _POINT, "section": Tag(close=_section, attributes=("sign", "from", "to"))},
    ),
    "dock": Tag(close=_dock, attributes=("name", "road", "at", "reach", "storehouse", "kind", "side")),
    "storehouse": Tag(close=_storehouse, attributes=("name", "x", "y", "width", "height", "capacity", "stock")),
    "start": Tag(close=_start, attributes=("name", "road", "at", "dock", "storehouse", "x", "y", "heading")),
}
"""What a `<world>` may hold."""
