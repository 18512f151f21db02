"""The requests behind tutorials: which there are, and what of one is done."""

from __future__ import annotations

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.routing import ThisStudio, api_router
from kitrobot.server.shapes import mission_from_shape
from kitrobot.server.shapes.tutorial import TutorialFitShape, TutorialShape, TutorialWatchShape, tutorial_shape
from kitrobot.text import Sentence
from kitrobot.workspace import watched

tutorial_routes = api_router()


class NoTutorialError(KitRobotError):
    """A tutorial that was there is there no more, or has a mistake now."""


@tutorial_routes.get("/tutorials")
def tutorials(studio: ThisStudio) -> list[TutorialShape]:
    """The tutorials that come with KitRobot, then those of the folder."""
    return [tutorial_shape(found) for found in studio.tutorials.all()]


@tutorial_routes.post("/tutorial/watch")
def tutorial_watch(studio: ThisStudio, wanted: TutorialWatchShape) -> TutorialFitShape:
    """Holds a mission against the steps of a tutorial."""
    found = studio.tutorials.found(wanted.tutorial)
    if found.lesson is None:
        raise NoTutorialError(
            Sentence("this tutorial cannot be used any more"),
            Sentence("look at its file, or leave it"),
            tuple(found.problems),
        )
    mission = mission_from_shape(wanted.mission)
    return TutorialFitShape(fits=watched(found.lesson, mission, studio.parts_of(mission, wanted.path)))
