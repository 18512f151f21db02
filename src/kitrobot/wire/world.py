"""A world on the wire: mm and radians, x right, y up; roads are sampled so finely that their points can be stroked."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from kitrobot.wire.values import View
from kitrobot.world.limits import DockKind, FloorColour
from kitrobot.world.model import Dock, Section, Start, Storehouse, Wall, World, Zone


class LineOutlineShape(BaseModel):
    """A coloured line on the floor, sampled like a road."""

    colour: FloorColour
    width_mm: float
    closed: bool
    points: list[tuple[float, float]]


class FloorOutlineShape(BaseModel):
    """A coloured part of the floor, by the points of its border, sampled like a road."""

    colour: FloorColour
    points: list[tuple[float, float]]


class RoadShape(BaseModel):
    """A road as the line along its middle."""

    name: str
    width_mm: float
    closed: bool
    points: list[tuple[float, float]]
    sections: tuple[Section, ...]


class DockPoseShape(BaseModel):
    """Where stock goes from a storehouse onto a carrier, or back."""

    name: str
    road: str
    at_mm: float
    reach_mm: float
    storehouse: str
    kind: DockKind
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


class WorldShape(View):
    """The place of a mission."""

    name: str
    width_mm: float
    height_mm: float
    walls: tuple[Wall, ...]
    floors: list[FloorOutlineShape]
    lines: list[LineOutlineShape]
    roads: list[RoadShape]
    docks: list[DockPoseShape]
    storehouses: tuple[Storehouse, ...]
    starts: list[StartPoseShape]
    things: list[ThingShape] = Field(default_factory=list)
    """Boxes and then balls, in the order of the frames of a run."""
    zones: tuple[Zone, ...] = ()


def world_shape(world: World) -> WorldShape:
    """A world as it travels."""
    return WorldShape(
        name=world.name,
        width_mm=world.width_mm,
        height_mm=world.height_mm,
        walls=world.walls,
        floors=[
            FloorOutlineShape(colour=floor.colour, points=list(zip(floor.line.xs, floor.line.ys, strict=True)))
            for floor in world.floors
        ],
        lines=[
            LineOutlineShape(
                colour=line.colour,
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
                sections=road.sections,
            )
            for road in world.roads
        ],
        docks=[_dock(world, dock) for dock in world.docks],
        storehouses=world.storehouses,
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
        zones=world.zones,
    )


def _dock(world: World, dock: Dock) -> DockPoseShape:
    pose = world.dock_pose(dock)
    return DockPoseShape(
        name=dock.name,
        road=dock.road,
        at_mm=dock.at_mm,
        reach_mm=dock.reach_mm,
        storehouse=dock.storehouse,
        kind=dock.kind,
        x_mm=pose.x_mm,
        y_mm=pose.y_mm,
        heading_rad=pose.heading_rad,
    )


def _start(world: World, start: Start) -> StartPoseShape:
    pose = world.start_pose(start)
    return StartPoseShape(name=start.name, x_mm=pose.x_mm, y_mm=pose.y_mm, heading_rad=pose.heading_rad)
