"""What the programs of a mission become, on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.server.shapes.problem import ProblemShape
from kitrobot.server.shapes.sent import SentMissionShape


class SpanEntryShape(BaseModel):
    """The stretch of LLL that a vertex became: character offsets, the end exclusive, and the line from 1."""

    vertex: str
    start: int
    end: int
    line: int


class ProgramReportShape(BaseModel):
    """What a program becomes: LLL with the place of each vertex, and three-address code.

    `known`: the name by which the next edit may send only what it changed in the program; "" when it must send all.
    """

    name: str
    lll: str
    spans: list[SpanEntryShape]
    listing: str
    instructions: int
    known: str


class ReportShape(BaseModel):
    """A mission looked through."""

    programs: list[ProgramReportShape]
    problems: list[ProblemShape]


class CheckShape(BaseModel):
    """A request to look a mission through; `path` is the file it was opened from, "" for a new one."""

    mission: SentMissionShape
    path: str
