"""What a page's request begins: a simulated run, a recording that is played, real robots that are watched, a team of
processes.
"""

from __future__ import annotations

import asyncio
import copy
from collections.abc import Callable
from contextlib import suppress
from importlib.util import find_spec

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.live.background import run_in_background
from kitrobot.live.studio import Studio
from kitrobot.live.watched_recording import WatchedRecording
from kitrobot.live.watched_run import WatchedRun
from kitrobot.live.watched_simulation import WatchedSimulation
from kitrobot.mission.model import Mission
from kitrobot.text.sentences import Sentence
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.problem import problem_shapes
from kitrobot.wire.run import ProblemsMessage
from kitrobot.wire.run_requests import (
    Beginning,
    BreakpointsRequest,
    FleetRequest,
    ReplayRequest,
    RobotsRequest,
    StartRequest,
    Steering,
)
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions


async def create_run(
    request: Beginning, studio: Studio, refuse_visitors: Callable[[], None], wake: Callable[[], None]
) -> WatchedRun | ProblemsMessage:
    """The run, or why it cannot begin. `wake` is called when real robots did something.

    Raises:
        KitRobotError: there is no such recording, or no such robot; or `refuse_visitors` raised it.
    """
    if isinstance(request, RobotsRequest):
        refuse_visitors()
        opened = await run_in_background(_opened, studio, request)
        return _robots(studio, request, opened, wake)
    if isinstance(request, FleetRequest):
        if not studio.in_page:
            refuse_visitors()
        return await _fleet(studio, request, wake)
    if isinstance(request, ReplayRequest):
        return await run_in_background(_replay, studio, request)
    return await run_in_background(_simulated, studio, request)


def initial_requests(request: Beginning) -> list[Steering]:
    """What a request asks of its run before its first step; what is at full speed may be over when the next comes."""
    if isinstance(request, ReplayRequest | RobotsRequest | FleetRequest) and request.breakpoints:
        return [BreakpointsRequest(type="breakpoints", breakpoints=request.breakpoints)]
    return []


def _opened(studio: Studio, request: StartRequest | RobotsRequest | FleetRequest) -> OpenMission:
    opened = studio.open(mission_from_shape(request.mission), request.path)
    opened.compiled  # noqa: B018 (here it holds nobody up)
    return opened


def _robots(studio: Studio, request: RobotsRequest, opened: OpenMission, wake: Callable[[], None]) -> WatchedRun:
    """In the loop of the server, which knows the robots; so after a cancellation no run is subscribed to them."""
    from kitrobot.live.watched_robots import WatchedRobots

    return WatchedRobots(
        studio.boards.named_sessions(request.holder, request.addresses), opened, _from_any_thread(wake)
    )


def _from_any_thread(wake: Callable[[], None]) -> Callable[[], None]:
    loop = asyncio.get_running_loop()

    def changed() -> None:
        with suppress(RuntimeError):  # the studio has ended meanwhile
            loop.call_soon_threadsafe(wake)

    return changed


async def _fleet(studio: Studio, request: FleetRequest, wake: Callable[[], None]) -> WatchedRun | ProblemsMessage:
    """Nothing is waited for once the fleet is made: whoever calls this off leaves none."""
    if studio.in_page:
        raise KitRobotError(
            Sentence("a team as processes cannot run in a page"),
            Sentence("run it as a simulation here, or install KitRobot on this computer"),
        )
    if find_spec("zenoh") is None:
        raise KitRobotError(
            Sentence("a team as processes needs the package `{package}`", "eclipse-zenoh"),
            Sentence("install it: {command}", "`pip install kitrobot[fleet]`"),
        )
    try:
        prepared, mission = await run_in_background(_prepared, studio, request)
    except ProblemsError as error:
        return ProblemsMessage(problems=problem_shapes(error.diagnostics))
    from kitrobot.live.watched_fleet import FleetThread, WatchedFleet

    team = studio.boards.team
    boards = await team.claim(request.holder, prepared.opened, request.path, request.boards)
    try:
        drivers = studio.folder.folders_of(request.path)[0]
        running = FleetThread(team, prepared, boards, drivers, _from_any_thread(wake))
        watch = WatchedFleet(running, prepared, mission)
    except BaseException:
        team.release()
        raise
    running.start()
    return watch


def _prepared(studio: Studio, request: FleetRequest) -> tuple[PreparedRun, Mission]:
    """The network is the radio of a fleet, instead of the mission's radio."""
    from kitrobot.fleet.charter import charter_of

    opened = _opened(studio, request)
    mission = copy.copy(opened.mission)
    opened.mission.radio = None
    prepared = opened.prepare(RunOptions(request.seed))
    charter_of(prepared.simulation)
    return prepared, mission


def _replay(studio: Studio, request: ReplayRequest) -> WatchedRun:
    trace = studio.recordings.open(request.recording)
    return WatchedRecording(trace, studio.recorded(trace, request.recording))


def _simulated(studio: Studio, request: StartRequest) -> WatchedRun | ProblemsMessage:
    try:
        options = RunOptions(request.seed, request.seconds, request.fail_rate)
        return WatchedSimulation(_opened(studio, request).prepare(options))
    except ProblemsError as error:
        return ProblemsMessage(problems=problem_shapes(error.diagnostics))
