"""The request behind typing: a program's text becomes its graph."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

from fastapi import APIRouter, Depends, Request

from kitrobot.compiler import follow_text
from kitrobot.diagnostics import KitRobotError
from kitrobot.lll import collection_paused
from kitrobot.mission import Mission
from kitrobot.server.shapes import mission_from_shape, mission_shape, problem_shapes
from kitrobot.server.shapes.report import SpanEntryShape, report_shape
from kitrobot.server.shapes.text import FollowedShape, TextEditShape
from kitrobot.server.studio import Studio
from kitrobot.workspace import NoProgramError

LONGEST_TEXT = 1_000_000
MOST_PROBLEMS = 100
"""More do not help; they are told in reading order."""


class TextError(KitRobotError):
    """A text that cannot become a graph, whatever is in it."""


text_routes = APIRouter(prefix="/api")


def _studio(request: Request) -> Studio:
    studio = request.app.state.studio
    assert isinstance(studio, Studio)
    return studio


@text_routes.post("/text")
def text_follow(studio: Annotated[Studio, Depends(_studio)], wanted: TextEditShape) -> FollowedShape:
    """Draws a program anew from its text, so that every instruction that is still there keeps its vertex; and looks
    the mission through with it.
    """
    if len(wanted.text) > LONGEST_TEXT:
        raise TextError(
            f"this text has {len(wanted.text)} characters, and a program has at most {LONGEST_TEXT}",
            "take it apart into programs of several robots",
        )
    mission = mission_from_shape(wanted.mission)
    program = next((one for one in mission.programs if one.name == wanted.program), None)
    if program is None:
        raise NoProgramError(f"the mission holds no program `{wanted.program}`", "load the page again")
    with collection_paused():
        followed = follow_text(program, wanted.text, studio.parts_of(mission, wanted.path))
        shape = report = None
        if followed.program is not None:
            drawn = followed.program
            mission.programs = [drawn if one is program else one for one in mission.programs]
            shape = mission_shape(Mission(programs=[drawn])).programs[0]
            translations = {drawn.name: followed.translation} if followed.translation is not None else {}
            report = report_shape(replace(studio.open(mission, wanted.path), translations=translations).check())
        spans = [SpanEntryShape(vertex=s.vertex, start=s.start, end=s.end, line=s.line) for s in followed.spans]
    problems = problem_shapes(followed.diagnostics[:MOST_PROBLEMS])
    return FollowedShape(program=shape, spans=spans, problems=problems, report=report)
