"""What a page's request begins: a simulated run, a recording that is played, real robots that are watched."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress

from starlette.requests import HTTPConnection

from kitrobot.diagnostics import ProblemsError
from kitrobot.server.live_run import LiveRun
from kitrobot.server.replay import Replay
from kitrobot.server.routing import refuse_visitors, studio_of
from kitrobot.server.shapes import (
    Beginning,
    BreakpointsRequest,
    ProblemsMessage,
    ReplayRequest,
    RobotsRequest,
    StartRequest,
    Steering,
    mission_from_shape,
    problem_shapes,
)
from kitrobot.server.studio import Studio
from kitrobot.server.watched_run import WatchedRun
from kitrobot.workspace import OpenMission, RunOptions


async def run_of(
    request: Beginning, connection: HTTPConnection, wake: Callable[[], None]
) -> WatchedRun | ProblemsMessage:
    """The run, or why it cannot begin. `wake` is called when real robots did something.

    Raises:
        KitRobotError: there is no such recording, or no such robot.
    """
    studio = studio_of(connection)
    if isinstance(request, RobotsRequest):
        refuse_visitors(connection)
        opened = await asyncio.to_thread(_opened, studio, request)
        return _robots(studio, request, opened, wake)
    if isinstance(request, ReplayRequest):
        return await asyncio.to_thread(_replay, studio, request)
    return await asyncio.to_thread(_simulated, studio, request)


def come_with(request: Beginning) -> list[Steering]:
    """What a request asks of its run before its first step; what is at full speed may be over when the next comes."""
    if isinstance(request, ReplayRequest | RobotsRequest) and request.breakpoints:
        return [BreakpointsRequest(type="breakpoints", breakpoints=request.breakpoints)]
    return []


def _opened(studio: Studio, request: StartRequest | RobotsRequest) -> OpenMission:
    opened = studio.open(mission_from_shape(request.mission), request.path)
    opened.compiled  # noqa: B018 (here it holds nobody up)
    return opened


def _robots(studio: Studio, request: RobotsRequest, opened: OpenMission, wake: Callable[[], None]) -> WatchedRun:
    """In the loop of the server, which knows the robots; whoever calls this off finds no run that hears them still."""
    from kitrobot.server.robots_watch import RobotsWatch

    loop = asyncio.get_running_loop()

    def changed() -> None:
        with suppress(RuntimeError):  # the studio has ended meanwhile
            loop.call_soon_threadsafe(wake)

    return RobotsWatch(studio.boards.together(request.holder, request.addresses), opened, changed)


def _replay(studio: Studio, request: ReplayRequest) -> WatchedRun:
    trace = studio.recordings.open(request.recording)
    return Replay(trace, studio.recorded(trace, request.recording))


def _simulated(studio: Studio, request: StartRequest) -> WatchedRun | ProblemsMessage:
    try:
        options = RunOptions(request.seed, request.seconds, request.fail_rate)
        return LiveRun(_opened(studio, request).prepare(options))
    except ProblemsError as error:
        return ProblemsMessage(problems=problem_shapes(error.diagnostics))
