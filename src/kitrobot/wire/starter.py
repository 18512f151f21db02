"""What a new mission can begin with, on the wire."""

from __future__ import annotations

from collections.abc import Iterable

from pydantic import BaseModel

from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.robot import RobotObject
from kitrobot.wire.gallery import RunPreviewShape
from kitrobot.wire.world import WorldShape, world_shape
from kitrobot.workspace.new_mission_choices import FoundPlace, NewMissionChoices, RobotSet, Starter


class AbilityShape(BaseModel):
    """A part of a robot, as it is called, and its picture."""

    icon: str
    label: dict[str, str]


class RobotSetShape(BaseModel):
    """Robots to begin with; `places` are the names of those they fit, `can` and `feels` their actuators and sensors."""

    name: str
    label: dict[str, str]
    help: dict[str, str]
    robots: list[str]
    own: bool
    """Whether it is a robot of one's own, from the folder."""
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
    """A first program; `places` says for each set of robots that it fits where it can be had."""

    name: str
    label: dict[str, str]
    help: dict[str, str]
    places: dict[str, list[str]]


class BeginningsShape(BaseModel):
    """All there is to choose from. The starter `nothing`, without parts, fits every set in each of its places."""

    robot_sets: list[RobotSetShape]
    places: list[BeginningPlaceShape]
    starters: list[StarterShape]


class PreviewShape(BaseModel):
    """A starter, and what its agents do in the first seconds."""

    starter: str
    run: RunPreviewShape


def robot_set_shape(robot_set: RobotSet, choices: NewMissionChoices, catalogue: Catalogue) -> RobotSetShape:
    """A set of robots with what its robots can do; one robot is called as its file says."""
    names = choices.robots_of(robot_set)
    robots = [catalogue.robots[name] for name in names if name in catalogue.robots]
    label, help = (robot_set.label, robot_set.help) if robot_set.label else (robots[0].label, robots[0].help)
    return RobotSetShape(
        name=robot_set.name,
        label=dict(label),
        help=dict(help),
        robots=names,
        own=catalogue.is_own(robot_set.robot),
        can=_abilities(part for robot in robots for part in robot.actuators),
        feels=_abilities(part for robot in robots for part in robot.sensors),
        places=choices.places_of(robot_set),
    )


def _abilities(parts: Iterable[RobotObject]) -> list[AbilityShape]:
    """Each once, by its name."""
    found = {part.name: part for part in parts}
    return [AbilityShape(icon=part.icon, label={"": name} | dict(part.label)) for name, part in found.items()]


def beginning_place_shape(place: FoundPlace) -> BeginningPlaceShape:
    """A place with its world."""
    label, help = dict(place.world.label), dict(place.world.help)
    return BeginningPlaceShape(name=place.name, label=label, help=help, world=world_shape(place.world))


def starter_shape(starter: Starter, choices: NewMissionChoices) -> StarterShape:
    """A starter, called as its first mission is."""
    made = choices.mission(starter.name)
    places = {robot_set.name: choices.places_for(starter, robot_set) for robot_set in choices.robot_sets}
    return StarterShape(
        name=starter.name,
        label=dict(made.label),
        help=dict(made.help),
        places={robot_set: names for robot_set, names in places.items() if names},
    )
