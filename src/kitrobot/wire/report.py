"""What the programs of a mission become, on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.wire.mission_delta import SentMissionShape
from kitrobot.wire.problem import ProblemShape


class SpanEntryShape(BaseModel):
    """The stretch of LLL that a vertex became: character offsets, the end exclusive, and the line from 1."""

    vertex: str
    start: int
    end: int
    line: int


class ProgramReportShape(BaseModel):
    """What a program becomes: LLL with the place of each vertex, and how long its three-address code is.

    `known`: the name by which the next edit may send only what it changed in the program; "" when it must send all.
    """

    name: str
    lll: str
    spans: list[SpanEntryShape]
    instructions: int
    known: str


class MovedShape(BaseModel):
    """A stretch [start, end) of places of before, all of them so many characters and lines further on."""

    start: int
    end: int
    characters: int
    lines: int


class ProgramReportChangeShape(BaseModel):
    """As `ProgramReportShape`, told by what is different from the report of the program that was named in the question.

    `of`: that name; `at`, `removed` and `inserted`: so many characters of the text before gave way to others.
    """

    name: str
    of: str
    at: int
    removed: int
    inserted: str
    spans: list[SpanEntryShape | MovedShape]
    instructions: int
    known: str


class ProjectionSpanShape(SpanEntryShape):
    """The same in a projected program; `program` is the team's program in which the vertex stands."""

    program: str


class ProjectionShape(BaseModel):
    """What the program of the whole team is for a kind of robot: LLL that nobody writes."""

    robot: str
    lll: str
    spans: list[ProjectionSpanShape]


class ReportShape(BaseModel):
    """A mission looked through; programs that were named in the question are told by what is different from theirs.

    `projections`: one for each kind of robot that runs the program of the whole team.
    """

    programs: list[ProgramReportShape | ProgramReportChangeShape]
    problems: list[ProblemShape]
    projections: list[ProjectionShape] = []


class CheckShape(BaseModel):
    """A request to look a mission through; `path` is the file it was opened from, "" for a new one."""

    mission: SentMissionShape
    path: str


class FirstTeamShape(CheckShape):
    """A request for a program of the whole team, of that name, for a mission that has none."""

    name: Annotated[str, Field(min_length=1, max_length=1000)]
