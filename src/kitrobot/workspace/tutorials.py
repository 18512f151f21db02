"""The tutorials at hand: those that come with KitRobot and those that lie in the mission folder.

A tutorial is known by its file's name in the folder, as a mission is. One that has a mistake is found too, with what is
wrong with it, so that whoever writes it sees that. Files are read again only when they changed.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import PurePosixPath

from kitrobot.compiler import graph_to_lll
from kitrobot.diagnostics import Diagnostic, KitRobotError, Place
from kitrobot.files import (
    NAME_NO_TEXT,
    RENAME,
    TUTORIAL_ENDING,
    UNREADABLE,
    FileError,
    MissionFolder,
    name_as_text,
    read_bytes,
)
from kitrobot.mission import Mission
from kitrobot.primitives import Catalogue
from kitrobot.text import Sentence
from kitrobot.tutorial import Tutorial, read_tutorial, steps_fit
from kitrobot.tutorial.rules import START

MOST_KEPT = 200
"""Tutorials that are kept as they were read."""


@dataclass(frozen=True)
class FoundTutorial:
    """A tutorial of that name; None in place of it when it has a mistake. `start` is the name of its mission."""

    name: str
    tutorial: Tutorial | None
    start: str
    problems: tuple[Diagnostic, ...]


_Stamp = tuple[int, int]


class Tutorials:
    """The tutorials of a folder. Safe to use from many threads: what two read at once is the same."""

    def __init__(self, folder: MissionFolder) -> None:
        self._folder = folder
        self._kept: dict[str, tuple[_Stamp, FoundTutorial]] = {}

    def all(self) -> list[FoundTutorial]:
        """Every tutorial: those that come with KitRobot, then those of the folder."""
        return [self._listed(name) for name in self._folder.tutorials()]

    def _listed(self, name: str) -> FoundTutorial:
        """One of the list: what cannot be used says why, and the others are there all the same."""
        try:
            name.encode()
            return self.found(name)
        except UnicodeEncodeError:
            name = name_as_text(name)
            return FoundTutorial(name, None, "", (UNREADABLE(NAME_NO_TEXT, Place(name), help=RENAME),))
        except KitRobotError as error:
            return FoundTutorial(name, None, "", (UNREADABLE(error.message, Place(name), help=error.help),))

    def starts(self) -> set[str]:
        """The names of the missions that a tutorial begins with."""
        return {found.start for found in self.all() if found.start}

    def found(self, name: str) -> FoundTutorial:
        """The tutorial of that name, with what is wrong with it.

        Raises:
            MissionNameError: the name is no name of a tutorial, or leads out of the folder.
        """
        path = self._folder.path_of(name, TUTORIAL_ENDING)
        try:
            state = os.stat(path)
            stamp = (state.st_mtime_ns, state.st_size)
            kept = self._kept.get(name)
            if kept is not None and kept[0] == stamp:
                return self._with_start(kept[1])
            tutorial, problems = read_tutorial(read_bytes(path), name)
        except (FileError, OSError) as error:
            why = error.message if isinstance(error, FileError) else Sentence("the file `{name}` cannot be read", name)
            return FoundTutorial(name, None, "", (UNREADABLE(why, Place(name)),))
        start = str(PurePosixPath(name).parent / tutorial.start) if tutorial is not None else ""
        found = FoundTutorial(name, tutorial, start, tuple(problems))
        if len(self._kept) >= MOST_KEPT:
            self._kept.clear()
        self._kept[name] = (stamp, found)
        return self._with_start(found)

    def _with_start(self, found: FoundTutorial) -> FoundTutorial:
        """The same; without its mission it cannot begin, and says so."""
        if found.tutorial is None:
            return found
        try:
            there = self._folder.path_of(found.start).is_file()
        except KitRobotError:
            there = False
        if there:
            return found
        message = Sentence("there is no mission `{mission}` beside this tutorial", found.tutorial.start)
        problem = START(message, Place(found.name), help=Sentence("put the mission that it begins with there"))
        return FoundTutorial(found.name, None, "", (*found.problems, problem))


def watched(tutorial: Tutorial, mission: Mission, catalogue: Catalogue) -> list[bool]:
    """For each step, whether the mission is as it wants it; programs with mistakes count too."""
    trees = {
        program.name: graph_to_lll(program, catalogue).program
        for program in mission.programs
        if program.level.is_team or program.target in catalogue.robots
    }
    crew = mission.crew
    if crew is not None:
        kinds = dict(crew.agents)
        team = [agent.name for agent in mission.team.agents if agent.program == mission.social]
        crew = replace(crew, agents=tuple((name, kinds[name]) for name in team))
    return steps_fit(tutorial, trees, crew)
