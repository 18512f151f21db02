"""The robot objects of a team's program, which no robot's XML repeats: `Team`, and one for each work.

`Team` is called by projected programs alone; a work is what people write: `Boxes.Take()`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from kitrobot.lll.tree import WorkDeclaration
from kitrobot.primitives.automatic import work_object
from kitrobot.primitives.automatic_xml import worded
from kitrobot.primitives.robot import (
    Board,
    Category,
    Kind,
    Method,
    Parameter,
    Robot,
    RobotObject,
    ValueType,
)

TEAM = "Team"
"""The object by which a program takes part in its team."""

MOST_POINTS = 65536
"""Points of a team's program: a call names one by a number of the language."""


_POINT = Parameter("point", 0, MOST_POINTS - 1, 0)


@cache
def _procedures() -> tuple[Method, ...]:
    answer = Parameter("answer", 0, 1, 0, ValueType.BOOLEAN)
    parameters = {"Join": (), "Enter": (_POINT,), "Meet": (_POINT,), "Ask": (_POINT, answer), "Move": (_POINT,)}
    return tuple(
        worded(TEAM, Method(name, Kind.PROCEDURE, needed, completes_later=True, icon="users"))
        for name, needed in parameters.items()
    )


def has_team(robot: Robot, works: Sequence[WorkDeclaration] = ()) -> bool:
    """Whether a robot has a part of its own that is called `Team` or as a work, so that it cannot be in the team."""
    names = {TEAM, *(work.name for work in works)}
    return any(part.name in names for part in robot.objects)


def with_team(robot: Robot, works: Sequence[WorkDeclaration] = ()) -> Robot:
    """The robot as a member of a team: behind the parts of its own it has `Team`, and each work of the team.

    Raises ValueError when it has a part of such a name.
    """
    if has_team(robot, works):
        raise ValueError(f"{robot.name} has a part of the name {TEAM}, or of a work")
    answer = worded(TEAM, Method("Answer", Kind.TEST, test="equal", to=1, icon="users"))
    actuator = RobotObject(TEAM, Category.ACTUATOR, _procedures(), device="team", model="team", icon="users")
    sensor = RobotObject(TEAM, Category.SENSOR, (answer,), device="team", model="team", maximum=1, icon="users")
    parts = [_work_parts(number, work) for number, work in enumerate(works)]
    return replace(
        robot,
        actuators=(*robot.actuators, worded(TEAM, actuator), *(one for one, _ in parts)),
        sensors=(*robot.sensors, worded(TEAM, sensor), *(other for _, other in parts)),
    )


def _work_parts(number: int, work: WorkDeclaration) -> tuple[RobotObject, RobotObject]:
    """What a robot does about a work, and what it knows of it."""
    whole = work_object(work.name, work.units)
    does = tuple(method for method in whole.methods if method.kind is Kind.PROCEDURE)
    knows = tuple(method for method in whole.methods if method.kind is not Kind.PROCEDURE)
    common = replace(
        whole, device="work", model="work", board=Board("team"), settings={"number": str(number)}, shared=False
    )
    actuator = replace(common, category=Category.ACTUATOR, methods=does, maximum=0, initial=0)
    return actuator, replace(common, category=Category.SENSOR, methods=knows)
