"""What the programs of a mission become, on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape
from kitrobot.workspace.program_report import ProjectionReport


class SpanEntryShape(BaseModel):
    """The stretch of LLL that a vertex became: character offsets, the end exclusive, and the line from 1."""

    vertex: str
    start: int
    end: int
    line: int


class ProgramReportShape(BaseModel):
    """What a program becomes: LLL with the place of each vertex, and how long its three-address code is."""

    name: str
    lll: str
    spans: list[SpanEntryShape]
    instructions: int


class ReportShape(BaseModel):
    """A mission looked through.

    `projections`: one for each kind of robot that runs the program of the whole team.
    """

    programs: list[ProgramReportShape]
    problems: list[ProblemShape]
    projections: list[ProjectionReport] = []


class CheckShape(BaseModel):
    """A request to look a mission through; `path` is the file it was opened from, "" for a new one."""

    mission: MissionShape
    path: str


class FirstTeamShape(CheckShape):
    """A request for a program of the whole team, of that name, for a mission that has none."""

    name: Annotated[str, Field(min_length=1, max_length=1000)]
