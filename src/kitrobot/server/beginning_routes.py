"""The requests behind a new mission: what it can begin with, how that looks, and the mission itself."""

from __future__ import annotations

from kitrobot.server.routes import Name, mission_file
from kitrobot.server.routing import ThisStudio, api_router
from kitrobot.server.shapes import MissionFileShape
from kitrobot.server.shapes.beginning import (
    BeginningsShape,
    PreviewShape,
    beginning_place_shape,
    kit_shape,
    preview_shape,
    starter_shape,
)
from kitrobot.workspace import tracks

beginning_routes = api_router()


@beginning_routes.get("/beginnings")
def beginnings(studio: ThisStudio) -> BeginningsShape:
    """Kits, places and starters, and which of them fit each other."""
    choices, catalogue = studio.choices, studio.catalogue("")
    return BeginningsShape(
        kits=[kit_shape(kit, choices, catalogue) for kit in choices.kits],
        places=[beginning_place_shape(place) for place in choices.places],
        starters=[starter_shape(starter, choices) for starter in choices.starters],
    )


@beginning_routes.get("/beginnings/previews")
def previews(studio: ThisStudio, kit: Name, place: Name) -> list[PreviewShape]:
    """What each starter of a kit does in a place, in its first seconds."""
    chosen = studio.choices.kit(kit)
    return [_preview(studio, kit, place, starter) for starter in studio.choices.starters_of(chosen, place)]


def _preview(studio: ThisStudio, kit: str, place: str, starter: str) -> PreviewShape:
    opened = studio.open(studio.choices.begin(kit, place, starter), "")
    return preview_shape(starter, opened.mission, tracks(opened))


@beginning_routes.get("/mission/begin")
def mission_begin(studio: ThisStudio, kit: Name, place: Name, starter: Name) -> MissionFileShape:
    """The mission that begins with these; it has no file yet."""
    return mission_file(studio, studio.open(studio.choices.begin(kit, place, starter), ""), "", "")
