"""What a new mission can begin with, on the wire."""

from __future__ import annotations

from collections.abc import Iterable

from pydantic import BaseModel

from kitrobot.mission import Mission
from kitrobot.primitives import Catalogue, RobotObject
from kitrobot.server.shapes.mission import ProgramShape, mission_shape
from kitrobot.server.shapes.world import WorldShape, world_shape
from kitrobot.workspace import Choices, FoundPlace, Kit, Starter, Track


class AbilityShape(BaseModel):
    """A part of a robot, as it is called, and its picture."""

    icon: str
    label: dict[str, str]


class KitShape(BaseModel):
    """Robots to begin with; `places` are the names of those they fit, `can` and `feels` their actuators and sensors."""

    name: str
    label: dict[str, str]
    help: dict[str, str]
    robots: list[str]
    can: list[AbilityShape]
    feels: list[AbilityShape]
    places: list[str]


class BeginningPlaceShape(BaseModel):
    """A world to begin in."""

    name: str
    label: dict[str, str]
    help: dict[str, str]
    world: WorldShape


class StarterShape(BaseModel):
    """A first program; `places` says for each kit that it fits where it can be had."""

    name: str
    label: dict[str, str]
    help: dict[str, str]
    places: dict[str, list[str]]


class BeginningsShape(BaseModel):
    """All there is to choose from. The starter `nothing`, without parts, fits every kit in each of its places."""

    kits: list[KitShape]
    places: list[BeginningPlaceShape]
    starters: list[StarterShape]


class TrackShape(BaseModel):
    """The way of an agent: (x mm, y mm, heading rad), one each tenth of a second."""

    agent: str
    robot: str
    points: list[tuple[float, float, float]]


class PreviewShape(BaseModel):
    """A starter with its first program, and what its agents do in the first seconds."""

    starter: str
    program: ProgramShape
    tracks: list[TrackShape]


def kit_shape(kit: Kit, choices: Choices, catalogue: Catalogue) -> KitShape:
    """A kit with what its robots can do; one robot is called as its file says."""
    names = choices.robots_of(kit)
    robots = [catalogue.robots[name] for name in names if name in catalogue.robots]
    label, help = (kit.label, kit.help) if kit.label else (robots[0].label, robots[0].help)
    return KitShape(
        name=kit.name,
        label=dict(label),
        help=dict(help),
        robots=names,
        can=_abilities(part for robot in robots for part in robot.actuators),
        feels=_abilities(part for robot in robots for part in robot.sensors),
        places=choices.places_of(kit),
    )


def _abilities(parts: Iterable[RobotObject]) -> list[AbilityShape]:
    """Each once, by its name."""
    found = {part.name: part for part in parts}
    return [AbilityShape(icon=part.icon, label={"": name} | dict(part.label)) for name, part in found.items()]


def beginning_place_shape(place: FoundPlace) -> BeginningPlaceShape:
    """A place with its world."""
    label, help = dict(place.world.label), dict(place.world.help)
    return BeginningPlaceShape(name=place.name, label=label, help=help, world=world_shape(place.world))


def starter_shape(starter: Starter, choices: Choices) -> StarterShape:
    """A starter, called as its first mission is."""
    made = choices.mission(starter.name)
    places = {kit.name: choices.places_for(starter, kit) for kit in choices.kits}
    return StarterShape(
        name=starter.name,
        label=dict(made.label),
        help=dict(made.help),
        places={kit: names for kit, names in places.items() if names},
    )


def preview_shape(starter: str, mission: Mission, tracks: Iterable[Track]) -> PreviewShape:
    """A starter as it is previewed."""
    return PreviewShape(
        starter=starter,
        program=mission_shape(mission).programs[0],
        tracks=[TrackShape(agent=one.agent, robot=one.robot, points=list(one.points)) for one in tracks],
    )
