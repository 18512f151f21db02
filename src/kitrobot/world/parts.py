"""The elements of a world's XML, each turned into its part by itself.

A part with a mistake is made all the same, so that what names it is not blamed too; its element says that it is faulty.
Left to others: what needs the whole file (xml_reader).
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import cast

from kitrobot.text.sentences import Sentence, Series
from kitrobot.world import rules
from kitrobot.world.geometry import Corner, Pose, normalised
from kitrobot.world.limits import MAX_NUMBER, MAX_SIZE_MM, DockKind, FloorColour, Side, ZoneKind
from kitrobot.world.model import (
    COLOURS,
    LEFT,
    LOAD,
    RIGHT,
    UNLOAD,
    ZONE_KINDS,
    Ball,
    Box,
    ColouredLine,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    Zone,
    rectangle_corners,
)
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import NAME, YES_NO, decimal, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag

SECTION_SLACK_MM = 1.0
"""How far a section may miss the end of the one before: lengths of arcs are irrational, files are not."""


def in_mm(element: Element, name: str) -> float:
    """An attribute in mm, to the thousandth that is written."""
    return round(element.decimal(name), 3)


def mm(value: float) -> str:
    """A length as messages show it."""
    return f"{value:.1f}".removesuffix(".0")


def _point(element: Element) -> Corner:
    return Corner(in_mm(element, "x"), in_mm(element, "y"), in_mm(element, "radius"))


def _wall(element: Element) -> Wall:
    return Wall(*(in_mm(element, name) for name in ("x1", "y1", "x2", "y2")))


def _line(element: Element) -> ColouredLine:
    colour = cast(FloorColour, element.choice("colour"))
    corners = tuple(element.found(Corner))
    line = ColouredLine(colour, in_mm(element, "width"), corners, element.flag("closed"))
    _is_drawn(element, line)
    return line


def _floor(element: Element) -> Floor:
    colour = cast(FloorColour, element.choice("colour"))
    corners = tuple(element.found(Corner))
    sides = [side for side in ("x", "y", "width", "height") if side in element.attributes]
    if sides and corners:
        element.report(
            rules.LINE, Sentence("expected points or x, y, width and height on <floor>, found both"), sides[0]
        )
    elif sides:
        x_mm, y_mm = in_mm(element, "x"), in_mm(element, "y")
        corners = rectangle_corners(x_mm, y_mm, in_mm(element, "width"), in_mm(element, "height"))
    floor = Floor(colour, corners)
    _is_drawn(element, floor)
    return floor


def _section(element: Element) -> Section:
    sign = element.integer("sign")
    end = in_mm(element, "to") if "to" in element.attributes else math.inf
    return Section(sign, in_mm(element, "from"), end)


def _road(element: Element) -> Road:
    name, width, closed = element.required("name"), in_mm(element, "width"), element.flag("closed")
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
        element.report(rules.LINE, Sentence("this <{element}> cannot be drawn: {error}", element.name, error.args[0]))
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
            what = Sentence("a gap") if start > at else Sentence("an overlap")
            message = Sentence(
                "expected section {section} to begin at {wanted} mm, found {found}", section.sign, mm(at), mm(start)
            )
            where.report(
                rules.SECTIONS, Sentence("{message}: {what} of {length} mm", message, what, mm(abs(start - at))), "from"
            )
        elif math.isinf(end):
            where.report(xml_rules.MISSING, Sentence('expected to="…" on every <section> but the last, found none'))
        elif end <= start:
            where.report(
                rules.SECTIONS,
                Sentence("section {section} ends at {end} mm, before it begins", section.sign, mm(end)),
                "to",
            )
        elif final and abs(end - road_mm) > SECTION_SLACK_MM:
            message = Sentence(
                "expected the last section to end with its road at {end} mm, found {found}", mm(road_mm), mm(end)
            )
            where.report(rules.SECTIONS, message, "to", Sentence("without `to` the last section ends with its road"))
        if section.sign in signs:
            where.report(
                xml_rules.DUPLICATE, Sentence("the sign {sign} stands on this road already", section.sign), "sign"
            )
        at = start if math.isinf(end) else end
        signs.add(section.sign)
        sections.append(Section(section.sign, start, end))
    return tuple(sections)


def _dock(element: Element) -> Dock:
    return Dock(
        element.required("name"),
        element.required("road"),
        in_mm(element, "at"),
        in_mm(element, "reach"),
        element.required("storehouse"),
        cast(DockKind, element.choice("kind")),
        cast(Side, element.choice("side")),
    )


def _storehouse(element: Element) -> Storehouse:
    capacity = element.integer("capacity")
    stock = element.integer("stock")
    if stock > capacity and not element.faulty:
        message = Sentence("expected at most {capacity} boxes, the capacity, found a stock of {stock}", capacity, stock)
        element.report(rules.STOREHOUSE, message, "stock")
    x_mm, y_mm = in_mm(element, "x"), in_mm(element, "y")
    width, height = in_mm(element, "width"), in_mm(element, "height")
    return Storehouse(element.required("name"), x_mm, y_mm, width, height, capacity, stock)


def _start(element: Element) -> Start:
    name = element.required("name")
    ways = [way for way in ("road", "dock", "storehouse", "x") if way in element.attributes]
    if len(ways) != 1:
        found = Series(Sentence(" and "), ways) if ways else Sentence("none of them")
        element.report(
            rules.START, Sentence("expected one of road, dock, storehouse, or x and y on <start>, found {found}", found)
        )
        return Start(name)
    if ways == ["road"]:
        return Start(name, road=element.required("road"), at_mm=in_mm(element, "at"))
    if ways == ["dock"]:
        return Start(name, dock=element.required("dock"))
    if ways == ["storehouse"]:
        return Start(name, storehouse=element.required("storehouse"))
    heading = math.radians(round(element.decimal("heading"), 3))
    return Start(name, pose=Pose(in_mm(element, "x"), in_mm(element, "y"), normalised(heading)))


def _box(element: Element) -> Box:
    return Box(*(in_mm(element, name) for name in ("x", "y", "width", "height", "mass", "friction")))


def _ball(element: Element) -> Ball:
    return Ball(*(in_mm(element, name) for name in ("x", "y", "radius", "mass", "friction")))


def has_shape(zone: Element) -> bool:
    """Whether a zone says one of a radius, or a width and a height."""
    said = {"radius", "width", "height"} & zone.attributes.keys()
    return said in ({"radius"}, {"width", "height"})


def _zone(element: Element) -> Zone:
    said = [name for name in ("radius", "width", "height") if name in element.attributes]
    if not has_shape(element):
        found = Series(Sentence(" and "), said) if said else Sentence("none of them")
        element.report(rules.ZONE, Sentence("expected a radius, or width and height, on <zone>, found {found}", found))
    radius, width, height = (in_mm(element, name) if name in said else 0.0 for name in ("radius", "width", "height"))
    x_mm, y_mm, value, falloff = (in_mm(element, name) for name in ("x", "y", "value", "falloff"))
    return Zone(cast(ZoneKind, element.choice("kind")), x_mm, y_mm, radius, width, height, value, falloff)


_COORDINATE = decimal(-MAX_SIZE_MM, MAX_SIZE_MM, "coordinate")
_LENGTH = decimal(0.0, MAX_SIZE_MM, "length")
_THICKNESS = decimal(0.1, MAX_SIZE_MM, "thickness")
SIZE = decimal(1.0, MAX_SIZE_MM, "size")
"""A side of what is at least a millimetre wide."""

_THING_SIZE = decimal(5.0, 100_000.0, "thing-size")
_MASS = decimal(1.0, 1_000_000.0, "mass")
_FRICTION = decimal(0.0, 10.0, "friction")
_ZONE_VALUE = decimal(0.0, 100.0, "zone-value")
_COUNT = whole(0, MAX_NUMBER, "count")
_COLOUR = {"colour": needed(one(*COLOURS, name="floor-colour"))}
_CLOSED = {"closed": optional(YES_NO, "no")}
_NAMED = {"name": needed()}
_POSITION = {"x": needed(_COORDINATE), "y": needed(_COORDINATE)}
_MAY_BE_POSITION = {"x": optional(_COORDINATE), "y": optional(_COORDINATE)}
_POINT = Tag(_point, {**_POSITION, "radius": optional(_LENGTH, "0")}, about="A corner, rounded when it has a radius.")
_SECTION = Tag(
    _section,
    {
        "sign": needed(_COUNT),
        "from": needed(_LENGTH),
        "to": optional(_LENGTH, about="The last section may go without: it ends with the road."),
    },
)

PARTS = {
    "wall": Tag(_wall, {name: needed(_COORDINATE) for name in ("x1", "y1", "x2", "y2")}),
    "floor": Tag(
        _floor,
        {**_COLOUR, **_MAY_BE_POSITION, "width": optional(_THICKNESS), "height": optional(_THICKNESS)},
        {"point": _POINT},
        about="A coloured part of the floor: a rectangle from its lower left corner, or what three or more points "
        "enclose.",
    ),
    "line": Tag(
        _line,
        {**_COLOUR, "width": needed(_THICKNESS), **_CLOSED},
        {"point": _POINT},
        least=2,
        about="A coloured line on the floor.",
    ),
    "road": Tag(
        _road,
        {**_NAMED, "width": needed(SIZE), **_CLOSED},
        {"point": _POINT, "section": _SECTION},
        least=1,
        about="A guided way, cut into numbered sections without gaps; mm count from its first corner.",
    ),
    "dock": Tag(
        _dock,
        {
            **_NAMED,
            "road": needed(),
            "at": needed(_LENGTH),
            "reach": needed(_THICKNESS),
            "storehouse": needed(),
            "kind": needed(one(LOAD, UNLOAD)),
            "side": optional(one(LEFT, RIGHT), LEFT),
        },
        about="Where a carrier is loaded or unloaded: within reach of a point of its road.",
    ),
    "storehouse": Tag(
        _storehouse,
        {
            **_NAMED,
            **_POSITION,
            "width": needed(SIZE),
            "height": needed(SIZE),
            "capacity": needed(_COUNT),
            "stock": optional(_COUNT, "0"),
        },
        about="A rectangle from its lower left corner, with room for so many boxes.",
    ),
    "start": Tag(
        _start,
        {
            **_NAMED,
            "road": optional(NAME),
            "at": optional(_LENGTH),
            "dock": optional(NAME),
            "storehouse": optional(NAME),
            **_MAY_BE_POSITION,
            "heading": optional(decimal(-360.0, 360.0), "0"),
        },
        about="Where an agent begins: road and at, or dock, or storehouse, or x, y and heading in degrees.",
    ),
    "box": Tag(
        _box,
        {
            **_POSITION,
            "width": needed(_THING_SIZE),
            "height": needed(_THING_SIZE),
            "mass": optional(_MASS, "200", about="In grams."),
            "friction": optional(_FRICTION, "0.5", about="That of its underside: 0 slides for ever."),
        },
        about="A box that robots push, around its middle. It keeps its direction.",
    ),
    "ball": Tag(
        _ball,
        {
            **_POSITION,
            "radius": needed(_THING_SIZE),
            "mass": optional(_MASS, "50", about="In grams."),
            "friction": optional(_FRICTION, "0.02", about="What slows it down: 0 rolls for ever."),
        },
        about="A ball that robots push, around its middle.",
    ),
    "zone": Tag(
        _zone,
        {
            "kind": needed(one(*ZONE_KINDS, name="zone-kind")),
            **_POSITION,
            "radius": optional(SIZE, about="Of a circle."),
            "width": optional(SIZE, about="Of a rectangle, with its height."),
            "height": optional(SIZE),
            "value": needed(_ZONE_VALUE, about="In °C where it is warm, in percent where it is loud or bright."),
            "falloff": optional(_LENGTH, "200", about="How far beyond its edge it is felt, less and less."),
        },
        about="Where it is warm, loud or bright, around its middle: sensors feel it.",
    ),
}
"""What a `<world>` may hold."""
