"""The requests behind tutorials: which there are, and what of one is done."""

from __future__ import annotations

from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.tutorial import TutorialFitShape, TutorialShape, TutorialWatchShape, tutorial_shape
from kitrobot.workspace.tutorials import watched

tutorial_routes = api_router()


@tutorial_routes.get("/tutorials")
def tutorials(studio: ThisStudio) -> list[TutorialShape]:
    """The tutorials that come with KitRobot, then those of the folder."""
    return [tutorial_shape(found) for found in studio.tutorials.all()]


@tutorial_routes.post("/tutorial/watch")
def tutorial_watch(studio: ThisStudio, wanted: TutorialWatchShape) -> TutorialFitShape:
    """Holds a mission against the steps of a tutorial."""
    tutorial, _ = studio.tutorials.usable(wanted.tutorial)
    mission = mission_from_shape(wanted.mission)
    return TutorialFitShape(fits=watched(tutorial, mission, studio.parts_of(mission, wanted.path)))
