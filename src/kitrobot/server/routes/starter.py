"""The requests behind a new mission: what it can begin with, how that looks, and the mission itself."""

from __future__ import annotations

from kitrobot.mission.model import Mission
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.missions import Name, mission_file
from kitrobot.wire.files import MissionFileShape
from kitrobot.wire.gallery import run_preview_shape
from kitrobot.wire.starter import BeginningsShape, PreviewShape, beginning_place_shape, robot_set_shape, starter_shape
from kitrobot.workspace.new_mission_choices import PREVIEW_S

starter_routes = api_router()


@starter_routes.get("/beginnings")
def beginnings(studio: ThisStudio) -> BeginningsShape:
    """Kits, places and starters, and which of them fit each other."""
    choices, catalogue = studio.choices, studio.catalogue("")
    return BeginningsShape(
        robot_sets=[robot_set_shape(robot_set, choices, catalogue) for robot_set in choices.robot_sets],
        places=[beginning_place_shape(place) for place in choices.places],
        starters=[starter_shape(starter, choices) for starter in choices.starters],
    )


@starter_routes.get("/beginnings/previews")
def previews(studio: ThisStudio, robot_set: Name, place: Name) -> list[PreviewShape]:
    """What each starter of a set of robots does in a place, in its first seconds."""
    choices = studio.choices
    starters = choices.starters_of(choices.robot_set(robot_set), place)
    return [_preview(studio, starter, choices.begin(robot_set, place, starter)) for starter in starters]


def _preview(studio: ThisStudio, starter: str, mission: Mission) -> PreviewShape:
    opened = studio.open(mission, "")
    return PreviewShape(starter=starter, run=run_preview_shape(opened, studio.previews.of(opened, PREVIEW_S)))


@starter_routes.get("/mission/begin")
def mission_begin(studio: ThisStudio, robot_set: Name, place: Name, starter: Name) -> MissionFileShape:
    """The mission that begins with these; it has no file yet."""
    return mission_file(studio, studio.open(studio.choices.begin(robot_set, place, starter), ""), "", "")
