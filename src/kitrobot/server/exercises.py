"""The requests behind exercises: which there are, and judging a mission piece by piece.

The page asks for one piece after another (a seed's run, then what is checked), so it knows how far it is and stops by
asking for no more; each piece is bounded by steps (`workspace.judging`). Hidden goals and seeds are not told here.
"""

from __future__ import annotations

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.routing import ThisStudio, api_router
from kitrobot.server.shapes import mission_from_shape, mission_shape
from kitrobot.server.shapes.exercise import (
    ExerciseShape,
    JudgedShape,
    JudgeShape,
    exercise_shape,
    goal_verdict_shapes,
)
from kitrobot.text import Sentence
from kitrobot.workspace import handed_in
from kitrobot.workspace.judging import JudgingOptions, judge

exercise_routes = api_router()


class NoExerciseError(KitRobotError):
    """An exercise that was there is there no more, or has a mistake now."""


@exercise_routes.get("/exercises")
def exercises(studio: ThisStudio) -> list[ExerciseShape]:
    """The exercises that come with KitRobot, then those of the folder."""
    return [exercise_shape(found) for found in studio.exercises.all()]


@exercise_routes.post("/exercise/judge")
def exercise_judge(studio: ThisStudio, wanted: JudgeShape) -> JudgedShape:
    """Judges a mission by an exercise: its programs and the run of one seed, or what is checked."""
    found = studio.exercises.found(wanted.exercise)
    if found.lesson is None:
        raise NoExerciseError(
            Sentence("this exercise cannot be used any more"),
            Sentence("look at its file, or leave it"),
            tuple(found.problems),
        )
    data, _ = studio.folder.read(found.start)
    start = studio.read(data, found.start, found.start)
    mission = handed_in(start.mission, mission_from_shape(wanted.mission))
    opened = studio.open(mission, found.start)
    checks = wanted.seed is None
    seeds = () if wanted.seed is None else (wanted.seed,)
    made = judge(found.lesson, opened, JudgingOptions(seeds=seeds, runs=not checks, checks=checks))
    return JudgedShape(goals=goal_verdict_shapes(made), mission=mission_shape(mission))
