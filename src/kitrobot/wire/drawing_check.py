"""A check of a mission that is being drawn, on the wire: what the page asks over its WebSocket, and what it is told."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import BaseModel, Field, TypeAdapter

from kitrobot.checking.drawing_check import DrawingFinding
from kitrobot.wire.job import WorkMessage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape, problem_shapes
from kitrobot.wire.verification import ConfirmingRunShape, confirming_run_shape


class DrawingCheckStartRequest(BaseModel):
    """Look through this mission; it takes some seconds at most."""

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]


class DrawingCheckStopRequest(BaseModel):
    """Break it off; nothing is told then."""

    type: Literal["stop"]


class DrawingFindingShape(BaseModel):
    """A problem, and the run of the simulator that shows it, if one does."""

    problem: ProblemShape
    shown: ConfirmingRunShape | None


class DrawingCheckMessage(WorkMessage):
    """What was found: all there is to tell."""

    type: Literal["found"] = "found"
    findings: list[DrawingFindingShape]


DRAWING_CHECK_REQUEST_MODELS: tuple[type[BaseModel], ...] = (DrawingCheckStartRequest, DrawingCheckStopRequest)
DRAWING_CHECK_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (DrawingCheckMessage,)
DRAWING_CHECK_REQUEST: TypeAdapter[DrawingCheckStartRequest | DrawingCheckStopRequest] = TypeAdapter(
    Annotated[DrawingCheckStartRequest | DrawingCheckStopRequest, Field(discriminator="type")]
)


def drawing_check_message(findings: Iterable[DrawingFinding], tick_ms: int) -> DrawingCheckMessage:
    """What was found, as the page gets it."""
    found = list(findings)
    problems = problem_shapes(one.problem for one in found)
    return DrawingCheckMessage(
        findings=[
            DrawingFindingShape(
                problem=problem, shown=None if one.shown is None else confirming_run_shape(one.shown, tick_ms)
            )
            for problem, one in zip(problems, found, strict=True)
        ]
    )
