"""The robot objects of a team's program, which no robot's XML repeats: `Team`, and one for each work.

`Team` is called by projected programs alone; a work is what people write: `Boxes.Take()`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from kitrobot.lll.tree import WorkDeclaration
from kitrobot.primitives.automatic import texts, work_object
from kitrobot.primitives.robot import (
    Board,
    Category,
    Kind,
    Method,
    Parameter,
    Robot,
    RobotObject,
    Texts,
    ValueType,
)

TEAM = "Team"
"""The object by which a program takes part in its team."""

MOST_POINTS = 65536
"""Points of a team's program: a call names one by a number of the language."""


_POINT = Parameter("point", 0, MOST_POINTS - 1, 0)


def _procedure(name: str, help: Texts, *parameters: Parameter) -> Method:
    return Method(name, Kind.PROCEDURE, parameters, completes_later=True, icon="users", help=help)


_PROCEDURES = (
    _procedure(
        "Join",
        texts(
            "Waits until the team wants this robot.",
            "Attend que l'équipe ait besoin de ce robot.",
            "انتظار کرتا ہے کہ ٹیم کو اس روبوٹ کی ضرورت ہو۔",
        ),
    ),
    _procedure(
        "Enter",
        texts(
            "Asks whether this robot is one of those who do what follows.",
            "Demande si ce robot est de ceux qui font la suite.",
            "پوچھتا ہے کہ آگے کا کام کرنے والوں میں یہ روبوٹ ہے یا نہیں۔",
        ),
        _POINT,
    ),
    _procedure(
        "Meet",
        texts(
            "Waits until all who come to this point are there.",
            "Attend que tous ceux qui viennent à ce point soient là.",
            "انتظار کرتا ہے کہ اس مقام پر آنے والے سب پہنچ جائیں۔",
        ),
        _POINT,
    ),
    _procedure(
        "Ask",
        texts(
            "Gives this robot's answer, and waits for the answer of the team.",
            "Donne la réponse de ce robot, et attend celle de l'équipe.",
            "اس روبوٹ کا جواب دیتا ہے اور ٹیم کے جواب کا انتظار کرتا ہے۔",
        ),
        _POINT,
        Parameter("answer", 0, 1, 0, ValueType.BOOLEAN),
    ),
    _procedure(
        "Move",
        texts(
            "Waits until robots have gone over from one group to another.",
            "Attend que des robots soient passés d'un groupe à un autre.",
            "انتظار کرتا ہے کہ روبوٹ ایک گروہ سے دوسرے میں چلے جائیں۔",
        ),
        _POINT,
    ),
)
_ANSWER = Method(
    "Answer",
    Kind.TEST,
    test="equal",
    to=1,
    icon="users",
    help=texts(
        "Was the last answer of the team yes?",
        "La dernière réponse de l'équipe était-elle oui ?",
        "کیا ٹیم کا آخری جواب ہاں تھا؟",
    ),
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
    label = texts("Team", "Équipe", "ٹیم")
    actuator = RobotObject(TEAM, Category.ACTUATOR, _PROCEDURES, device="team", model="team", icon="users", label=label)
    sensor = RobotObject(
        TEAM, Category.SENSOR, (_ANSWER,), device="team", model="team", maximum=1, icon="users", label=label
    )
    parts = [_work_parts(number, work) for number, work in enumerate(works)]
    return replace(
        robot,
        actuators=(*robot.actuators, actuator, *(one for one, _ in parts)),
        sensors=(*robot.sensors, sensor, *(other for _, other in parts)),
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
