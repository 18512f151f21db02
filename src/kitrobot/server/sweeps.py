"""`WS /api/sweep`: the fail sweep of a mission that the page has open.

One sweep on a socket, and one at a time in a studio, over processes of their own with one core left to the rest. The
page is told how far it is and gets the map at its end, or what was found until it broke it off. When the socket closes
the sweep ends. Left to others: what a field is (`workspace.sweep`); playing one, which is an ordinary run.
"""

from __future__ import annotations

import asyncio
import logging
import os
import threading
from contextlib import suppress

from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from pydantic import BaseModel, ValidationError

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.routing import studio_of
from kitrobot.server.sentences import not_understood
from kitrobot.server.shapes import mission_from_shape, problem_shapes
from kitrobot.server.shapes.sweep import (
    SWEEP_REQUEST,
    SweepMapMessage,
    SweepProgressMessage,
    SweepRefusedMessage,
    SweepStartRequest,
    sweep_map,
)
from kitrobot.server.studio import Studio
from kitrobot.text import Sentence
from kitrobot.workspace import RunOptions
from kitrobot.workspace.child_processes import cores
from kitrobot.workspace.sweep import SweepError, SweepOptions, run_sweep

MOST_FIELDS = 5000
"""Fields of a sweep in a page, which draws each of them."""

sweep_routes = APIRouter()
_log = logging.getLogger("kitrobot.server")


@sweep_routes.websocket("/api/sweep")
async def sweep(socket: WebSocket) -> None:
    """Serves one socket until it closes."""
    await socket.accept()
    with suppress(WebSocketDisconnect, RuntimeError, OSError):
        await _Session(socket, studio_of(socket)).serve()


class _Session:
    """One socket and its sweep."""

    def __init__(self, socket: WebSocket, studio: Studio) -> None:
        self._socket = socket
        self._studio = studio
        self._loop = asyncio.get_running_loop()
        self._stop = threading.Event()
        self._task: asyncio.Task[None] | None = None
        self._done: SweepProgressMessage | None = None
        self._news = asyncio.Event()

    async def serve(self) -> None:
        try:
            while True:
                message = await self._socket.receive()
                if message["type"] == "websocket.disconnect":
                    return
                await self._obey(message.get("text") or message.get("bytes") or "")
        finally:
            self._stop.set()
            if self._task is not None:
                # Not called off: its thread goes on until it looks at `stop`, and keeps the studio's place.
                await asyncio.shield(self._task)

    async def _obey(self, text: str | bytes) -> None:
        try:
            request = SWEEP_REQUEST.validate_json(text)
        except ValidationError as error:
            await self._refuse(not_understood(error))
            return
        if not isinstance(request, SweepStartRequest):
            self._stop.set()
        elif self._studio.sweeping:
            help = Sentence("wait for it, or break it off where it was begun")
            await self._refuse(SweepError(Sentence("this studio is at a sweep already"), help))
        else:
            self._studio.sweeping = True
            self._stop.clear()
            self._task = asyncio.create_task(self._whole(request))

    async def _whole(self, request: SweepStartRequest) -> None:
        telling = asyncio.create_task(self._tell_progress())
        try:
            answer: BaseModel = await asyncio.to_thread(self._swept, request)
        except KitRobotError as error:
            answer = self._refusal(error)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a sweep broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            help = Sentence("the sweep has ended; please report it")
            answer = self._refusal(KitRobotError(Sentence("something went wrong inside KitRobot"), help))
        finally:
            self._studio.sweeping = False
            telling.cancel()
            await asyncio.gather(telling, return_exceptions=True)
        await self._tell(answer)

    def _swept(self, request: SweepStartRequest) -> SweepMapMessage:
        """In a thread."""
        opened = self._studio.open(mission_from_shape(request.mission), request.path)
        fields = len(opened.mission.team.agents) * request.moments
        if fields > MOST_FIELDS:
            message = Sentence("this sweep has {total} fields; the studio shows at most {most}", fields, MOST_FIELDS)
            raise SweepError(message, Sentence("choose fewer moments, or use `kitrobot run --fail-sweep`"))
        prepared = opened.prepare(RunOptions(request.seed, request.seconds, request.fail_rate))
        options = SweepOptions(request.moments, jobs=max(2, cores() - 1))
        return sweep_map(run_sweep(prepared, options, self._progress, self._stop.is_set))

    def _progress(self, done: int, total: int) -> None:
        """In the sweep's thread: each hundredth is told."""
        if done * 100 // total != (done - 1) * 100 // total:
            with suppress(RuntimeError):  # the studio has ended meanwhile
                self._loop.call_soon_threadsafe(self._came_to, SweepProgressMessage(done=done, total=total))

    def _came_to(self, message: SweepProgressMessage) -> None:
        self._done = message
        self._news.set()

    async def _tell_progress(self) -> None:
        while True:
            await self._news.wait()
            self._news.clear()
            if self._done is not None:
                await self._tell(self._done)

    def _refusal(self, error: KitRobotError) -> SweepRefusedMessage:
        return SweepRefusedMessage(message=error.message, help=error.help, problems=problem_shapes(error.diagnostics))

    async def _refuse(self, error: KitRobotError) -> None:
        await self._tell(self._refusal(error))

    async def _tell(self, message: BaseModel) -> None:
        await self._socket.send_text(message.model_dump_json())
