"""Tutorials, on the wire: what a person reads and where a step points. What it looks for stays with the server."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel

from kitrobot.tutorial.model import TeacherPage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape, problem_shapes
from kitrobot.wire.values import PointValue, View, WireFields
from kitrobot.workspace.tutorials import FoundTutorial
from kitrobot.xml.lessons import LAST

TeacherPageValue = Annotated[TeacherPage, WireFields()]


class TutorialStepShape(View):
    """One step. `asks`: the program has to be in some way; `events`: one of these has to happen meanwhile."""

    label: dict[str, str]
    help: dict[str, str]
    hint: dict[str, str]
    points: list[PointValue]
    asks: bool
    events: list[str]


class TutorialShape(BaseModel):
    """A tutorial; `start` is the mission it begins with, `order` its place on the path to learn. One that cannot be
    used has no steps but `problems`.
    """

    name: str
    start: str
    label: dict[str, str]
    help: dict[str, str]
    icon: str
    order: int
    steps: list[TutorialStepShape]
    teacher: TeacherPageValue | None
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
        order=tutorial.order if tutorial is not None else LAST,
        steps=[TutorialStepShape.model_validate(step) for step in (tutorial.steps if tutorial is not None else ())],
        teacher=tutorial.teacher if tutorial is not None else None,
        problems=problem_shapes(found.problems),
    )
