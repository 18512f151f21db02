"""`WS /api/run`: a run that the page starts, steers and watches.

One run at a time on a socket, in a task of its own; it ends when the socket closes. The task goes round thirty times
a second: so many ticks as the pace asks for, computed in a thread so that nobody waits for them, then what changed:
one binary frame with the poses and one JSON message with the rest. Requests are read meanwhile; they change the pace
or set a flag and wake the task, so they take hold at its next round. A request that is not understood is answered
with a sentence, one that comes too late (a pause after the end) is passed over.
Real robots and teams of processes go on at their own pace: only what is shown is paused.
Other pages may watch a run (broadcast). A socket steers a run of its own or watches another's: who watches steers
nothing, not even STOP, and when the page that steers is gone its run ends for all of them.
"""

from __future__ import annotations

import asyncio
import itertools
import logging
import os
import time
from collections.abc import Callable

from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from pydantic import ValidationError

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.beside_loop import beside_loop
from kitrobot.server.broadcast import MOST_WATCHERS, Broadcast, Subscriber
from kitrobot.server.realtime_clock import Pace, speed_of
from kitrobot.server.routing import studio_of
from kitrobot.server.run_sources import come_with, run_of
from kitrobot.server.run_telling import RunTelling
from kitrobot.server.sentences import not_understood
from kitrobot.server.shapes import (
    REQUEST,
    Beginning,
    LookRequest,
    PauseRequest,
    ProblemsMessage,
    ReplayRequest,
    ResumeRequest,
    SpeedRequest,
    Steering,
    StepRequest,
    StopRequest,
    WatchRequest,
    mission_from_shape,
)
from kitrobot.server.steering import Job, do_until, goes_back, in_one_piece, job_of
from kitrobot.server.studio import Studio
from kitrobot.server.watched_run import WatchedRun
from kitrobot.text import Sentence

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
    await Session(socket, studio_of(socket)).serve()


class Session:
    """One socket and the run on it. `clock` gives seconds and never goes back."""

    def __init__(self, socket: WebSocket, studio: Studio, clock: Callable[[], float] = time.monotonic) -> None:
        self._socket = socket
        self._telling = RunTelling(socket)
        self._studio = studio
        self._clock = clock
        self._task: asyncio.Task[None] | None = None
        self._wake = asyncio.Event()
        self._pace: Pace | None = None
        self._watch: WatchedRun | None = None
        self._name = ""
        self._subscriber: Subscriber | None = None
        """The place from which this socket watches another's run."""
        self._looks: tuple[str, ...] = ()
        self._early: list[Steering] = []
        """What was asked for while the mission was still being compiled."""
        self._steps = 0
        self._jobs: list[Job] = []
        """What is to be done to the run between two rounds, in a thread."""
        self._breaking_off = False
        """Whether the job that is on is to leave off."""
        self._stopping = False
        self._counts = False
        """Whether it is one of the studio's runs; one that stands at its end is not."""

    async def serve(self) -> None:
        """Reads requests until the socket closes, then ends the run."""
        try:
            while True:
                message = await self._socket.receive()
                if message["type"] == "websocket.disconnect":
                    return
                await self._obey(message.get("text") or message.get("bytes") or "")
        finally:
            # Others are told before anything is waited for: whoever calls this off ends the waiting too.
            self._let_go()
            try:
                if self._task is not None:
                    self._task.cancel()
                    await asyncio.gather(self._task, return_exceptions=True)
            finally:
                self._close_watch()
                await self._stand_up()

    def _let_go(self) -> None:
        """The run of this socket is looked at no more, and cannot be saved any more."""
        self._studio.watches.pop(self._name, None)
        self._studio.broadcasts.pop(self._name, None)
        message = Sentence("the page that steered this run is gone, and the run with it")
        self._telling.end_for_others(message, Sentence("start one of your own"))

    def _close_watch(self) -> None:
        if self._watch is not None:
            self._watch.close()

    async def _obey(self, text: str | bytes) -> None:
        try:
            request = REQUEST.validate_json(text)
        except ValidationError as error:
            wrong = not_understood(error)
            await self._telling.fail(wrong.message, wrong.help)
            return
        if isinstance(request, Beginning):
            await self._start(request)
        elif isinstance(request, WatchRequest):
            await self._sit_down(request)
        elif self._subscriber is not None:
            if isinstance(request, LookRequest):
                self._subscriber.look(request.agents)
            else:
                help = Sentence("to steer one, start a run of your own")
                await self._telling.fail(Sentence("the page that started this run steers it"), help)
        elif self._task is not None and not self._task.done():
            self._steer(request)

    async def _start(self, request: Beginning) -> None:
        if self._task is not None and not self._task.done():
            if self._counts:
                await self._telling.fail(Sentence("a run is on already"), Sentence("stop it first"))
                return
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
        # Looked for and taken in one breath: nobody comes between.
        if not self._take_place():
            await self._no_place()
            return
        try:
            self._let_go()
            self._close_watch()
            await self._stand_up()
        except BaseException:
            self._count(False)
            raise
        self._pace, self._watch, self._early, self._steps, self._jobs = None, None, come_with(request), 0, []
        self._stopping, self._looks = False, ()
        self._telling.begin_anew()
        self._wake.clear()
        self._task = asyncio.create_task(self._whole_run(request))
        self._task.add_done_callback(self._give_back)

    async def _sit_down(self, request: WatchRequest) -> None:
        if self._task is not None and not self._task.done():
            await self._telling.fail(Sentence("a run is on already"), Sentence("stop it first"))
            return
        await self._stand_up()
        try:
            mission = await beside_loop(mission_from_shape, request.mission)
        except KitRobotError as error:
            await self._telling.fail(error.message, error.help, ended=True)
            return
        broadcast = self._studio.broadcasts.get(request.run)
        if broadcast is None or not broadcast.on:
            await self._telling.fail(Sentence("this run is over"), Sentence("start one of your own"), ended=True)
        elif len(broadcast) >= MOST_WATCHERS:
            message = Sentence("{most} pages watch this run already", MOST_WATCHERS)
            await self._telling.fail(message, Sentence("try again later"), ended=True)
        else:
            self._subscriber = Subscriber(broadcast, self._socket, another=not broadcast.is_of(mission))

    async def _stand_up(self) -> None:
        """This socket watches nothing any more."""
        subscriber, self._subscriber = self._subscriber, None
        if subscriber is not None:
            await subscriber.leave()

    def _steer(self, request: Steering) -> None:
        if isinstance(request, StopRequest):
            # Nobody waits any more for what was asked for before; what real robots do, they are told next.
            self._jobs, self._breaking_off = [], True
        if isinstance(request, StopRequest) and not (self._watch is not None and self._watch.real):
            self._stopping = True
        elif self._pace is None or self._watch is None:
            self._early.append(request)
        else:
            self._bid(request, self._watch, self._pace)
        self._wake.set()

    def _bid(self, request: Steering, watch: WatchedRun, pace: Pace) -> None:
        if isinstance(request, PauseRequest | ResumeRequest):
            pace.set_paused(isinstance(request, PauseRequest), watch.tick)
        elif isinstance(request, SpeedRequest):
            pace.set_speed(speed_of(request.value), watch.tick)
        elif isinstance(request, LookRequest):
            self._looks = tuple(request.agents)
            self._jobs.append(in_one_piece(lambda: watch.look_at(self._looked_at())))
        job = job_of(request, watch)
        if job is not None:
            self._jobs.append(job)
        elif isinstance(request, StepRequest):
            self._steps += pace.paused
        if goes_back(request):
            pace.set_paused(True, watch.tick)

    def _looked_at(self) -> tuple[str, ...]:
        """All agents that somebody looks at, here or watching."""
        return (*self._looks, *self._telling.looks_of_others())

    def _is_stopping(self) -> bool:
        return self._stopping

    async def _whole_run(self, request: Beginning) -> None:
        try:
            watch = await run_of(request, self._socket, self._wake.set)
            if isinstance(watch, ProblemsMessage):
                await self._telling.tell(watch)
                return
            self._watch = watch
            if self._stopping:
                watch.stop()
                await self._telling.state(watch, "stopped")
            else:
                path = "" if isinstance(request, ReplayRequest) else request.path
                broadcast = self._telling.broadcast = Broadcast(path, watch.mission, self._wake.set)
                await self._drive(watch, Pace(watch.tick_s, self._clock, speed_of(request.speed)), broadcast)
        except KitRobotError as error:
            await self._telling.break_off(error.message, error.help)
        except (RuntimeError, OSError, WebSocketDisconnect):
            # The page is gone in the middle of a message; `serve` hears of it too.
            _log.debug("the page left during a run", exc_info=True)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a run broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            help = Sentence("the run has ended; please report it")
            await self._telling.break_off(Sentence("something went wrong inside KitRobot"), help)

    def _take_place(self) -> bool:
        """Becomes one of the studio's runs; False when there are as many as it has."""
        if not self._counts and self._studio.runs >= MOST_RUNS:
            return False
        self._count(True)
        return True

    def _give_back(self, task: asyncio.Task[None]) -> None:
        """The place of a run that is over. Not for the task to do: one that is called off early runs no line of it."""
        if task is self._task:
            self._count(False)

    async def _no_place(self) -> None:
        help = Sentence("stop one of them, perhaps in another tab")
        await self._telling.fail(Sentence("this studio has {most} runs already", MOST_RUNS), help)

    def _count(self, counts: bool) -> None:
        self._studio.runs += counts - self._counts
        self._counts = counts

    async def _drive(self, watch: WatchedRun, pace: Pace, broadcast: Broadcast) -> None:
        """Goes round until the run is stopped. At its end it stands still, and can be taken back from there; it goes on
        when a person changes what kept it from going on.
        """
        self._pace, self._name = pace, f"run-{next(_numbers)}"
        self._studio.watches[self._name] = watch
        self._studio.broadcasts[self._name] = broadcast
        for request in self._early:
            self._steer(request)
        await self._telling.tell(watch.started(self._name))
        await self._telling.news(watch)
        while True:
            began = self._clock()
            self._wake.clear()
            if self._stopping:
                watch.stop()
                await self._telling.news(watch)
                await self._telling.state(watch, "stopped")
                broadcast.on = False
                return
            if watch.begins_anew():
                pace.set_paused(False, watch.tick)
            if await self._do_jobs(watch):
                pace.set_paused(pace.paused, watch.tick)
                await self._telling.news(watch)
            self._attend(watch, broadcast)
            broadcast.on = not watch.outcome
            if pace.paused:
                watch.hold()
            if watch.outcome and not watch.real:
                await self._telling.state(watch, watch.outcome)
                self._count(False)
                await self._wake.wait()
                if not self._is_stopping() and not self._take_place():
                    self._jobs = []
                    await self._no_place()
                continue
            await self._telling.state(watch, watch.outcome or ("paused" if pace.paused else "running"))
            due = None if watch.follows else pace.due(watch.tick)
            if pace.paused:
                due, self._steps = self._steps, 0
            if due != 0:
                await beside_loop(watch.advance, due, began + FRAME_S, self._clock)
                if watch.hits:
                    pace.set_paused(True, watch.tick)
                await self._telling.news(watch)
                if pace.paused or watch.outcome:
                    await self._telling.state(watch, watch.outcome or "paused")
            elif watch.real:
                await self._telling.news(watch)
            await self._rest(pace, watch, began)

    def _attend(self, watch: WatchedRun, broadcast: Broadcast) -> None:
        """Looks after those who watch; everything is told to everybody else at this moment."""
        if broadcast.looks_anew():
            watch.look_at(self._looked_at())
        broadcast.welcome(self._name, watch, self._telling.state_at(watch))

    async def _do_jobs(self, watch: WatchedRun) -> bool:
        """Does what was asked for meanwhile, until STOP; says whether there was anything."""
        jobs, self._jobs = self._jobs, []
        self._breaking_off = False
        for job in jobs:
            pieces, done = job(), False
            try:
                while not (done or self._breaking_off):
                    done = await beside_loop(do_until, pieces, self._clock() + FRAME_S, self._clock)
            except KitRobotError as error:
                await self._telling.fail(error.message, error.help)
        return bool(jobs)

    async def _rest(self, pace: Pace, watch: WatchedRun, began: float) -> None:
        """Until the next tick is due, but not before the next frame may be sent; a request ends it at once."""
        until_due = pace.wait_s(watch.tick)
        if watch.real:
            await asyncio.sleep(max(began + FRAME_S - self._clock(), 0))
            if pace.paused or watch.outcome:
                await self._wake.wait()
            return
        if self._steps or self._jobs or self._stopping or watch.outcome:
            return
        if until_due is None:
            await self._wake.wait()
            return
        pause = max(until_due, began + FRAME_S - self._clock(), 0)
        try:
            await asyncio.wait_for(self._wake.wait(), pause)
        except TimeoutError:
            return
