"""The parts that a mission brings along, on the wire: what the page holds of them, and the parts themselves again.

They travel as the catalogue's do, with everything that the page draws; back comes only what defines them, and it is
read as carefully as a file.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TypeVar

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import OwnVariable, read_own, write_constructor, write_variable
from kitrobot.primitives.robot import Category, RobotObject
from kitrobot.text.sentences import Sentence
from kitrobot.wire.catalogue import ConstructorShape, RobotObjectShape
from kitrobot.wire.values import View

Own = TypeVar("Own", Constructor, OwnVariable)

KEPT = 256
"""Parts that are remembered, so that each check of a mission does not read them anew."""


class OwnPartError(KitRobotError):
    """A part of a mission's own makes no sense."""


class OwnVariableShape(View):
    """A variable that the mission adds to every robot of a kind."""

    robot: str
    variable: RobotObjectShape


def own_constructor(shape: ConstructorShape) -> Constructor:
    """The constructor that travelled.

    Raises:
        OwnPartError: it makes no sense.
    """
    return _constructor(shape.model_dump_json())


def own_variable(shape: OwnVariableShape) -> OwnVariable:
    """The variable that travelled.

    Raises:
        OwnPartError: it makes no sense.
    """
    return _variable(shape.model_dump_json())


@lru_cache(KEPT)
def _constructor(text: str) -> Constructor:
    wanted = raw_constructor(ConstructorShape.model_validate_json(text))
    return _read(write_constructor(wanted), Constructor, Sentence("the part `{part}`", wanted.name))


def raw_constructor(shape: ConstructorShape) -> Constructor:
    """What a shape says, unread: it may make no sense."""
    return Constructor(
        shape.name,
        "",
        shape.colour,
        shape.slots,
        shape.code,
        None,
        shape.role,
        (shape.adds.constructor, shape.adds.slot) if shape.adds is not None else None,
        shape.icon,
        shape.label,
        shape.help,
        level=shape.level,
        order=shape.order,
        words=shape.words,
    )


@lru_cache(KEPT)
def _variable(text: str) -> OwnVariable:
    shape = OwnVariableShape.model_validate_json(text)
    variable = shape.variable
    wanted = RobotObject(
        variable.name,
        Category.VARIABLE,
        (),
        type=variable.type,
        minimum=variable.min,
        maximum=variable.max,
        initial=variable.initial,
        shared=variable.shared,
        icon=variable.icon,
        label=variable.label,
        help=variable.help,
    )
    return _read(
        write_variable(OwnVariable(shape.robot, wanted)),
        OwnVariable,
        Sentence("the variable `{variable}`", variable.name),
    )


def _read(lines: list[str], kind: type[Own], what: str) -> Own:
    found, problems = read_own(lines, "own.xml")
    if not isinstance(found, kind):
        first = problems[0]
        raise OwnPartError(
            Sentence("{what} makes no sense: {reason}", what, first.message),
            first.help,
            tuple(replace(problem, place=None) for problem in problems),
        )
    return found
