"""The common part of all API routes: prefix, reading of bodies, the shape of failures, the studio of a request."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends
from starlette.requests import HTTPConnection

from kitrobot.live.background import can_block
from kitrobot.live.robot_registry import AddressError
from kitrobot.live.studio import Studio
from kitrobot.server.hosts import is_loopback
from kitrobot.server.routes.json_bodies import JsonRoute
from kitrobot.text.sentences import Sentence
from kitrobot.wire.problem import RequestFailureShape

FAILURES: dict[int | str, dict[str, Any]] = {
    "4XX": {"model": RequestFailureShape, "description": "Why it could not be done, and a way out."}
}


def api_router(prefix: str = "/api", more: dict[int | str, dict[str, Any]] | None = None) -> APIRouter:
    """A router of the API; `more` are answers that its routes have besides FAILURES."""
    return APIRouter(prefix=prefix, route_class=JsonRoute, responses=FAILURES | (more or {}))


def studio_of(connection: HTTPConnection) -> Studio:
    """The studio that a request or a socket came to."""
    studio = connection.app.state.studio
    assert isinstance(studio, Studio)
    return studio


def refuse_visitors(connection: HTTPConnection) -> None:
    """Ports belong to who sits at this machine, unless the studio was started for others too.

    Raises:
        AddressError: the page is on another machine, or the studio runs in it and cannot wait for a robot there.
    """
    if studio_of(connection).in_page:
        if can_block():
            return
        raise AddressError(
            Sentence("this browser cannot wait for robots while it does other things"),
            Sentence("open this page in a new Chrome, Edge or Firefox, or install KitRobot on this computer"),
        )
    host = connection.client.host if connection.client is not None else ""
    if not (is_loopback(host) or studio_of(connection).boards_for_visitors):
        raise AddressError(Sentence("the robots are plugged into another machine"), Sentence("use them there"))


ThisStudio = Annotated[Studio, Depends(studio_of)]
