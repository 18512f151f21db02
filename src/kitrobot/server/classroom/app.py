"""The application of a class: its requests and sockets, the pages, and the door around all of them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from fastapi import FastAPI
from starlette.types import ASGIApp

from kitrobot.classroom.admission import Admission, AdmissionRefusedError, NameTakenError
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.grading_queue import ClassGrader
from kitrobot.classroom.overview import JoinAddress, Overview
from kitrobot.classroom.pictures import ClassPictures
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.app import STATIC, create_app, install_failures
from kitrobot.server.classroom.gateway import ClassGateway, new_key
from kitrobot.server.classroom.pages import serve_pages
from kitrobot.server.classroom.pupil_routes import class_routes
from kitrobot.server.classroom.sockets import class_socket_routes
from kitrobot.server.classroom.studios import PupilStudios
from kitrobot.server.classroom.teacher_routes import teacher_routes
from kitrobot.server.deadlines import DeadlineMiddleware
from kitrobot.server.language import LanguageMiddleware
from kitrobot.server.security import SecurityMiddleware, refuse

LARGEST_BODY_BYTES: Final = 2 * 1024 * 1024
"""Of what a pupil hands in, as JSON; the file is smaller."""


@dataclass(frozen=True)
class ClassApp:
    """A class that can be served, and what ends it."""

    app: ASGIApp
    grading: ClassGrader
    studio: FastAPI

    def close(self) -> None:
        """Ends what goes on beside the requests."""
        self.grading.end()
        self.studio.state.studio.boards.team.end()


def create_class_app(
    room: ClassRoom, key: str, reach: JoinAddress, static: Path = STATIC, site: Path | None = None
) -> ClassApp:
    """The application of a class.

    Args:
        room: the class.
        key: what the teacher's requests bring along.
        reach: where pupils come in.
        static: the built page.
        site: a static site of the same KitRobot, where pupils' pages have their own Python; None: their studios are in
            this process.
    """
    token = new_key()
    studio = create_app(room.folder, None, key, static=static)
    admission = Admission(room)
    grading = ClassGrader(room, studio.state.studio)
    app = class_api()
    app.state.room = room
    app.state.admission = admission
    app.state.pictures = ClassPictures(room)
    app.state.studio = studio.state.studio
    app.state.grading = grading
    app.state.reach = reach
    app.state.overview = Overview(room, admission, studio.state.studio, grading, reach)
    serve_pages(app, static, site)
    app.add_middleware(DeadlineMiddleware, refuse=refuse)
    app.add_middleware(SecurityMiddleware, token=token, largest_body_bytes=LARGEST_BODY_BYTES)
    app.add_middleware(LanguageMiddleware)
    app.state.studios = PupilStudios(room) if site is None else None
    door = ClassGateway(room, app, token, studio, key, app.state.studios, room.clock)
    return ClassApp(LanguageMiddleware(door), grading, studio)


def class_api() -> FastAPI:
    """The requests of a class, of which the page's types are made."""
    app = FastAPI(
        title="KitRobot class", docs_url=None, redoc_url=None, openapi_url=None, separate_input_output_schemas=False
    )
    for router in (class_routes, teacher_routes, class_socket_routes):
        app.router.routes.extend(router.routes)
    install_failures(app, _status)
    return app


def _status(error: KitRobotError) -> int | None:
    """The status of what can fail in a class."""
    if isinstance(error, AdmissionRefusedError):
        return 403
    if isinstance(error, NameTakenError):
        return 409
    return None
