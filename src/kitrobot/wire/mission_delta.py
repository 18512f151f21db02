"""A mission as an edit sends it: of a program that the studio knows already, only what changed.

An answer names each program (`ProgramReportShape.known`); the page names the one that it starts from, and says vertices
and arcs as rows of its lists (`server.stretches`). A studio that does not know the name any more (it was started anew,
or much else was edited since) refuses with status 410, and the page sends the whole.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import is_
from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import Program
from kitrobot.mission.model import Mission
from kitrobot.primitives.levels import Level
from kitrobot.text.sentences import Sentence
from kitrobot.wire.catalogue import LevelName
from kitrobot.wire.list_delta import apply_delta
from kitrobot.wire.mission import MOST_PROGRAMS, MOST_VERTICES, MissionShape, mission_from_shape
from kitrobot.wire.values import ArcValue, VertexValue
from kitrobot.workspace.program_report import ProgramReport

Place = Annotated[int, Field(ge=0)]
VertexRow = Annotated[VertexValue | tuple[Place, Place], Field(union_mode="left_to_right")]
ArcRow = Annotated[ArcValue | tuple[Place, Place], Field(union_mode="left_to_right")]


class ForgottenError(KitRobotError):
    """A program is named that is not known (any more)."""


class SentProgramShape(BaseModel):
    """A program as what became of the one that the studio knows as `of`; "" for one that is sent whole."""

    name: str
    robot: str
    level: LevelName = "agent"
    of: str = ""
    vertices: Annotated[list[VertexRow], Field(max_length=MOST_VERTICES)]
    arcs: Annotated[list[ArcRow], Field(max_length=2 * MOST_VERTICES)]


class SentMissionShape(MissionShape):
    """A mission, of whose programs only what changed is sent."""

    programs: Annotated[list[SentProgramShape], Field(max_length=MOST_PROGRAMS)]  # type: ignore[assignment]


class DrawnProgramShape(BaseModel):
    """What became of the program of a text: rows of the lists of the program that was sent with it."""

    vertices: list[VertexRow]
    arcs: list[ArcRow]


def mission_from_delta(shape: SentMissionShape, known: Callable[[str], Program | None]) -> Mission:
    """The mission that travelled; `known` finds a program by the name that an answer gave it.

    A program in which nothing changed is the very object that is known, and an edited one shares vertices with it: so
    nothing in them may be changed.

    Raises:
        ForgottenError: a program is not known.
        StretchError: a stretch is not in the program that it is taken from.
        OwnPartError: as `mission_from_shape`.
    """
    return mission_from_shape(shape, [_program(one, known) for one in shape.programs])


def reports_from_delta(
    shape: SentMissionShape, known: Callable[[str], ProgramReport | None]
) -> dict[str, ProgramReport]:
    """By the names of programs, the reports of those that were named so, as far as they are `known`."""
    found = {one.name: known(one.of) for one in shape.programs if one.of}
    return {name: report for name, report in found.items() if report is not None}


def _program(shape: SentProgramShape, known: Callable[[str], Program | None]) -> Program:
    level = Level(shape.level)
    before = Program(shape.name, shape.robot, level=level)
    if shape.of:
        found = known(shape.of)
        if found is None:
            raise ForgottenError(
                Sentence("the studio does not know the program `{program}` as it was before", shape.name),
                Sentence("load the page again"),
            )
        before = found
    vertices = apply_delta(shape.vertices, before.vertices, MOST_VERTICES)
    arcs = apply_delta(shape.arcs, before.arcs, 2 * MOST_VERTICES)
    same = (before.name, before.target, before.level) == (shape.name, shape.robot, level)
    if same and _are_identical(vertices, before.vertices) and _are_identical(arcs, before.arcs):
        return before
    return Program(shape.name, shape.robot, vertices, arcs, level)


def _are_identical(found: Sequence[object], before: Sequence[object]) -> bool:
    return len(found) == len(before) and all(map(is_, found, before))
