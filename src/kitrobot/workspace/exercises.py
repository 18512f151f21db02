"""The exercises at hand, and what was handed in put into the mission of an exercise.

From what was handed in only the programs count, with the own blocks and variables they are made of and the roles and
groups that programs of a team declare. World, robots, starts, goals, radio and failures are those of the exercise, so
nothing but the programs decides how a goal is judged, and no file beside a submission is ever read.
"""

from __future__ import annotations

from dataclasses import replace

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.exercise.model import Exercise
from kitrobot.exercise.rules import START
from kitrobot.files.folder import EXERCISE_ENDING, MissionFolder
from kitrobot.mission.model import Mission
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.lesson_library import FoundLesson, LessonKind, LessonLibrary

FoundExercise = FoundLesson[Exercise]
_KIND = LessonKind(
    EXERCISE_ENDING,
    read_exercise,
    MissionFolder.exercises,
    START,
    lambda start: Sentence("there is no mission `{mission}` beside this exercise", start),
    Sentence("this exercise cannot be used any more"),
)


class AnotherMissionError(KitRobotError):
    """What was handed in does not belong to this exercise."""


class Exercises(LessonLibrary[Exercise]):
    """The exercises of a folder."""

    def __init__(self, folder: MissionFolder) -> None:
        super().__init__(folder, _KIND)


def programs_of(mission: Mission) -> dict[str, str]:
    """The programs that agents run, each with the kind of robot that it is for ("" a team's)."""
    targets = {program.name: program.target for program in mission.programs}
    return {agent.program: targets[agent.program] for agent in mission.team.agents if agent.program in targets}


def handed_in(start: Mission, submission: Mission) -> Mission:
    """The mission of an exercise with the programs of a submission.

    Raises:
        AnotherMissionError: a program that an agent of the exercise runs is not there, or is for another robot.
    """
    for name, target in programs_of(start).items():
        program = submission.program(name)
        if program is None:
            raise AnotherMissionError(
                Sentence("this is another mission: it has no program `{program}`", name),
                Sentence("begin with the mission of the exercise, and keep the names of its programs"),
            )
        if program.target != target:
            found = program.target or Sentence("a team")
            raise AnotherMissionError(
                Sentence("the program `{program}` is for {found}, not for {robot}", name, found, target or "a team"),
                Sentence("begin with the mission of the exercise"),
            )
    team = replace(start.team, roles=submission.team.roles, groups=submission.team.groups)
    return replace(
        start,
        programs=submission.programs,
        team=team,
        constructors=submission.constructors,
        variables=submission.variables,
        breakpoints=[],
        unknown=[],
    )
