"""The requests behind tutorials: which there are, and what of one is done."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Request

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.json_bodies import JsonRoute
from kitrobot.server.shapes import mission_from_shape
from kitrobot.server.shapes.tutorial import TutorialFitShape, TutorialShape, TutorialWatchShape, tutorial_shape
from kitrobot.server.studio import Studio
from kitrobot.workspace import watched

tutorial_routes = APIRouter(prefix="/api", route_class=JsonRoute)


class NoTutorialError(KitRobotError):
    """A tutorial that was there is there no more, or has a mistake now."""


def _studio(request: Request) -> Studio:
    studio = request.app.state.studio
    assert isinstance(studio, Studio)
    return studio


@tutorial_routes.get("/tutorials")
def tutorials(studio: Annotated[Studio, Depends(_studio)]) -> list[TutorialShape]:
    """The tutorials that come with KitRobot, then those of the folder."""
    return [tutorial_shape(found) for found in studio.tutorials.all()]


@tutorial_routes.post("/tutorial/watch")
def tutorial_watch(studio: Annotated[Studio, Depends(_studio)], wanted: TutorialWatchShape) -> TutorialFitShape:
    """Holds a mission against the steps of a tutorial."""
    found = studio.tutorials.found(wanted.tutorial)
    if found.tutorial is None:
        raise NoTutorialError(
            "this tutorial cannot be used any more", "look at its file, or leave it", tuple(found.problems)
        )
    mission = mission_from_shape(wanted.mission)
    return TutorialFitShape(fits=watched(found.tutorial, mission, studio.parts_of(mission, wanted.path)))
