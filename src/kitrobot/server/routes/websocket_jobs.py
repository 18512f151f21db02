"""Long jobs requested over a WebSocket: one at a time on a socket, and one of each kind in a studio.

The page is sent the job's progress, as fast as it reads, and its result. It can cancel the job; when the socket closes,
the job ends too. Not here: the jobs (`sweep_socket`, `verification_socket`), which run in a thread and check `stop` now
and then.
"""

from __future__ import annotations

import asyncio
import logging
import os
from abc import ABC, abstractmethod
from contextlib import suppress
from typing import Any, ClassVar

from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from pydantic import BaseModel, TypeAdapter, ValidationError

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import StopSignal, run_in_background
from kitrobot.live.studio import Studio
from kitrobot.server.routes.api_router import studio_of
from kitrobot.text.sentences import Sentence
from kitrobot.wire.job import WorkRefusedMessage
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.problem import problem_shapes
from kitrobot.wire.sentences import not_understood
from kitrobot.workspace.mission_loader import OpenMission

_log = logging.getLogger("kitrobot.server")


class WebSocketJob(ABC):
    """One socket and its job.

    Attributes:
        kind: the kind of job, for the log; a studio runs one of each.
        request: parses the page's requests.
        start: the requests that start it; any other cancels it.
        progress: the message of which only the newest is worth sending.
        busy: the refusal while this studio has such a job already.
    """

    kind: ClassVar[str]
    request: ClassVar[TypeAdapter[Any]]
    start: ClassVar[type[BaseModel] | tuple[type[BaseModel], ...]]
    progress: ClassVar[type[BaseModel]]
    busy: ClassVar[Sentence]

    def __init__(self, socket: WebSocket, studio: Studio) -> None:
        self._socket = socket
        self.studio = studio
        self.stop = StopSignal()
        self._loop = asyncio.get_running_loop()
        self._task: asyncio.Task[None] | None = None
        self._waiting: list[BaseModel] = []
        self._news = asyncio.Event()
        self._over = False

    @abstractmethod
    def work(self, request: Any) -> BaseModel:
        """Does the work, in a thread, until it is over or `stop` is set; its last message.

        Raises:
            KitRobotError: it cannot be done.
        """

    def open(self, request: Any) -> OpenMission:
        """The mission of a request that brings one."""
        return self.studio.open(mission_from_shape(request.mission), request.path)

    def send_progress(self, message: BaseModel) -> None:
        """Sends the page progress; called in the thread of the job."""
        with suppress(RuntimeError):  # the studio has ended meanwhile
            self._loop.call_soon_threadsafe(self._queue_message, message)

    @classmethod
    def routes_at(cls, path: str) -> APIRouter:
        """The routes of a WebSocket on which this job is requested."""
        routes = APIRouter()
        routes.add_api_websocket_route(path, cls.serve)
        return routes

    @classmethod
    async def serve(cls, socket: WebSocket) -> None:
        """Serves one socket until it closes."""
        await socket.accept()
        with suppress(WebSocketDisconnect, RuntimeError, OSError):
            await cls(socket, studio_of(socket))._serve()

    async def _serve(self) -> None:
        try:
            while True:
                message = await self._socket.receive()
                if message["type"] == "websocket.disconnect":
                    return
                await self._handle_message(message.get("text") or message.get("bytes") or "")
        finally:
            self.stop.set()
            if self._task is not None:
                # Not called off: its thread goes on until it looks at `stop`, and keeps the studio's place.
                await asyncio.shield(self._task)

    async def _handle_message(self, text: str | bytes) -> None:
        try:
            request = self.request.validate_json(text)
        except ValidationError as error:
            await self._send(_refusal(not_understood(error)))
            return
        if not isinstance(request, self.start):
            self.stop.set()
        elif self.kind in self.studio.at_work:
            help = Sentence("wait for it, or break it off where it was begun")
            await self._send(_refusal(KitRobotError(self.busy, help)))
        else:
            self.studio.at_work.add(self.kind)
            self.stop.clear()
            self._task = asyncio.create_task(self._run_job(request))

    async def _run_job(self, request: BaseModel) -> None:
        self._over = False
        sender = asyncio.create_task(self._send_queued())
        try:
            answer: BaseModel = await run_in_background(self.work, request)
        except KitRobotError as error:
            answer = _refusal(error)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a %s broke: %s: %s", self.kind, type(error).__name__, error, exc_info=debugging)
            help = Sentence("it has ended; please report it")
            answer = _refusal(KitRobotError(Sentence("something went wrong inside KitRobot"), help))
        finally:
            self.studio.at_work.discard(self.kind)
            self._over = True
            self._news.set()
        self._queue_message(answer)
        with suppress(WebSocketDisconnect, RuntimeError, OSError):
            await sender

    def _queue_message(self, message: BaseModel) -> None:
        if self._waiting and isinstance(message, self.progress) and isinstance(self._waiting[-1], self.progress):
            self._waiting.pop()
        self._waiting.append(message)
        self._news.set()

    async def _send_queued(self) -> None:
        """Sends what is queued until the job is over, and its answer."""
        while self._waiting or not self._over:
            await self._news.wait()
            self._news.clear()
            while self._waiting:
                await self._send(self._waiting.pop(0))

    async def _send(self, message: BaseModel) -> None:
        await self._socket.send_text(message.model_dump_json())


def _refusal(error: KitRobotError) -> WorkRefusedMessage:
    return WorkRefusedMessage(message=error.message, help=error.help, problems=problem_shapes(error.diagnostics))
