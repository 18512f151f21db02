"""A world on the wire: mm and radians, x right, y up; roads are sampled so finely that their points can be stroked."""

from __future__ import annotations

from typing import Literal, cast

from pydantic import BaseModel

from kitrobot.wire.values import SectionValue, StorehouseValue
from kitrobot.world.model import LOAD, Dock, Start, World

FloorColour = Literal["red", "green", "blue"]
ZoneKind = Literal["warm", "loud", "bright"]


class WallShape(BaseModel):
    """A straight wall."""

    x1: float
    y1: float
    x2: float
    y2: float


class LineShape(BaseModel):
    """A coloured line on the floor, sampled like a road."""

    colour: FloorColour
    width_mm: float
    closed: bool
    points: list[tuple[float, float]]


class FloorShape(BaseModel):
    """A coloured part of the floor, by the points of its border, sampled like a road."""

    colour: FloorColour
    points: list[tuple[float, float]]


class RoadShape(BaseModel):
    """A road as the line along its middle."""

    name: str
    width_mm: float
    closed: bool
    points: list[tuple[float, float]]
    sections: list[SectionValue]


class DockShape(BaseModel):
    """Where stock goes from a storehouse onto a carrier, or back."""

    name: str
    road: str
    at_mm: float
    reach_mm: float
    storehouse: str
    kind: Literal["load", "unload"]
    x_mm: float
    y_mm: float
    heading_rad: float


class StartPoseShape(BaseModel):
    """Where an agent may start."""

    name: str
    x_mm: float
    y_mm: float
    heading_rad: float


class ThingShape(BaseModel):
    """Something that can be pushed, around its middle; of a ball width and height are its diameter."""

    kind: Literal["box", "ball"]
    x_mm: float
    y_mm: float
    width_mm: float
    height_mm: float


class ZoneShape(BaseModel):
    """Where it is warm, loud or bright, around its middle: a circle, or a rectangle where its radius is 0."""

    kind: ZoneKind
    x_mm: float
    y_mm: float
    radius_mm: float
    width_mm: float
    height_mm: float
    value: float
    falloff_mm: float


class WorldShape(BaseModel):
    """The place of a mission."""

    name: str
    width_mm: float
    height_mm: float
    walls: list[WallShape]
    floors: list[FloorShape]
    lines: list[LineShape]
    roads: list[RoadShape]
    docks: list[DockShape]
    storehouses: list[StorehouseValue]
    starts: list[StartPoseShape]
    things: list[ThingShape] = []
    """Boxes and then balls, in the order of the frames of a run."""
    zones: list[ZoneShape] = []


def world_shape(world: World) -> WorldShape:
    """A world as it travels."""
    return WorldShape(
        name=world.name,
        width_mm=world.width_mm,
        height_mm=world.height_mm,
        walls=[WallShape(x1=wall.x1_mm, y1=wall.y1_mm, x2=wall.x2_mm, y2=wall.y2_mm) for wall in world.walls],
        floors=[
            FloorShape(
                colour=cast(FloorColour, floor.colour), points=list(zip(floor.line.xs, floor.line.ys, strict=True))
            )
            for floor in world.floors
        ],
        lines=[
            LineShape(
                colour=cast(FloorColour, line.colour),
                width_mm=line.width_mm,
                closed=line.closed,
                points=list(zip(line.line.xs, line.line.ys, strict=True)),
            )
            for line in world.lines
        ],
        roads=[
            RoadShape(
                name=road.name,
                width_mm=road.width_mm,
                closed=road.closed,
                points=list(zip(road.line.xs, road.line.ys, strict=True)),
                sections=list(road.sections),
            )
            for road in world.roads
        ],
        docks=[_dock(world, dock) for dock in world.docks],
        storehouses=list(world.storehouses),
        starts=[_start(world, start) for start in world.starts],
        things=[
            *(
                ThingShape(kind="box", x_mm=one.x_mm, y_mm=one.y_mm, width_mm=one.width_mm, height_mm=one.height_mm)
                for one in world.boxes
            ),
            *(
                ThingShape(
                    kind="ball", x_mm=one.x_mm, y_mm=one.y_mm, width_mm=2 * one.radius_mm, height_mm=2 * one.radius_mm
                )
                for one in world.balls
            ),
        ],
        zones=[ZoneShape.model_validate(vars(one)) for one in world.zones],
    )


def _dock(world: World, dock: Dock) -> DockShape:
    pose = world.dock_pose(dock)
    return DockShape(
        name=dock.name,
        road=dock.road,
        at_mm=dock.at_mm,
        reach_mm=dock.reach_mm,
        storehouse=dock.storehouse,
        kind="load" if dock.kind == LOAD else "unload",
        x_mm=pose.x_mm,
        y_mm=pose.y_mm,
        heading_rad=pose.heading_rad,
    )


def _start(world: World, start: Start) -> StartPoseShape:
    pose = world.start_pose(start)
    return StartPoseShape(name=start.name, x_mm=pose.x_mm, y_mm=pose.y_mm, heading_rad=pose.heading_rad)
