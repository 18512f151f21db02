"""Worlds to XML, in one true layout: one part a line, in a fixed order, so that differences are readable."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from kitrobot.primitives.robot import Texts
from kitrobot.world.geometry import Corner
from kitrobot.world.model import LEFT, ColouredLine, Dock, Floor, Road, Start, World, Zone
from kitrobot.xml.foreign import fragment, head, remark
from kitrobot.xml.writer import attributes, text_element


def number(value: float) -> str:
    """A length or angle with at most three decimals, the shortest way."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def write_world(world: World) -> bytes:
    """The file of a world; reading it gives the world back, lengths to a thousandth of a mm."""
    lines = [*map(remark, world.prolog), *world_lines(replace(world, prolog=()))]
    return ("\n".join(lines) + "\n").encode()


def world_lines(world: World) -> Iterator[str]:
    """The lines of a world without their breaks; XML that is kept word for word is one of them, whatever it holds."""
    size = (("width", number(world.width_mm)), ("height", number(world.height_mm)))
    foreign, remarks = head(world.attributes, world.unknown)
    yield f"<world{attributes(('version', 1), ('name', world.name), *size)}{foreign}>"
    yield from _texts("label", world.label)
    yield from _texts("help", world.help)
    for wall in world.walls:
        yield f"  <wall{_numbers(x1=wall.x1_mm, y1=wall.y1_mm, x2=wall.x2_mm, y2=wall.y2_mm)}/>"
    for floor in world.floors:
        yield from _floor(floor)
    for line in world.lines:
        yield from _line(line)
    for road in world.roads:
        yield from _road(road)
    for house in world.storehouses:
        place = _numbers(x=house.x_mm, y=house.y_mm, width=house.width_mm, height=house.height_mm)
        boxes = attributes(("capacity", house.capacity), ("stock", house.stock))
        yield f"  <storehouse{attributes(('name', house.name))}{place}{boxes}/>"
    for dock in world.docks:
        yield f"  <dock{_dock(dock)}/>"
    for start in world.starts:
        yield f"  <start{_start(start)}/>"
    for box in world.boxes:
        sides = _numbers(x=box.x_mm, y=box.y_mm, width=box.width_mm, height=box.height_mm)
        yield f"  <box{sides}{_numbers(mass=box.mass_g, friction=box.friction)}/>"
    for ball in world.balls:
        sides = _numbers(x=ball.x_mm, y=ball.y_mm, radius=ball.radius_mm)
        yield f"  <ball{sides}{_numbers(mass=ball.mass_g, friction=ball.friction)}/>"
    for zone in world.zones:
        yield f"  <zone{_zone(zone)}/>"
    for raw in (*world.prolog, *world.unknown):
        yield f"  {fragment(raw)}"
    for raw in remarks:
        yield f"  {raw}"
    yield "</world>"


def _numbers(**values: float) -> str:
    return attributes(*((name, number(value)) for name, value in values.items()))


def _texts(name: str, texts: Texts) -> Iterator[str]:
    for language, text in texts.items():
        yield f"  {text_element(name, language, text)}"


def _points(corners: tuple[Corner, ...]) -> Iterator[str]:
    for corner in corners:
        radius = _numbers(radius=corner.radius_mm) if corner.radius_mm else ""
        yield f"    <point{_numbers(x=corner.x_mm, y=corner.y_mm)}{radius}/>"


def _floor(floor: Floor) -> Iterator[str]:
    colour = attributes(("colour", floor.colour))
    if floor.rectangle is not None:
        x_mm, y_mm, width_mm, height_mm = floor.rectangle
        yield f"  <floor{colour}{_numbers(x=x_mm, y=y_mm, width=width_mm, height=height_mm)}/>"
        return
    yield f"  <floor{colour}>"
    yield from _points(floor.corners)
    yield "  </floor>"


def _line(line: ColouredLine) -> Iterator[str]:
    closed = attributes(("closed", "yes" if line.closed else None))
    yield f"  <line{attributes(('colour', line.colour), ('width', number(line.width_mm)))}{closed}>"
    yield from _points(line.corners)
    yield "  </line>"


def _road(road: Road) -> Iterator[str]:
    closed = attributes(("closed", "yes" if road.closed else None))
    yield f"  <road{attributes(('name', road.name), ('width', number(road.width_mm)))}{closed}>"
    yield from _points(road.corners)
    for section in road.sections:
        end = road.end_mm(section)
        stretch = attributes(("from", number(section.from_mm)), ("to", None if end is None else number(end)))
        yield f"    <section{attributes(('sign', section.sign))}{stretch}/>"
    yield "  </road>"


def _zone(zone: Zone) -> str:
    place = _numbers(x=zone.x_mm, y=zone.y_mm)
    if zone.radius_mm:
        shape = _numbers(radius=zone.radius_mm)
    else:
        shape = _numbers(width=zone.width_mm, height=zone.height_mm)
    return attributes(("kind", zone.kind)) + place + shape + _numbers(value=zone.value, falloff=zone.falloff_mm)


def _dock(dock: Dock) -> str:
    return attributes(
        ("name", dock.name),
        ("road", dock.road),
        ("at", number(dock.at_mm)),
        ("reach", number(dock.reach_mm)),
        ("storehouse", dock.storehouse),
        ("kind", dock.kind),
        ("side", None if dock.side == LEFT else dock.side),
    )


def _start(start: Start) -> str:
    name = attributes(("name", start.name))
    if start.pose is not None:
        heading = math.degrees(start.pose.heading_rad)
        return name + _numbers(x=start.pose.x_mm, y=start.pose.y_mm, heading=heading)
    if start.dock:
        return name + attributes(("dock", start.dock))
    if start.storehouse:
        return name + attributes(("storehouse", start.storehouse))
    return name + attributes(("road", start.road), ("at", number(start.at_mm)))
