"""The world that a mission brings along, on the wire: what it is made of, so that the page can change it.

Other than a `WorldShape`, which is there to be drawn, it has the corners of roads and lines with their radii, and says
of docks and starts what its file says. Lengths in mm, headings in degrees. Parts of it may not fit together.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal, cast

from pydantic import BaseModel, Field

from kitrobot.world.geometry import Corner, Pose, normalised
from kitrobot.world.model import (
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
    World,
    Zone,
)
from kitrobot.world.parts import MAX_NUMBER, MAX_SIZE_MM

MOST_THINGS = 20_000
"""Walls, corners, … of one kind."""


Millimetres = Annotated[float, Field(ge=-MAX_SIZE_MM, le=MAX_SIZE_MM, allow_inf_nan=False)]
Length = Annotated[float, Field(ge=0, le=MAX_SIZE_MM, allow_inf_nan=False)]
Count = Annotated[int, Field(ge=0, le=MAX_NUMBER)]
Colour = Literal["red", "green", "blue"]
Percent = Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)]


class CornerShape(BaseModel):
    """A corner of a line; a radius rounds it off."""

    x: Millimetres
    y: Millimetres
    radius: Length


class OwnWallShape(BaseModel):
    """A straight wall."""

    x1: Millimetres
    y1: Millimetres
    x2: Millimetres
    y2: Millimetres


class OwnFloorShape(BaseModel):
    """A coloured part of the floor."""

    colour: Colour
    points: Annotated[list[CornerShape], Field(max_length=MOST_THINGS)]


class OwnLineShape(BaseModel):
    """A coloured line on the floor."""

    colour: Colour
    width_mm: Length
    closed: bool
    points: Annotated[list[CornerShape], Field(max_length=MOST_THINGS)]


class OwnSectionShape(BaseModel):
    """A numbered stretch of a road; `to_mm` is None where it ends with its road."""

    sign: Count
    from_mm: Length
    to_mm: Length | None


class OwnRoadShape(BaseModel):
    """A road by its corners."""

    name: str
    width_mm: Length
    closed: bool
    points: Annotated[list[CornerShape], Field(max_length=MOST_THINGS)]
    sections: Annotated[list[OwnSectionShape], Field(max_length=MOST_THINGS)]


class OwnStorehouseShape(BaseModel):
    """A place for stock; `x_mm`, `y_mm` is its lower left corner."""

    name: str
    x_mm: Millimetres
    y_mm: Millimetres
    width_mm: Length
    height_mm: Length
    capacity: Count
    stock: Count


class OwnDockShape(BaseModel):
    """Where stock goes from a storehouse onto a carrier, or back."""

    name: str
    road: str
    at_mm: Length
    reach_mm: Length
    storehouse: str
    kind: Literal["load", "unload"]
    side: Literal["left", "right"]


class OwnStartShape(BaseModel):
    """Where an agent may start; `at` says which of the other fields count."""

    name: str
    at: Literal["pose", "road", "dock", "storehouse"]
    road: str
    at_mm: Length
    dock: str
    storehouse: str
    x_mm: Millimetres
    y_mm: Millimetres
    heading_deg: Annotated[float, Field(ge=-360, le=360, allow_inf_nan=False)]


class OwnBoxShape(BaseModel):
    """A box that can be pushed, around its middle."""

    x_mm: Millimetres
    y_mm: Millimetres
    width_mm: Length
    height_mm: Length
    mass_g: Length
    friction: Length


class OwnBallShape(BaseModel):
    """A ball that can be pushed, around its middle."""

    x_mm: Millimetres
    y_mm: Millimetres
    radius_mm: Length
    mass_g: Length
    friction: Length


class OwnZoneShape(BaseModel):
    """Where it is warm, loud or bright, around its middle: a circle, or a rectangle where its radius is 0."""

    kind: Literal["warm", "loud", "bright"]
    x_mm: Millimetres
    y_mm: Millimetres
    radius_mm: Length
    width_mm: Length
    height_mm: Length
    value: Percent
    falloff_mm: Length


class OwnWorldShape(BaseModel):
    """All of a world; `unknown` is XML that nobody knows, kept; `attributes` are those with a prefix."""

    name: str
    width_mm: Length
    height_mm: Length
    walls: Annotated[list[OwnWallShape], Field(max_length=MOST_THINGS)]
    floors: Annotated[list[OwnFloorShape], Field(max_length=MOST_THINGS)]
    lines: Annotated[list[OwnLineShape], Field(max_length=MOST_THINGS)]
    roads: Annotated[list[OwnRoadShape], Field(max_length=MOST_THINGS)]
    storehouses: Annotated[list[OwnStorehouseShape], Field(max_length=MOST_THINGS)]
    docks: Annotated[list[OwnDockShape], Field(max_length=MOST_THINGS)]
    starts: Annotated[list[OwnStartShape], Field(max_length=MOST_THINGS)]
    boxes: Annotated[list[OwnBoxShape], Field(max_length=MOST_THINGS)] = []
    balls: Annotated[list[OwnBallShape], Field(max_length=MOST_THINGS)] = []
    zones: Annotated[list[OwnZoneShape], Field(max_length=MOST_THINGS)] = []
    unknown: list[str]
    label: dict[str, str]
    help: dict[str, str]
    attributes: dict[str, str] = {}


def own_world_shape(world: World) -> OwnWorldShape:
    """A world as it travels to be changed."""
    return OwnWorldShape(
        name=world.name,
        width_mm=_mm(world.width_mm),
        height_mm=_mm(world.height_mm),
        walls=[
            OwnWallShape(x1=_mm(one.x1_mm), y1=_mm(one.y1_mm), x2=_mm(one.x2_mm), y2=_mm(one.y2_mm))
            for one in world.walls
        ],
        floors=[OwnFloorShape(colour=cast(Colour, one.colour), points=_points(one.corners)) for one in world.floors],
        lines=[
            OwnLineShape(
                colour=cast(Colour, one.colour),
                width_mm=_mm(one.width_mm),
                closed=one.closed,
                points=_points(one.corners),
            )
            for one in world.lines
        ],
        roads=[_road_shape(one) for one in world.roads],
        storehouses=[
            OwnStorehouseShape(
                name=one.name,
                x_mm=_mm(one.x_mm),
                y_mm=_mm(one.y_mm),
                width_mm=_mm(one.width_mm),
                height_mm=_mm(one.height_mm),
                capacity=one.capacity,
                stock=one.stock,
            )
            for one in world.storehouses
        ],
        docks=[
            OwnDockShape(
                name=one.name,
                road=one.road,
                at_mm=_mm(one.at_mm),
                reach_mm=_mm(one.reach_mm),
                storehouse=one.storehouse,
                kind=cast(Literal["load", "unload"], one.kind),
                side=cast(Literal["left", "right"], one.side),
            )
            for one in world.docks
        ],
        starts=[_start_shape(one) for one in world.starts],
        boxes=[OwnBoxShape(**vars(one)) for one in world.boxes],
        balls=[OwnBallShape(**vars(one)) for one in world.balls],
        zones=[OwnZoneShape(**vars(one)) for one in world.zones],
        unknown=[*world.prolog, *world.unknown],
        label=dict(world.label),
        help=dict(world.help),
        attributes=dict(world.attributes),
    )


def own_world(shape: OwnWorldShape) -> World:
    """The world that travelled."""
    return World(
        shape.name,
        shape.width_mm,
        shape.height_mm,
        walls=tuple(Wall(one.x1, one.y1, one.x2, one.y2) for one in shape.walls),
        floors=tuple(Floor(one.colour, _corners(one.points)) for one in shape.floors),
        lines=tuple(ColouredLine(one.colour, one.width_mm, _corners(one.points), one.closed) for one in shape.lines),
        roads=tuple(_road(one) for one in shape.roads),
        storehouses=tuple(
            Storehouse(one.name, one.x_mm, one.y_mm, one.width_mm, one.height_mm, one.capacity, one.stock)
            for one in shape.storehouses
        ),
        docks=tuple(
            Dock(one.name, one.road, one.at_mm, one.reach_mm, one.storehouse, one.kind, one.side) for one in shape.docks
        ),
        starts=tuple(_start(one) for one in shape.starts),
        boxes=tuple(Box(**one.model_dump()) for one in shape.boxes),
        balls=tuple(Ball(**one.model_dump()) for one in shape.balls),
        zones=tuple(Zone(**one.model_dump()) for one in shape.zones),
        unknown=tuple(shape.unknown),
        attributes=shape.attributes,
        label=dict(shape.label),
        help=dict(shape.help),
    )


def _mm(value: float) -> float:
    """As a file says it: a thousandth of a mm."""
    return round(value, 3) + 0.0


def _points(corners: tuple[Corner, ...]) -> list[CornerShape]:
    return [CornerShape(x=_mm(one.x_mm), y=_mm(one.y_mm), radius=_mm(one.radius_mm)) for one in corners]


def _corners(points: list[CornerShape]) -> tuple[Corner, ...]:
    return tuple(Corner(point.x, point.y, point.radius) for point in points)


def _road_shape(road: Road) -> OwnRoadShape:
    try:
        length = road.line.length_mm
    except ValueError:
        length = math.inf
    return OwnRoadShape(
        name=road.name,
        width_mm=_mm(road.width_mm),
        closed=road.closed,
        points=_points(road.corners),
        sections=[
            OwnSectionShape(
                sign=one.sign,
                from_mm=_mm(one.from_mm),
                to_mm=None if math.isinf(one.to_mm) or math.isclose(one.to_mm, length) else _mm(one.to_mm),
            )
            for one in road.sections
        ],
    )


def _road(shape: OwnRoadShape) -> Road:
    corners = _corners(shape.points)
    road = Road(shape.name, shape.width_mm, shape.closed, corners)
    try:
        length = road.line.length_mm
    except ValueError:
        length = math.inf
    sections = tuple(
        Section(one.sign, one.from_mm, length if one.to_mm is None else one.to_mm) for one in shape.sections
    )
    return Road(shape.name, shape.width_mm, shape.closed, corners, sections)


def _start_shape(start: Start) -> OwnStartShape:
    pose = start.pose or Pose(0.0, 0.0, 0.0)
    return OwnStartShape(
        name=start.name,
        at="pose" if start.pose else "dock" if start.dock else "storehouse" if start.storehouse else "road",
        road=start.road,
        at_mm=_mm(start.at_mm),
        dock=start.dock,
        storehouse=start.storehouse,
        x_mm=_mm(pose.x_mm),
        y_mm=_mm(pose.y_mm),
        heading_deg=_mm(math.degrees(pose.heading_rad)),
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
