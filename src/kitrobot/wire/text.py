"""An edited text, on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.wire.mission import DeclaredShape, MissionShape, ProgramValue
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.report import ReportShape, SpanEntryShape
from kitrobot.wire.values import View


class TextEditShape(BaseModel):
    """The LLL of one program as a person has typed it; `mission` holds the program that it was before."""

    mission: MissionShape
    path: str
    program: str
    text: str


class FollowedShape(View):
    """The program of a text, with the place of each vertex in it; None, and no places, while it has mistakes.

    `spans` and `problems` are None where they are those of the report: the text is the one that the graph prints.
    `problems` have their places in the text that was sent. `report` is the mission looked through with that program,
    and with what the text of a team's program declares: `declared`.
    """

    program: ProgramValue | None
    spans: list[SpanEntryShape] | None
    problems: list[ProblemShape] | None
    report: ReportShape | None
    declared: DeclaredShape | None = None
