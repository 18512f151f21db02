"""The application: the page, its requests, the run's WebSocket, and the shell around all of them."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import FileResponse, HTMLResponse, JSONResponse, RedirectResponse, Response
from pydantic.json_schema import models_json_schema
from starlette.exceptions import HTTPException

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError
from kitrobot.files.folder import ConflictError, MissionNameError, ReadOnlyError
from kitrobot.files.folder_quota import QuotaError
from kitrobot.live.studio import Studio
from kitrobot.server import fallback_pages
from kitrobot.server.deadlines import DeadlineMiddleware
from kitrobot.server.handshake import Handshake, StrangerError, handshake_routes
from kitrobot.server.language import LanguageMiddleware
from kitrobot.server.page_files import PageFiles
from kitrobot.server.routes.assignments import handed_out_routes
from kitrobot.server.routes.board import board_routes
from kitrobot.server.routes.drawing_check import drawing_check_routes
from kitrobot.server.routes.exercise import exercise_routes
from kitrobot.server.routes.experiment import experiment_routes
from kitrobot.server.routes.firmware import firmware_routes
from kitrobot.server.routes.fragment import routes as fragment_routes
from kitrobot.server.routes.image import image_routes
from kitrobot.server.routes.journal import journal_routes
from kitrobot.server.routes.missions import routes
from kitrobot.server.routes.own_part import own_part_routes
from kitrobot.server.routes.page_port import page_port_routes
from kitrobot.server.routes.parts import parts_routes
from kitrobot.server.routes.run import run_routes
from kitrobot.server.routes.run_stretch import run_stretch_routes
from kitrobot.server.routes.starter import starter_routes
from kitrobot.server.routes.state_walk import state_walk_routes
from kitrobot.server.routes.sweep import sweep_routes
from kitrobot.server.routes.text import text_routes
from kitrobot.server.routes.trace import trace_routes
from kitrobot.server.routes.tutorial import tutorial_routes
from kitrobot.server.routes.verification import verify_routes
from kitrobot.server.security import SecurityMiddleware, refuse
from kitrobot.text.sentences import Sentence, Word
from kitrobot.wire.board import BOARD_MESSAGE_MODELS, BOARD_REQUEST_MODELS
from kitrobot.wire.drawing_check import DRAWING_CHECK_MESSAGE_MODELS, DRAWING_CHECK_REQUEST_MODELS
from kitrobot.wire.experiment import EXPERIMENT_MESSAGE_MODELS, EXPERIMENT_REQUEST_MODELS
from kitrobot.wire.files import ConflictShape
from kitrobot.wire.journal import WATCH_MESSAGE_MODELS
from kitrobot.wire.problem import RequestFailureShape, problem_shapes
from kitrobot.wire.run import RUN_MESSAGE_MODELS
from kitrobot.wire.run_requests import REQUEST_MODELS
from kitrobot.wire.sweep import SWEEP_MESSAGE_MODELS, SWEEP_REQUEST_MODELS
from kitrobot.wire.verification import VERIFY_MESSAGE_MODELS, VERIFY_REQUEST_MODELS

ROUTERS = (
    routes,
    handshake_routes,
    fragment_routes,
    run_routes,
    sweep_routes,
    experiment_routes,
    verify_routes,
    drawing_check_routes,
    run_stretch_routes,
    state_walk_routes,
    board_routes,
    page_port_routes,
    firmware_routes,
    journal_routes,
    text_routes,
    own_part_routes,
    parts_routes,
    image_routes,
    tutorial_routes,
    exercise_routes,
    handed_out_routes,
    starter_routes,
    trace_routes,
)
"""The requests, in the order that they are looked for."""

STATIC = Path(__file__).parent / "static"
"""The built page; git does not keep it."""


def create_app(
    workspace: Path, mission: Path | None, token: str, *, static: Path = STATIC, secret: str = ""
) -> FastAPI:
    """The studio's application.

    Args:
        workspace: the folder whose missions can be opened and saved; nothing outside it can be reached.
        mission: the mission to begin with, in that folder or among the examples; None to let the page choose.
        token: what every request must bring along.
        static: the built page.
        secret: what pages of this folder know its studios by; one of its own when it is empty.
    """
    app = FastAPI(
        title="KitRobot",
        docs_url=None,
        redoc_url=None,
        openapi_url="/api/openapi.json",
        separate_input_output_schemas=False,
    )
    app.state.studio = Studio(workspace, mission)
    app.state.handshake = Handshake(secret or secrets.token_hex(32), token)
    for router in ROUTERS:
        # As they are: included by FastAPI, each route would be built again for every application.
        app.router.routes.extend(router.routes)
    install_failures(app)
    _serve_page(app, static)
    app.openapi = lambda: _openapi(app)  # type: ignore[method-assign]
    app.add_middleware(DeadlineMiddleware, refuse=refuse)
    app.add_middleware(SecurityMiddleware, token=token)
    app.add_middleware(LanguageMiddleware)
    return app


def install_failures(app: FastAPI, status: Callable[[KitRobotError], int | None] | None = None) -> None:
    """Has failures answered with a sentence; `status` knows that of failures of this application, None: as ever."""

    def failed(request: Request, error: Exception) -> Response:
        assert isinstance(error, KitRobotError)
        known = None if status is None else status(error)
        return _failed(request, error) if known is None else _failure(error, known)

    app.add_exception_handler(KitRobotError, failed)
    app.add_exception_handler(OSError, _disk_failed)
    app.add_exception_handler(RequestValidationError, _not_understood)
    app.add_exception_handler(HTTPException, _refused)


def _serve_page(app: FastAPI, static: Path) -> None:
    index = static / "index.html"

    @app.get("/", include_in_schema=False)
    def page(request: Request) -> Response:
        if request.url.hostname == "localhost" and request.url.port == request.scope["server"][1]:
            # A page at the number can know the studio again that it was opened from (handshake); `localhost` may be
            # another server's, at the other kind of address.
            number = request.scope["server"][0]
            return RedirectResponse(str(request.url.replace(hostname=f"[{number}]" if ":" in number else number)))
        if index.is_file():
            return FileResponse(index, media_type="text/html")
        message, help = (
            Sentence("The studio's page has not been built"),
            Sentence("run `python tools/page.py build` and load this page again"),
        )
        return HTMLResponse(fallback_pages.sentence(message, help), status_code=503)

    app.mount("/", PageFiles(static))


def _openapi(app: FastAPI) -> dict[str, Any]:
    """The schema of all requests, with the shapes that travel over the WebSocket, which OpenAPI knows no place for."""
    if app.openapi_schema is None:
        schema = FastAPI.openapi(app)
        of_work = (*SWEEP_REQUEST_MODELS, *VERIFY_REQUEST_MODELS, *DRAWING_CHECK_REQUEST_MODELS)
        of_work += EXPERIMENT_REQUEST_MODELS
        models = [(model, "validation") for model in (*REQUEST_MODELS, *BOARD_REQUEST_MODELS, *of_work)]
        messages = (*RUN_MESSAGE_MODELS, *WATCH_MESSAGE_MODELS, *BOARD_MESSAGE_MODELS)
        messages += (
            *EXPERIMENT_MESSAGE_MODELS,
            *SWEEP_MESSAGE_MODELS,
            *VERIFY_MESSAGE_MODELS,
            *DRAWING_CHECK_MESSAGE_MODELS,
        )
        models += [(model, "serialization") for model in messages]
        _, extra = models_json_schema(models, ref_template="#/components/schemas/{model}")  # type: ignore[arg-type]
        schema["components"]["schemas"] |= extra["$defs"]
        app.openapi_schema = schema
    return app.openapi_schema


def _failed(request: Request, error: Exception) -> Response:
    """An operation failed: which status, and the sentence."""
    assert isinstance(error, KitRobotError)
    message, help = error.message, error.help
    if isinstance(error, ConflictError):
        conflict = ConflictShape(message=message, help=help, revision=error.revision)
        return JSONResponse(conflict.model_dump(), status_code=409)
    status = 422
    if isinstance(error, (MissionNameError, ReadOnlyError, StrangerError)):
        status = 403
    elif isinstance(error, QuotaError):
        status = 413
    elif isinstance(error, FileError) and not error.path.exists():
        status = 404
    return _failure(error, status)


def _failure(error: KitRobotError, status: int) -> Response:
    failure = RequestFailureShape(message=error.message, help=error.help, problems=problem_shapes(error.diagnostics))
    return JSONResponse(failure.model_dump(), status_code=status)


def _disk_failed(request: Request, error: Exception) -> Response:
    assert isinstance(error, OSError)
    failure = RequestFailureShape(
        message=Word(error.strerror) if error.strerror else Sentence("the disk could not be used"), help=""
    )
    return JSONResponse(failure.model_dump(), status_code=422)


def _not_understood(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    first = error.errors()[0]
    where = ".".join(str(part) for part in first["loc"])
    failure = RequestFailureShape(
        message=Sentence("The request was not understood: {reason} ({where}).", first["msg"], where),
        help=Sentence("Load the page again: it may be older than the studio."),
    )
    return JSONResponse(failure.model_dump(), status_code=422)


def _refused(request: Request, error: Exception) -> Response:
    """Nothing is there, or not for that method."""
    assert isinstance(error, HTTPException)
    if request.url.path.startswith("/api/"):
        failure = RequestFailureShape(message=Word(error.detail), help="")
        return JSONResponse(failure.model_dump(), status_code=error.status_code, headers=error.headers)
    page = fallback_pages.sentence(Word(error.detail), Sentence("the studio is at `/`"))
    return HTMLResponse(page, status_code=error.status_code, headers=error.headers)
