"""The request behind typing: a program's text becomes its graph."""

from __future__ import annotations

from fastapi import Response

from kitrobot.compiler.text.text_edit import follow_text
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.fast_json import followed_answer
from kitrobot.text.collection import collection_paused
from kitrobot.text.sentences import Sentence
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.text import FollowedShape, TextEditShape
from kitrobot.workspace.mission_loader import NoProgramError

LONGEST_TEXT = 1_000_000
MOST_PROBLEMS = 100
"""More do not help; they are sent in reading order."""


class TextError(KitRobotError):
    """A text that cannot become a graph, whatever is in it."""


text_routes = api_router()


@text_routes.post("/text", response_model=FollowedShape)
def text_follow(studio: ThisStudio, wanted: TextEditShape) -> Response:
    """Draws a program anew from its text, so that every instruction that is still there keeps its vertex; and looks
    the mission through with it.
    """
    if len(wanted.text) > LONGEST_TEXT:
        raise TextError(
            Sentence(
                "this text has {count} characters, and a program has at most {longest}", len(wanted.text), LONGEST_TEXT
            ),
            Sentence("take it apart into programs of several robots"),
        )
    mission = mission_from_shape(wanted.mission)
    program = next((one for one in mission.programs if one.name == wanted.program), None)
    if program is None:
        raise NoProgramError(
            Sentence("the mission holds no program `{program}`", wanted.program), Sentence("load the page again")
        )
    with collection_paused():
        parts = studio.parts_of(mission, wanted.path)
        followed = follow_text(studio.programs.of(program, parts).translation, wanted.text, parts)
        report = None
        if followed.program is not None:
            drawn = followed.program
            mission.programs = [drawn if one is program else one for one in mission.programs]
            if followed.team is not None:
                team = followed.team
                mission.team.roles, mission.team.groups, mission.team.works = team.roles, team.groups, team.works
                parts = studio.parts_of(mission, wanted.path)
            studio.programs.of(drawn, parts, followed.translation, followed.checked)
            report = studio.open(mission, wanted.path).check()
        return followed_answer(followed, report, MOST_PROBLEMS)
