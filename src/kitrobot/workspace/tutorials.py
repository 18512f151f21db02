"""The tutorials at hand, and what of one is done."""

from __future__ import annotations

from dataclasses import replace

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.files.folder import TUTORIAL_ENDING, MissionFolder
from kitrobot.mission.model import Mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.sentences import Sentence
from kitrobot.tutorial.model import Tutorial
from kitrobot.tutorial.pattern_matcher import steps_fit
from kitrobot.tutorial.rules import START
from kitrobot.tutorial.tutorial_xml import read_tutorial
from kitrobot.workspace.lesson_library import FoundLesson, LessonKind, LessonLibrary

FoundTutorial = FoundLesson[Tutorial]
_KIND = LessonKind(
    TUTORIAL_ENDING,
    read_tutorial,
    MissionFolder.tutorials,
    START,
    lambda start: Sentence("there is no mission `{mission}` beside this tutorial", start),
    Sentence("this tutorial cannot be used any more"),
)


class Tutorials(LessonLibrary[Tutorial]):
    """The tutorials of a folder."""

    def __init__(self, folder: MissionFolder) -> None:
        super().__init__(folder, _KIND)


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
