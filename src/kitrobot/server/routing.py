"""What routes of the API have in common: prefix, how bodies are read, how failures look, the studio that is asked."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends
from starlette.requests import HTTPConnection

from kitrobot.server.json_bodies import JsonRoute
from kitrobot.server.shapes import FailureShape
from kitrobot.server.studio import Studio

FAILURES: dict[int | str, dict[str, Any]] = {
    "4XX": {"model": FailureShape, "description": "Why it could not be done, and a way out."}
}


def api_router(prefix: str = "/api", more: dict[int | str, dict[str, Any]] | None = None) -> APIRouter:
    """A router of the API; `more` are answers that its routes have besides FAILURES."""
    return APIRouter(prefix=prefix, route_class=JsonRoute, responses=FAILURES | (more or {}))


def studio_of(connection: HTTPConnection) -> Studio:
    """The studio that a request or a socket came to."""
    studio = connection.app.state.studio
    assert isinstance(studio, Studio)
    return studio


ThisStudio = Annotated[Studio, Depends(studio_of)]
