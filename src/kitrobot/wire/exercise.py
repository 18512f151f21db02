"""Exercises, on the wire: what a person reads of one, and what came of judging; nothing of what is hidden."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from kitrobot.checking.exercise_evaluation import Evaluation
from kitrobot.exercise.goals import CheckGoal, Goal, ProgramGoal
from kitrobot.sim.setup.limits import MAX_SEED
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape, problem_shapes
from kitrobot.wire.sentences import Spoken
from kitrobot.wire.values import View
from kitrobot.workspace.exercises import FoundExercise
from kitrobot.xml.lessons import LAST

GoalKind = Literal["program", "run", "check", "watched"]
JudgingName = Annotated[str, Field(max_length=100)]


class ExerciseGoalShape(BaseModel):
    """A goal; `kind` is what it is decided from. `watched` is a property that only runs can judge; where no check of a
    mission can, runs judge a `check` too.
    """

    label: dict[str, str]
    kind: GoalKind


class ExerciseShape(BaseModel):
    """An exercise; `start` is the mission it begins with, `order` its place on the path to learn, `seconds` how long
    each run may take, `seeds` are those of its runs. One that cannot be used has no goals but `problems`.
    """

    name: str
    start: str
    label: dict[str, str]
    help: dict[str, str]
    icon: str
    order: int
    seconds: float
    seeds: list[int]
    goals: list[ExerciseGoalShape]
    problems: list[ProblemShape]


class JudgeShape(BaseModel):
    """A mission to be judged by an exercise: its programs and the run of `seed`; without one, what is checked.
    `judging` is a name by which it can be stopped.
    """

    exercise: Annotated[str, Field(max_length=1000)]
    mission: MissionShape
    seed: Annotated[int, Field(ge=0, le=min(MAX_SEED, 2**53))] | None = None
    judging: JudgingName = ""


class StopJudgingShape(BaseModel):
    """The name of the judging that is to be broken off."""

    judging: JudgingName


class GoalVerdictShape(View):
    """What came of a goal; `reached` is null where this piece says nothing of it. `why` is what went wrong, or how a
    check knows that it is reached. `seed` and `seconds` are the run and the moment that show what went wrong.
    """

    reached: bool | None
    why: Spoken
    seed: int | None
    seconds: float | None


class JudgedShape(BaseModel):
    """What came of each goal, in order; `mission` is what was judged: the programs in the exercise's mission."""

    goals: list[GoalVerdictShape]
    mission: MissionShape


def exercise_shape(found: FoundExercise) -> ExerciseShape:
    """An exercise as it travels."""
    exercise = found.lesson
    goals = exercise.goals_for(hidden=False) if exercise is not None else ()
    return ExerciseShape(
        name=found.name,
        start=found.start,
        label=dict(exercise.label) if exercise is not None else {},
        help=dict(exercise.help) if exercise is not None else {},
        icon=exercise.icon if exercise is not None else "",
        order=exercise.order if exercise is not None else LAST,
        seconds=exercise.seconds if exercise is not None else 0.0,
        seeds=list(exercise.seeds_for(hidden=False)) if exercise is not None else [],
        goals=[ExerciseGoalShape(label=dict(goal.label), kind=_kind(goal)) for goal in goals],
        problems=problem_shapes(found.problems),
    )


def _kind(goal: Goal) -> GoalKind:
    if isinstance(goal, CheckGoal):
        return "watched" if goal.asked is not None and goal.asked.counts_seconds else "check"
    return "program" if isinstance(goal, ProgramGoal) else "run"


def goal_verdict_shapes(made: Evaluation) -> list[GoalVerdictShape]:
    """The verdicts as they travel."""
    return [GoalVerdictShape.model_validate(one) for one in made.verdicts]
