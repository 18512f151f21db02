"""The requests behind exercises: which there are, and judging a mission piece by piece.

The page asks for one piece after another (a seed's run, then what is checked), so it knows how far it is; the piece
that is on is broken off by the name that the page gave it, and answers with what it found. Each piece is bounded by
steps (`checking.exercise_evaluation`). Hidden goals and seeds are not sent.
"""

from __future__ import annotations

from fastapi import Request

from kitrobot.checking.exercise_evaluation import EvaluationOptions, evaluate_submission
from kitrobot.live.background import StopSignal
from kitrobot.live.studio import Studio
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.request_cancellation import run_until_disconnect
from kitrobot.wire.exercise import (
    ExerciseShape,
    JudgedShape,
    JudgeShape,
    StopJudgingShape,
    exercise_shape,
    goal_verdict_shapes,
)
from kitrobot.wire.mission import mission_from_shape, mission_shape
from kitrobot.workspace.exercises import handed_in

exercise_routes = api_router()


@exercise_routes.get("/exercises")
def exercises(studio: ThisStudio) -> list[ExerciseShape]:
    """The exercises that come with KitRobot, then those of the folder."""
    return [exercise_shape(found) for found in studio.exercises.all()]


@exercise_routes.post("/exercise/judge")
async def exercise_judge(studio: ThisStudio, request: Request, wanted: JudgeShape) -> JudgedShape:
    """Judges a mission by an exercise: its programs and the run of one seed, or what is checked."""
    stop = studio.judging.setdefault(wanted.judging, StopSignal()) if wanted.judging else StopSignal()
    try:
        return await run_until_disconnect(request, lambda stop: _judged(studio, wanted, stop), stop)
    finally:
        studio.judging.pop(wanted.judging, None)


def _judged(studio: Studio, wanted: JudgeShape, stop: StopSignal) -> JudgedShape:
    exercise, start_name = studio.exercises.usable(wanted.exercise)
    data, _ = studio.folder.read(start_name)
    start = studio.read(data, start_name, start_name)
    mission = handed_in(start.mission, mission_from_shape(wanted.mission))
    opened = studio.open(mission, start_name)
    checks = wanted.seed is None
    seeds = () if wanted.seed is None else (wanted.seed,)
    options = EvaluationOptions(seeds=seeds, runs=not checks, checks=checks, stop=stop.is_set)
    made = evaluate_submission(exercise, opened, options, start=start)
    return JudgedShape(goals=goal_verdict_shapes(made), mission=mission_shape(mission))


@exercise_routes.post("/exercise/stop")
def exercise_stop(studio: ThisStudio, wanted: StopJudgingShape) -> bool:
    """Breaks off the judging of that name; whether it was on."""
    stop = studio.judging.get(wanted.judging)
    if stop is not None:
        stop.set()
    return stop is not None
