"""The choices for a new mission: a set of robots, a place, and a first program that moves.

`shipped/beginnings.xml` names sets of robots, places and starters; their labels come from the robots, worlds and
missions themselves. A set fits a place that has a start for each of its agents, and a starter fits the sets for which
it has a mission. The user's own robots are sets too, after the others. Left to others: showing the choices (server,
page).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic, KitRobotError
from kitrobot.files.folder import EXAMPLE, MissionFolder
from kitrobot.graph.model import Program, empty_program
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import NEW_PROGRAM, mission_of
from kitrobot.workspace.worlds import read_world_file
from kitrobot.world.lookup import EMPTY, find_world
from kitrobot.world.model import World
from kitrobot.xml.attributes import NAME, Kind, needed, optional, version
from kitrobot.xml.element import LONGEST_NAME, Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

VERSION = 1
"""The newest version of the list that is read."""

NOTHING = "nothing"
"""The starter without parts: start and stop alone. It fits every set in every place."""

PREVIEW_S = 7.9
"""Simulated seconds that a preview shows: as many as are shown as quickly as they pass."""

_SHIPPED = Path(__file__).parent / "shipped" / "beginnings.xml"


class NoBeginningError(KitRobotError):
    """A set of robots, a place or a starter that is not there, or that does not fit the others."""


@dataclass(frozen=True)
class RobotSet:
    """Robots to begin with: one, or the team of a mission. `places`: only these, where it says any."""

    name: str
    robot: str
    mission: str
    places: tuple[str, ...]
    label: Mapping[str, str]
    help: Mapping[str, str]


@dataclass(frozen=True)
class Starter:
    """A first program: for each set of robots its mission among the examples, and the places it is for (none: any)."""

    missions: Mapping[str, str]
    places: Mapping[str, tuple[str, ...]]

    @property
    def name(self) -> str:
        """By what it is known: the first of its missions."""
        return next(iter(self.missions.values()))


@dataclass(frozen=True)
class Beginnings:
    """All there is to choose from."""

    robot_sets: tuple[RobotSet, ...]
    places: tuple[str, ...]
    starters: tuple[Starter, ...]


# -- reading

_WORLD = Kind(longest=LONGEST_NAME, fits=re.compile(r"[\w.-]+\.xml").fullmatch, words=Sentence("the name of a world"))
_MISSION = Kind(
    longest=LONGEST_NAME,
    fits=re.compile(r"[\w-][\w.-]*(/[\w-][\w.-]*)*\.krt").fullmatch,
    words=Sentence("the path of a .krt"),
)


@dataclass(frozen=True)
class _For:
    robot_set: str
    mission: str
    places: tuple[str, ...]


def _robot_set(element: Element) -> RobotSet:
    return RobotSet(
        element.matching("name"),
        element.optional("robot"),
        element.optional("mission"),
        tuple(element.optional("places").split()),
        element.texts.get("label", {}),
        element.texts.get("help", {}),
    )


def _place(element: Element) -> str:
    return element.matching("world")


def _for(element: Element) -> _For:
    return _For(element.matching("robots"), element.matching("mission"), tuple(element.optional("places").split()))


def _starter(element: Element) -> Starter | None:
    found = element.found(_For)
    if not found:
        return None
    return Starter({one.robot_set: one.mission for one in found}, {one.robot_set: one.places for one in found})


BEGINNINGS = {
    "beginnings": Tag(
        None,
        {"version": version(VERSION)},
        {
            "robots": Tag(
                _robot_set,
                {"name": needed(), "robot": optional(), "mission": optional(_MISSION), "places": optional()},
                TEXTS,
            ),
            "place": Tag(_place, {"world": needed(_WORLD)}),
            "starter": Tag(
                _starter,
                {},
                {"for": Tag(_for, {"robots": needed(NAME), "mission": needed(_MISSION), "places": optional()})},
            ),
        },
        open=lambda root: root.version(VERSION),
    )
}


def read_beginnings(data: bytes, name: str) -> tuple[Beginnings | None, list[Diagnostic]]:
    """Reads a list of beginnings; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read(BEGINNINGS)
    if root is None or root.faulty:
        return None, reader.diagnostics
    made = Beginnings(tuple(root.found(RobotSet)), tuple(root.found(str)), tuple(root.found(Starter)))
    return made, reader.diagnostics


@cache
def shipped_beginnings() -> Beginnings:
    """Those that come with KitRobot."""
    made, problems = read_beginnings(_SHIPPED.read_bytes(), _SHIPPED.name)
    assert made is not None, problems
    return made


# -- what fits


@dataclass(frozen=True)
class FoundPlace:
    """A place with its world; `href` is what a mission in it says, "" for the empty one."""

    name: str
    href: str
    world: World


class NewMissionChoices:
    """The beginnings of a studio: with their worlds and missions, which are read once.

    What is not at hand (an installation without examples) is left out.
    """

    def __init__(self, folder: MissionFolder, beginnings: Beginnings | None = None) -> None:
        self._folder = folder
        self._missions: dict[str, Mission] = {}
        made = beginnings or shipped_beginnings()
        self.starters = tuple(one for one in made.starters if all(map(self._there, one.missions.values())))
        self.robot_sets = tuple(one for one in made.robot_sets if one.robot or self._there(one.mission))
        self.places = tuple(filter(None, map(_found_place, made.places)))

    def with_own(self, catalogue: Catalogue) -> NewMissionChoices:
        """These, and a set of each robot of the catalogue that does not come with KitRobot and is in no set yet.

        It fits every place with a start of the usual name, and begins without parts.
        """
        made = copy(self)
        taken = {one.robot or one.name for one in self.robot_sets}
        own = (name for name in catalogue.robot_files if catalogue.is_own(name) and name not in taken)
        made.robot_sets = (*self.robot_sets, *(RobotSet(name, name, "", (), {}, {}) for name in own))
        return made

    def _there(self, path: str) -> bool:
        return (self._folder.examples / path).is_file()

    def mission(self, path: str) -> Mission:
        """A mission among the examples, to be copied and not changed."""
        made = self._missions.get(path)
        if made is None:
            data, _ = self._folder.read(f"{EXAMPLE}{path}")
            made, problems = read_mission(data, path)
            assert made is not None, problems
            self._missions[path] = made
        return made

    def robots_of(self, robot_set: RobotSet) -> list[str]:
        """The kinds of robots of a set of robots, each once."""
        return list(dict.fromkeys(program.target for program in self._team(robot_set).programs))

    def places_of(self, robot_set: RobotSet) -> list[str]:
        """The names of the places that a set of robots fits."""
        starts = {agent.start_name for agent in self._team(robot_set).team.agents}
        return [
            place.name
            for place in self.places
            if (not robot_set.places or place.name in robot_set.places)
            and starts <= {one.name for one in place.world.starts}
        ]

    def places_for(self, starter: Starter, robot_set: RobotSet) -> list[str]:
        """The places in which a starter can be had for a set of robots."""
        only = starter.places.get(robot_set.name, ())
        if robot_set.name not in starter.missions:
            return []
        return [name for name in self.places_of(robot_set) if not only or name in only]

    def starters_of(self, robot_set: RobotSet, place: str) -> list[str]:
        """The names of the starters for a set of robots in a place, the one without parts first."""
        return [NOTHING, *(one.name for one in self.starters if place in self.places_for(one, robot_set))]

    def robot_set(self, name: str) -> RobotSet:
        """The set of that name.

        Raises:
            NoBeginningError: there is none.
        """
        for one in self.robot_sets:
            if one.name == name:
                return one
        raise _no_beginning(name)

    def begin(self, robot_set: str, place: str, starter: str) -> Mission:
        """The mission that begins with these; it has no title, and no file yet.

        Raises:
            NoBeginningError: one of them is not there, or they do not fit each other.
        """
        chosen = self.robot_set(robot_set)
        if place not in self.places_of(chosen):
            raise _no_beginning(place)
        if starter not in self.starters_of(chosen, place):
            raise _no_beginning(starter)
        href = next(one.href for one in self.places if one.name == place)
        if starter == NOTHING:
            return replace(self._team(chosen), world_href=href)
        made = _untitled(self.mission(starter_mission(self.starters, starter, robot_set)))
        if chosen.robot:
            # One robot starts where every place has a start.
            made = replace(made, team=mission_of(made.programs[0]).team)
        return replace(made, world_href=href)

    def _team(self, robot_set: RobotSet) -> Mission:
        """The team of a set of robots, with programs without parts."""
        if robot_set.robot:
            return mission_of(empty_program(NEW_PROGRAM, robot_set.robot))
        made = self.mission(robot_set.mission)
        programs = [_emptied(program) for program in made.programs]
        return replace(_untitled(made), programs=programs)


def starter_mission(starters: tuple[Starter, ...], name: str, robot_set: str) -> str:
    """The path of a starter's mission for a set of robots."""
    return next(one.missions[robot_set] for one in starters if one.name == name)


def _untitled(mission: Mission) -> Mission:
    """Without what belongs to the example alone: its title, its place, what was tried with it."""
    bare = replace(mission, own_world=None, label={}, help={}, breakpoints=[], failures=[])
    return replace(bare, unknown=[], prolog=[], attributes={})


def _emptied(program: Program) -> Program:
    return empty_program(program.name, program.target)


def _found_place(name: str) -> FoundPlace | None:
    path = find_world(name, [])
    world = None if path is None else read_world_file(path)[0]
    return None if world is None else FoundPlace(name, "" if name == EMPTY else name, world)


def _no_beginning(name: str) -> NoBeginningError:
    return NoBeginningError(
        Sentence("a new mission cannot begin with `{choice}` here", name), Sentence("choose again under File, New")
    )
