"""`WS /api/boards`: the page's Robots panel; `GET /api/board/trace`: the recording of a robot.

The socket is open as long as the page has to do with real robots. When it closes, for whatever reason, the robots that
the page holds are let go, and those that run held stop. Ports belong to who sits at this machine: a visitor from
elsewhere is refused, unless the studio was started for that.
"""

from __future__ import annotations

import logging
import os
import shutil
from typing import TYPE_CHECKING, Annotated

from fastapi import APIRouter, Query, Request, WebSocket
from fastapi.responses import FileResponse
from pydantic import ValidationError
from starlette.background import BackgroundTask

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import run_in_background
from kitrobot.live.feed import Channel, ChannelClosedError
from kitrobot.live.robot_registry import AddressError, RobotRegistry
from kitrobot.live.robot_subscriber import RobotSubscriber
from kitrobot.live.studio import Studio
from kitrobot.live.team_controller import TEAM
from kitrobot.server.routes.api_router import refuse_visitors, studio_of
from kitrobot.server.sockets import SocketChannel
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.wire.board import (
    BOARD_REQUEST,
    BoardBenchRequest,
    BoardCancelRequest,
    BoardConnectRequest,
    BoardForgetRequest,
    BoardIdentifyRequest,
    BoardRefusedMessage,
    BoardRequest,
    BoardSendRequest,
    BoardsLookRequest,
    BoardStartRequest,
    BoardStopRequest,
    BoardTryRequest,
    TeamCancelRequest,
    TeamSendRequest,
)
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.problem import problem_shapes
from kitrobot.wire.sentences import not_understood

if TYPE_CHECKING:
    from kitrobot.boards.bench import Bench
    from kitrobot.robots.program import BoardProgram
    from kitrobot.workspace.mission_loader import OpenMission

board_routes = APIRouter()
_log = logging.getLogger("kitrobot.server")


@board_routes.websocket("/api/boards")
async def boards(socket: WebSocket) -> None:
    """Serves one page until it goes away."""
    await socket.accept()
    studio = studio_of(socket)
    try:
        refuse_visitors(socket)
    except AddressError as error:
        await socket.send_text(_refusal("", error).model_dump_json())
        await socket.close(1008)
        return
    await BoardSession(SocketChannel(socket), studio, studio.boards).serve()


@board_routes.get("/api/board/trace", response_class=FileResponse)
async def board_trace(request: Request, address: Annotated[str, Query(max_length=200)]) -> FileResponse:
    """What a robot did in its last run, or does in the one that is on, as a recording."""
    studio = studio_of(request)
    refuse_visitors(request)
    recorder = studio.boards.recorder(address)
    path = await run_in_background(studio.recordings.new_file, f"robot{ENDING}")
    try:
        await run_in_background(recorder.save, path)
    except BaseException:
        shutil.rmtree(path.parent, ignore_errors=True)
        raise
    gone = BackgroundTask(shutil.rmtree, path.parent, ignore_errors=True)
    return FileResponse(path, media_type="application/octet-stream", background=gone)


def _refusal(address: str, error: KitRobotError) -> BoardRefusedMessage:
    return BoardRefusedMessage(
        address=address,
        message=error.message,
        help=error.help,
        problems=problem_shapes(error.diagnostics),
    )


class BoardSession:
    """One page and the robots it holds."""

    def __init__(self, channel: Channel, studio: Studio, room: RobotRegistry) -> None:
        self._channel = channel
        self._studio = studio
        self._room = room

    async def serve(self) -> None:
        """Reads requests until the socket closes, then lets go of the page's robots."""
        subscriber = self._room.subscribe(self._channel)
        try:
            while True:
                await self._handle_message(subscriber, await self._channel.receive())
        except ChannelClosedError:
            return
        finally:
            await self._room.unsubscribe(subscriber)

    async def _handle_message(self, subscriber: RobotSubscriber, text: str | bytes) -> None:
        try:
            request: BoardRequest = BOARD_REQUEST.validate_json(text)
        except ValidationError as error:
            self._refuse(subscriber, "", not_understood(error))
            return
        address = TEAM if isinstance(request, TeamSendRequest) else getattr(request, "address", "")
        try:
            await self._do(subscriber, request)
        except KitRobotError as error:
            self._refuse(subscriber, address, error)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a robot's request broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            self._refuse(
                subscriber,
                address,
                KitRobotError(Sentence("something went wrong inside KitRobot"), Sentence("please report it")),
            )

    def _refuse(self, subscriber: RobotSubscriber, address: str, error: KitRobotError) -> None:
        subscriber.queue_message(_refusal(address, error))

    async def _do(self, subscriber: RobotSubscriber, request: BoardRequest) -> None:
        room = self._room
        match request:
            case BoardsLookRequest():
                room.show_ports(subscriber, request.on)
            case BoardConnectRequest():
                program: BoardProgram | None = None
                try:
                    program = await run_in_background(self._program, request)
                except KitRobotError:
                    # A program with a mistake is on no robot; the robot can be greeted all the same.
                    _log.debug("greeted without a program", exc_info=True)
                (await room.session(subscriber.name, request.address)).connect(program)
            case BoardSendRequest():
                program = await run_in_background(self._program, request)
                (await room.session(subscriber.name, request.address)).send(
                    program, request.then, request.replace, request.fresh
                )
            case BoardBenchRequest():
                from kitrobot.live.robot_bench import steps_message

                bench = await run_in_background(self._bench, request)
                worker = await room.session(subscriber.name, request.address)
                subscriber.queue_message(steps_message(request.address, bench))
                worker.bench(bench, request.replace)
            case BoardTryRequest():
                room.held_session(subscriber.name, request.address).try_step(request.step)
            case BoardStopRequest():
                room.stop(request.address)
            case BoardCancelRequest():
                room.held_session(subscriber.name, request.address).cancel()
            case BoardStartRequest():
                room.held_session(subscriber.name, request.address).start(request.held)
            case BoardIdentifyRequest():
                room.held_session(subscriber.name, request.address).identify()
            case BoardForgetRequest():
                await room.release(room.held_session(subscriber.name, request.address))
            case TeamSendRequest():
                opened = await run_in_background(self._open_message, request)
                folder = self._studio.folder.folders_of(request.path)[0]
                await room.team.send(subscriber.name, opened, request.path, request.boards, folder)
            case TeamCancelRequest():
                room.team.cancel()

    def _program(self, request: BoardConnectRequest | BoardSendRequest) -> BoardProgram:
        from kitrobot.boards.programs import board_program
        from kitrobot.workspace.kit_files import kit_named

        folder = self._studio.folder.folders_of(request.path)[0]
        kit = kit_named(request.kit, folder) if request.kit else None
        return board_program(self._open_message(request), request.program, folder, kit)

    def _bench(self, request: BoardBenchRequest) -> Bench:
        from kitrobot.boards.bench import bench_of
        from kitrobot.compiler.target import robot_of
        from kitrobot.workspace.kit_files import kit_named

        folder = self._studio.folder.folders_of(request.path)[0]
        kit = kit_named(request.kit, folder) if request.kit else None
        opened = self._open_message(request)
        return bench_of(robot_of(opened.program(request.program), opened.catalogue), kit, folder)

    def _open_message(
        self, request: BoardConnectRequest | BoardSendRequest | BoardBenchRequest | TeamSendRequest
    ) -> OpenMission:
        return self._studio.open(mission_from_shape(request.mission), request.path)
