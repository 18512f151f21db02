"""`WS /api/run`: a run that the page starts, steers and watches.

One run at a time on a socket, in a task of its own; it ends when the socket closes. The task goes round thirty times
a second: so many ticks as the pace asks for, computed in a thread so that nobody waits for them, then what changed:
one binary frame with the poses and one JSON message with the rest. Requests are read meanwhile; they change the pace
or set a flag and wake the task, so they take hold at its next round. A request that is not understood is answered
with a sentence, one that comes too late (a pause after the end) is passed over.
"""

from __future__ import annotations

import asyncio
import itertools
import logging
import os
import time
from collections.abc import Callable
from typing import Any

import orjson
from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from pydantic import BaseModel, ValidationError

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.pacing import SLOWEST, UNPACED, Pace
from kitrobot.server.sentences import spoken
from kitrobot.server.shapes import (
    REQUEST,
    ErrorMessage,
    PauseRequest,
    ProblemsMessage,
    ResumeRequest,
    SpeedRequest,
    StartRequest,
    StateMessage,
    StepRequest,
    StopRequest,
    mission_from_shape,
    problem_shapes,
)
from kitrobot.server.studio import Studio
from kitrobot.server.watching import Watch
from kitrobot.workspace import ProblemsError

LARGEST_MESSAGE_BYTES = 16 * 1024 * 1024
MOST_RUNS = 8
"""Runs that one studio has at a time: a forgotten page must not stop the others."""
FRAME_S = 1 / 30

run_routes = APIRouter()
_log = logging.getLogger("kitrobot.server")
_numbers = itertools.count(1)


@run_routes.websocket("/api/run")
async def run(socket: WebSocket) -> None:
    """Serves one socket until it closes."""
    await socket.accept()
    await Session(socket, socket.app.state.studio).serve()


class Session:
    """One socket and the run on it. `clock` gives seconds and never goes back."""

    def __init__(self, socket: WebSocket, studio: Studio, clock: Callable[[], float] = time.monotonic) -> None:
        self._socket = socket
        self._studio = studio
        self._clock = clock
        self._task: asyncio.Task[None] | None = None
        self._wake = asyncio.Event()
        self._pace: Pace | None = None
        self._watch: Watch | None = None
        self._early: list[PauseRequest | ResumeRequest | StepRequest | SpeedRequest] = []
        """What was asked for while the mission was still being compiled."""
        self._steps = 0
        self._stopping = False
        self._said: tuple[str, int] = ("", -1)

    async def serve(self) -> None:
        """Reads requests until the socket closes, then ends the run."""
        try:
            while True:
                message = await self._socket.receive()
                if message["type"] == "websocket.disconnect":
                    return
                await self._obey(message.get("text") or message.get("bytes") or "")
        finally:
            if self._task is not None:
                self._task.cancel()
                await asyncio.gather(self._task, return_exceptions=True)

    async def _obey(self, text: str | bytes) -> None:
        try:
            request = REQUEST.validate_json(text)
        except ValidationError as error:
            first = error.errors(include_url=False, include_input=False)[0]
            where = ".".join(str(part) for part in first["loc"])
            message = f"the request was not understood: {first['msg']}{f' ({where})' if where else ''}"
            await self._fail(message, "load the page again: it may be older than the studio")
            return
        if isinstance(request, StartRequest):
            await self._start(request)
        elif self._task is not None and not self._task.done():
            self._steer(request)

    async def _start(self, request: StartRequest) -> None:
        if self._task is not None and not self._task.done():
            await self._fail("a run is on already", "stop it first")
            return
        if self._studio.runs >= MOST_RUNS:
            await self._fail(f"this studio has {MOST_RUNS} runs already", "stop one of them, perhaps in another tab")
            return
        self._pace, self._watch, self._early, self._steps = None, None, [], 0
        self._stopping, self._said = False, ("", -1)
        self._wake.clear()
        self._task = asyncio.create_task(self._whole_run(request))

    def _steer(self, request: PauseRequest | ResumeRequest | StepRequest | StopRequest | SpeedRequest) -> None:
        if isinstance(request, StopRequest):
            self._stopping = True
        elif self._pace is None or self._watch is None:
            self._early.append(request)
        else:
            tick = self._watch.tick
            if isinstance(request, PauseRequest | ResumeRequest):
                self._pace.set_paused(isinstance(request, PauseRequest), tick)
            elif isinstance(request, SpeedRequest):
                self._pace.set_speed(_speed(request.value), tick)
            elif self._pace.paused:
                self._steps += 1
        self._wake.set()

    async def _whole_run(self, request: StartRequest) -> None:
        self._studio.runs += 1
        try:
            watch = await asyncio.to_thread(self._prepare, request)
            if isinstance(watch, ProblemsMessage):
                await self._tell(watch)
            elif self._stopping:
                await self._state(watch, "stopped")
            else:
                await self._drive(watch, Pace(watch.tick_s, self._clock, _speed(request.speed)))
        except KitRobotError as error:
            await self._fail(error.message, error.help)
        except (RuntimeError, OSError, WebSocketDisconnect):
            # The page is gone in the middle of a message; `serve` hears of it too.
            _log.debug("the page left during a run", exc_info=True)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a run broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            await self._fail("something went wrong inside KitRobot", "the run has ended; please report it")
        finally:
            self._studio.runs -= 1

    def _prepare(self, request: StartRequest) -> Watch | ProblemsMessage:
        opened = self._studio.open(mission_from_shape(request.mission), request.path)
        try:
            return Watch(opened, opened.simulation(request.seed))
        except ProblemsError as error:
            return ProblemsMessage(problems=problem_shapes(error.diagnostics))

    async def _drive(self, watch: Watch, pace: Pace) -> None:
        self._watch, self._pace = watch, pace
        for request in self._early:
            self._steer(request)
        await self._tell(watch.started(f"run-{next(_numbers)}"))
        await self._news(watch)
        while True:
            began = self._clock()
            self._wake.clear()
            if self._stopping:
                await self._state(watch, "stopped")
                return
            await self._state(watch, "paused" if pace.paused else "running")
            due = pace.due(watch.tick)
            if pace.paused:
                due, self._steps = self._steps, 0
            if due != 0:
                await asyncio.to_thread(watch.advance, due, began + FRAME_S, self._clock)
                await self._news(watch)
                if watch.outcome:
                    await self._state(watch, watch.outcome)
                    return
                if pace.paused:
                    await self._state(watch, "paused")
            await self._rest(pace, watch, began)

    async def _rest(self, pace: Pace, watch: Watch, began: float) -> None:
        """Until the next tick is due, but not before the next frame may be sent; a request ends it at once."""
        until_due = pace.wait_s(watch.tick)
        if self._steps or self._stopping:
            return
        if until_due is None:
            await self._wake.wait()
            return
        pause = max(until_due, began + FRAME_S - self._clock(), 0)
        try:
            await asyncio.wait_for(self._wake.wait(), pause)
        except TimeoutError:
            return

    async def _news(self, watch: Watch) -> None:
        await self._socket.send_bytes(watch.frame())
        await self._socket.send_text(orjson.dumps(watch.news()).decode())

    async def _state(self, watch: Watch, status: Any) -> None:
        """Says what became of the run, when that is new."""
        said = (status, watch.tick if status == "paused" else -1)
        if said == self._said:
            return
        self._said = said
        await self._tell(
            StateMessage(status=status, tick=watch.tick, seconds=watch.seconds, sentence=spoken(watch.sentence))
        )

    async def _tell(self, message: BaseModel) -> None:
        await self._socket.send_text(message.model_dump_json())

    async def _fail(self, message: str, help: str) -> None:
        await self._tell(ErrorMessage(message=spoken(message), help=spoken(help)))


def _speed(wanted: float) -> float:
    return wanted if wanted == UNPACED else max(SLOWEST, wanted)
