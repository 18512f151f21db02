"""A run that a page starts, steers and watches, over a socket of its own.

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

from pydantic import ValidationError

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import run_in_background
from kitrobot.live.broadcast import MOST_WATCHERS, Broadcast, Subscription
from kitrobot.live.feed import Channel, ChannelClosedError
from kitrobot.live.realtime_pacer import RealtimePacer, clamp_speed
from kitrobot.live.run_jobs import Job, job_for_request, run_job_until, single_step_job, steps_back
from kitrobot.live.run_publisher import RunPublisher
from kitrobot.live.run_sources import create_run, initial_requests
from kitrobot.live.studio import Studio
from kitrobot.live.watched_run import WatchedRun
from kitrobot.text.sentences import Sentence
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.run import ProblemsMessage
from kitrobot.wire.run_requests import (
    REQUEST,
    Beginning,
    LookRequest,
    PauseRequest,
    ReplayRequest,
    ResumeRequest,
    SpeedRequest,
    Steering,
    StepRequest,
    StopRequest,
    WatchRequest,
)
from kitrobot.wire.sentences import not_understood

LARGEST_MESSAGE_BYTES = 16 * 1024 * 1024
MOST_RUNS = 8
"""Runs that one studio has at a time: a forgotten page must not stop the others."""
FRAME_S = 1 / 30

_log = logging.getLogger("kitrobot.server")
_numbers = itertools.count(1)


class RunSession:
    """One socket and the run on it. `refuse_visitors` raises an error where real robots are not this page's to use;
    `clock` gives seconds and never goes back.
    """

    def __init__(
        self,
        channel: Channel,
        studio: Studio,
        refuse_visitors: Callable[[], None] = lambda: None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._channel = channel
        self._publisher = RunPublisher(channel)
        self._studio = studio
        self._refuse_visitors = refuse_visitors
        self._clock = clock
        self._task: asyncio.Task[None] | None = None
        self._wake = asyncio.Event()
        self._pace: RealtimePacer | None = None
        self._watch: WatchedRun | None = None
        self._name = ""
        self._subscription: Subscription | None = None
        """The place from which this socket watches another's run."""
        self._looks: tuple[str, ...] = ()
        self._early: list[Steering] = []
        """Requests that came while the mission was still being compiled."""
        self._steps = 0
        self._jobs: list[Job] = []
        """What is to be done to the run between two rounds, in a thread."""
        self._breaking_off = False
        """Whether the job that is on is to leave off."""
        self._stopping = False
        self._counts = False
        """Whether it is one of the studio's runs; one that is at its end is not."""

    async def serve(self) -> None:
        """Reads requests until the socket closes, then ends the run."""
        try:
            while True:
                await self._handle_message(await self._channel.receive())
        except ChannelClosedError:
            return
        finally:
            # Watchers are notified before anything is awaited: a cancellation ends the awaiting too.
            self._close_run()
            try:
                if self._task is not None:
                    self._task.cancel()
                    await asyncio.gather(self._task, return_exceptions=True)
            finally:
                self._close_watch()
                await self._stop_watching()

    def _close_run(self) -> None:
        """The run of this socket is looked at no more, and cannot be saved any more."""
        self._studio.watches.pop(self._name, None)
        self._studio.broadcasts.pop(self._name, None)
        message = Sentence("the page that steered this run is gone, and the run with it")
        self._publisher.end_for_others(message, Sentence("start one of your own"))

    def _close_watch(self) -> None:
        if self._watch is not None:
            self._watch.close()

    async def _handle_message(self, text: str | bytes) -> None:
        try:
            request = REQUEST.validate_json(text)
        except ValidationError as error:
            wrong = not_understood(error)
            await self._publisher.send_error(wrong.message, wrong.help)
            return
        if isinstance(request, Beginning):
            await self._start(request)
        elif isinstance(request, WatchRequest):
            await self._start_watching(request)
        elif self._subscription is not None:
            if isinstance(request, LookRequest):
                self._subscription.select_agents(request.agents)
            else:
                help = Sentence("to steer one, start a run of your own")
                await self._publisher.send_error(Sentence("the page that started this run steers it"), help)
        elif self._task is not None and not self._task.done():
            self._steer(request)

    async def _start(self, request: Beginning) -> None:
        if self._task is not None and not self._task.done():
            if self._counts:
                await self._publisher.send_error(Sentence("a run is on already"), Sentence("stop it first"))
                return
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
        # Looked for and taken in one breath: nobody comes between.
        if not self._acquire_slot():
            await self._refuse_no_slot()
            return
        try:
            self._close_run()
            self._close_watch()
            await self._stop_watching()
        except BaseException:
            self._count(False)
            raise
        self._pace, self._watch, self._early, self._steps, self._jobs = None, None, initial_requests(request), 0, []
        self._stopping, self._looks = False, ()
        self._publisher.reset()
        self._wake.clear()
        self._task = asyncio.create_task(self._run_to_end(request))
        self._task.add_done_callback(self._release_slot)

    async def _start_watching(self, request: WatchRequest) -> None:
        if self._task is not None and not self._task.done():
            await self._publisher.send_error(Sentence("a run is on already"), Sentence("stop it first"))
            return
        await self._stop_watching()
        try:
            mission = await run_in_background(mission_from_shape, request.mission)
        except KitRobotError as error:
            await self._publisher.send_error(error.message, error.help, ended=True)
            return
        broadcast = self._studio.broadcasts.get(request.run)
        if broadcast is None or not broadcast.on:
            await self._publisher.send_error(
                Sentence("this run is over"), Sentence("start one of your own"), ended=True
            )
        elif len(broadcast) >= MOST_WATCHERS:
            message = Sentence("{most} pages watch this run already", MOST_WATCHERS)
            await self._publisher.send_error(message, Sentence("try again later"), ended=True)
        else:
            self._subscription = Subscription(broadcast, self._channel, another=not broadcast.runs_mission(mission))

    async def _stop_watching(self) -> None:
        """Ends this socket's watching."""
        subscription, self._subscription = self._subscription, None
        if subscription is not None:
            await subscription.leave()

    def _steer(self, request: Steering) -> None:
        if isinstance(request, StopRequest):
            # Earlier requests are obsolete; real robots get this one next.
            self._jobs, self._breaking_off = [], True
        if isinstance(request, StopRequest) and not (self._watch is not None and self._watch.real):
            self._stopping = True
        elif self._pace is None or self._watch is None:
            self._early.append(request)
        else:
            self._apply(request, self._watch, self._pace)
        self._wake.set()

    def _apply(self, request: Steering, watch: WatchedRun, pace: RealtimePacer) -> None:
        if isinstance(request, PauseRequest | ResumeRequest):
            pace.set_paused(isinstance(request, PauseRequest), watch.tick)
        elif isinstance(request, SpeedRequest):
            pace.set_speed(clamp_speed(request.value), watch.tick)
        elif isinstance(request, LookRequest):
            self._looks = tuple(request.agents)
            self._jobs.append(single_step_job(lambda: watch.look_at(self._selected_agents())))
        job = job_for_request(request, watch)
        if job is not None:
            self._jobs.append(job)
        elif isinstance(request, StepRequest):
            self._steps += pace.paused
        if steps_back(request):
            pace.set_paused(True, watch.tick)

    def _selected_agents(self) -> tuple[str, ...]:
        """All agents that this page or a watcher has selected."""
        return (*self._looks, *self._publisher.watcher_selected_agents())

    def _is_stopping(self) -> bool:
        return self._stopping

    async def _run_to_end(self, request: Beginning) -> None:
        try:
            watch = await create_run(request, self._studio, self._refuse_visitors, self._wake.set)
            if isinstance(watch, ProblemsMessage):
                await self._publisher.send(watch)
                return
            self._watch = watch
            if self._stopping:
                watch.stop()
                await self._publisher.publish_state(watch, "stopped")
            else:
                path = "" if isinstance(request, ReplayRequest) else request.path
                broadcast = self._publisher.broadcast = Broadcast(path, watch.mission, self._wake.set)
                await self._drive(
                    watch, RealtimePacer(watch.tick_s, self._clock, clamp_speed(request.speed)), broadcast
                )
        except KitRobotError as error:
            await self._publisher.end_for_all(error.message, error.help)
        except ChannelClosedError:
            # The page is gone in the middle of a message; `serve` notices it too.
            _log.debug("the page left during a run", exc_info=True)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a run broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            help = Sentence("the run has ended; please report it")
            await self._publisher.end_for_all(Sentence("something went wrong inside KitRobot"), help)

    def _acquire_slot(self) -> bool:
        """Takes one of the studio's run slots; False when all are taken."""
        if not self._counts and self._studio.runs >= MOST_RUNS:
            return False
        self._count(True)
        return True

    def _release_slot(self, task: asyncio.Task[None]) -> None:
        """Releases the slot of a run that is over. The task cannot do it: one that is cancelled early runs no line."""
        if task is self._task:
            self._count(False)

    async def _refuse_no_slot(self) -> None:
        help = Sentence("stop one of them, perhaps in another tab")
        await self._publisher.send_error(Sentence("this studio has {most} runs already", MOST_RUNS), help)

    def _count(self, counts: bool) -> None:
        self._studio.runs += counts - self._counts
        self._counts = counts

    async def _drive(self, watch: WatchedRun, pace: RealtimePacer, broadcast: Broadcast) -> None:
        """Loops until the run is stopped. At its end it pauses, and can be taken back from there; it goes on
        when a person removes what held it.
        """
        self._pace, self._name = pace, f"run-{next(_numbers)}"
        self._studio.watches[self._name] = watch
        self._studio.broadcasts[self._name] = broadcast
        for request in self._early:
            self._steer(request)
        await self._publisher.send(watch.started(self._name))
        await self._publisher.publish_update(watch)
        while True:
            began = self._clock()
            self._wake.clear()
            if self._stopping:
                watch.stop()
                await self._publisher.publish_update(watch)
                await self._publisher.publish_state(watch, "stopped")
                broadcast.on = False
                return
            if watch.has_restarted():
                pace.set_paused(False, watch.tick)
            if await self._run_jobs(watch):
                pace.set_paused(pace.paused, watch.tick)
                await self._publisher.publish_update(watch)
            self._serve_watchers(watch, broadcast)
            broadcast.on = not watch.outcome
            if pace.paused:
                watch.hold()
            if watch.outcome and not watch.real:
                await self._publisher.publish_state(watch, watch.outcome)
                self._count(False)
                await self._wake.wait()
                if not self._is_stopping() and not self._acquire_slot():
                    self._jobs = []
                    await self._refuse_no_slot()
                continue
            await self._publisher.publish_state(watch, watch.outcome or ("paused" if pace.paused else "running"))
            due = None if watch.follows else pace.due(watch.tick)
            if pace.paused:
                due, self._steps = self._steps, 0
            if due != 0:
                await run_in_background(watch.advance, due, began + FRAME_S, self._clock)
                if watch.hits:
                    pace.set_paused(True, watch.tick)
                await self._publisher.publish_update(watch)
                if pace.paused or watch.outcome:
                    await self._publisher.publish_state(watch, watch.outcome or "paused")
            elif watch.real:
                await self._publisher.publish_update(watch)
            await self._wait_for_next_frame(pace, watch, began)

    def _serve_watchers(self, watch: WatchedRun, broadcast: Broadcast) -> None:
        """Serves new and selecting watchers; everybody else has been sent everything at this moment."""
        if broadcast.selection_changed():
            watch.look_at(self._selected_agents())
        broadcast.send_snapshot_to_new(self._name, watch, self._publisher.latest_state(watch))

    async def _run_jobs(self, watch: WatchedRun) -> bool:
        """Does what was requested meanwhile, until STOP; returns whether there was anything."""
        jobs, self._jobs = self._jobs, []
        self._breaking_off = False
        for job in jobs:
            pieces, done = job(), False
            try:
                while not (done or self._breaking_off):
                    done = await run_in_background(run_job_until, pieces, self._clock() + FRAME_S, self._clock)
            except KitRobotError as error:
                await self._publisher.send_error(error.message, error.help)
        return bool(jobs)

    async def _wait_for_next_frame(self, pace: RealtimePacer, watch: WatchedRun, began: float) -> None:
        """Waits until the next tick is due, but not before the next frame may be sent; a request ends it at once."""
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
