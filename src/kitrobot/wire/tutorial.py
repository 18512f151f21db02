"""Tutorials, on the wire: what a person reads and where a step points. What it looks for stays with the server."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.tutorial.model import TeacherPage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape, problem_shapes
from kitrobot.wire.values import PointValue
from kitrobot.workspace.tutorials import FoundTutorial


class TutorialStepShape(BaseModel):
    """One step. `asks`: the program has to be in some way; `events`: one of these has to happen meanwhile."""

    label: dict[str, str]
    help: dict[str, str]
    hint: dict[str, str]
    points: list[PointValue]
    asks: bool
    events: list[str]


class TeacherPageShape(BaseModel):
    """What a teacher wants to know of a tutorial; each text by language."""

    minutes: int
    aim: dict[str, str]
    troubles: list[dict[str, str]]
    questions: list[dict[str, str]]


class TutorialShape(BaseModel):
    """A tutorial; `start` is the mission it begins with. One that cannot be used has no steps but `problems`."""

    name: str
    start: str
    label: dict[str, str]
    help: dict[str, str]
    icon: str
    steps: list[TutorialStepShape]
    teacher: TeacherPageShape | None
    problems: list[ProblemShape]


class TutorialWatchShape(BaseModel):
    """A mission, opened from `path`, to be held against a tutorial."""

    tutorial: str
    mission: MissionShape
    path: str


class TutorialFitShape(BaseModel):
    """For each step, whether the programs are as it wants them."""

    fits: list[bool]


def tutorial_shape(found: FoundTutorial) -> TutorialShape:
    """A tutorial as it travels."""
    tutorial = found.lesson
    return TutorialShape(
        name=found.name,
        start=found.start,
        label=dict(tutorial.label) if tutorial is not None else {},
        help=dict(tutorial.help) if tutorial is not None else {},
        icon=tutorial.icon if tutorial is not None else "",
        steps=[
            TutorialStepShape(
                label=dict(step.label),
                help=dict(step.help),
                hint=dict(step.hint),
                points=list(step.points),
                asks=bool(step.wants or step.team),
                events=list(step.events),
            )
            for step in (tutorial.steps if tutorial is not None else ())
        ],
        teacher=_teacher(tutorial.teacher) if tutorial is not None and tutorial.teacher is not None else None,
        problems=problem_shapes(found.problems),
    )


def _teacher(page: TeacherPage) -> TeacherPageShape:
    return TeacherPageShape(
        minutes=page.minutes,
        aim=dict(page.aim),
        troubles=[dict(texts) for texts in page.troubles],
        questions=[dict(texts) for texts in page.questions],
    )
