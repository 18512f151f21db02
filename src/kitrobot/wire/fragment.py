"""LLL text that becomes a piece of a graph, on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.primitives.own_xml import MOST_OWN
from kitrobot.wire.catalogue import ConstructorShape
from kitrobot.wire.mission import ProgramValue
from kitrobot.wire.own_parts import OwnVariableShape
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.values import View

LONGEST_FRAGMENT = 1_000_000
"""Characters that may be pasted at once; the longest program that fits a robot is far shorter."""


class FragmentRequestShape(BaseModel):
    """A text for a program of that robot; `path` is the mission's file, "" for a new one; the rest is what the
    mission brings along.
    """

    text: Annotated[str, Field(max_length=LONGEST_FRAGMENT)]
    robot: str
    path: str
    constructors: Annotated[list[ConstructorShape], Field(max_length=MOST_OWN)] = []
    variables: Annotated[list[OwnVariableShape], Field(max_length=MOST_OWN)] = []


class FragmentShape(View):
    """What the text became: a chain from Start to Stop, or a condition on its own; None when it is no LLL."""

    program: ProgramValue | None
    problems: list[ProblemShape]
