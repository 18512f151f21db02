"""The world that a mission brings along, on the wire: what it is made of, so that the page can change it.

Other than a `WorldShape`, which is there to be drawn, it has the corners of roads and lines with their radii, and says
of docks and starts what its file says. Lengths in mm, headings in degrees. Parts of it may not fit together.
"""

from __future__ import annotations

import math
from dataclasses import fields, is_dataclass, replace
from typing import Annotated, Any, Literal, TypeVar

from annotated_types import Ge, Le, MaxLen
from pydantic import Field

from kitrobot.wire.values import View, WireFields
from kitrobot.world.geometry import Pose, normalised
from kitrobot.world.limits import MOST_PARTS, Coordinate, Count, Length
from kitrobot.world.model import (
    Ball,
    Box,
    ColouredLine,
    Corners,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    World,
    Zone,
)

T = TypeVar("T")
Parts = Annotated[tuple[T, ...], MaxLen(MOST_PARTS), WireFields()]


class OwnSectionShape(View):
    """A numbered stretch of a road; `to_mm` is None where it ends with its road."""

    sign: Count
    from_mm: Length
    to_mm: Length | None


class OwnRoadShape(View):
    """A road by its corners."""

    name: str
    width_mm: Length
    closed: bool
    points: Annotated[Corners, WireFields()]
    sections: Annotated[list[OwnSectionShape], MaxLen(MOST_PARTS)]


class OwnStartShape(View):
    """Where an agent may start; `at` says which of the other fields count."""

    name: str
    at: Literal["pose", "road", "dock", "storehouse"]
    road: str
    at_mm: Length
    dock: str
    storehouse: str
    x_mm: Coordinate
    y_mm: Coordinate
    heading_deg: Annotated[float, Ge(-360), Le(360)]


class OwnWorldShape(View):
    """All of a world; `unknown` is XML that nobody knows, kept; `attributes` are those with a prefix."""

    name: str
    width_mm: Length
    height_mm: Length
    walls: Parts[Wall]
    floors: Parts[Floor]
    lines: Parts[ColouredLine]
    roads: Annotated[list[OwnRoadShape], MaxLen(MOST_PARTS)]
    storehouses: Parts[Storehouse]
    docks: Parts[Dock]
    starts: Annotated[list[OwnStartShape], MaxLen(MOST_PARTS)]
    boxes: Parts[Box] = ()
    balls: Parts[Ball] = ()
    zones: Parts[Zone] = ()
    unknown: tuple[str, ...]
    label: dict[str, str]
    help: dict[str, str]
    attributes: dict[str, str] = Field(default_factory=dict)


def own_world_shape(world: World) -> OwnWorldShape:
    """A world as it travels to be changed: lengths as its file says them."""
    parts = {name: _thousandths(getattr(world, name)) for name in OwnWorldShape.model_fields}
    changed = {
        "roads": [_road_shape(one) for one in world.roads],
        "starts": [_start_shape(one) for one in world.starts],
        "unknown": (*world.prolog, *world.unknown),
    }
    return OwnWorldShape(**{**parts, **changed})


def own_world(shape: OwnWorldShape) -> World:
    """The world that travelled."""
    parts = dict(shape)
    parts["roads"] = tuple(_road(one) for one in shape.roads)
    parts["starts"] = tuple(_start(one) for one in shape.starts)
    return World(**parts)


def _thousandths(value: Any) -> Any:
    """The same with each length to a thousandth of a mm; what is no dataclass, tuple or float stays."""
    if isinstance(value, float):
        return round(value, 3) + 0.0
    if isinstance(value, tuple):
        return tuple(_thousandths(one) for one in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{one.name: _thousandths(getattr(value, one.name)) for one in fields(value)})
    return value


def _road_shape(road: Road) -> OwnRoadShape:
    sections = [
        OwnSectionShape(sign=one.sign, from_mm=_thousandths(one.from_mm), to_mm=_thousandths(road.end_mm(one)))
        for one in road.sections
    ]
    width, corners = _thousandths((road.width_mm, road.corners))
    return OwnRoadShape(name=road.name, width_mm=width, closed=road.closed, points=corners, sections=sections)


def _road(shape: OwnRoadShape) -> Road:
    road = Road(shape.name, shape.width_mm, shape.closed, shape.points)
    ends = (road.length_mm if one.to_mm is None else one.to_mm for one in shape.sections)
    sections = (Section(one.sign, one.from_mm, end) for one, end in zip(shape.sections, ends, strict=True))
    return replace(road, sections=tuple(sections))


def _start_shape(start: Start) -> OwnStartShape:
    pose = start.pose or Pose(0.0, 0.0, 0.0)
    at_mm, x_mm, y_mm, heading = _thousandths((start.at_mm, pose.x_mm, pose.y_mm, math.degrees(pose.heading_rad)))
    return OwnStartShape(
        name=start.name,
        at="pose" if start.pose else "dock" if start.dock else "storehouse" if start.storehouse else "road",
        road=start.road,
        at_mm=at_mm,
        dock=start.dock,
        storehouse=start.storehouse,
        x_mm=x_mm,
        y_mm=y_mm,
        heading_deg=heading,
    )


def _start(shape: OwnStartShape) -> Start:
    match shape.at:
        case "road":
            return Start(shape.name, road=shape.road, at_mm=shape.at_mm)
        case "dock":
            return Start(shape.name, dock=shape.dock)
        case "storehouse":
            return Start(shape.name, storehouse=shape.storehouse)
        case "pose":
            heading = normalised(math.radians(shape.heading_deg))
            return Start(shape.name, pose=Pose(shape.x_mm, shape.y_mm, heading))
