"""The two WebSockets of a class: a pupil's page sends reports and receives news, the teacher's page sees all pupils.

A socket that sends more than a page ever does is closed. The teacher's view is refreshed once a second, with only the
pupils that changed.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Annotated, Any, Final

from fastapi import WebSocket, WebSocketDisconnect
from pydantic import BaseModel, Field, TypeAdapter, ValidationError

from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.messages import (
    ArenaMessage,
    ClassArenaShape,
    HandMessage,
    LookMessage,
    PupilNewsMessage,
    ReportMessage,
    ShowArenaMessage,
    TurnMessage,
)
from kitrobot.classroom.overview import Overview
from kitrobot.classroom.pupil import Pupil, Report
from kitrobot.classroom.pupil_status import PupilStatus
from kitrobot.classroom.rate_limits import RateLimit
from kitrobot.classroom.teacher_actions import TeacherActions
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import run_in_background
from kitrobot.server.classroom.pupil_routes import pupil_of, room_of
from kitrobot.server.routes.api_router import api_router
from kitrobot.wire.journal import HereMessage

LOOK_S: Final = 1.0
"""How often the teacher's page is refreshed."""
MOST_A_SECOND: Final = 20.0
MOST_AT_ONCE: Final = 60.0
LONGEST_MESSAGE: Final = 64 * 1024
MOST_PAGES: Final = 6
"""Sockets of one pupil."""

class_socket_routes = api_router("/api/class")

PupilRequest = Annotated[ReportMessage | HandMessage | TurnMessage | ShowArenaMessage, Field(discriminator="type")]
PUPIL_REQUEST: TypeAdapter[PupilRequest] = TypeAdapter(PupilRequest)
TEACHER_REQUEST: TypeAdapter[LookMessage] = TypeAdapter(LookMessage)


@contextmanager
def _change_event(room: ClassRoom) -> Iterator[asyncio.Event]:
    """An event of this loop that is set, from any thread, when the news for pupils changes."""
    news = asyncio.Event()
    loop = asyncio.get_running_loop()

    def wake() -> None:
        with suppress(RuntimeError):  # the loop has ended
            loop.call_soon_threadsafe(news.set)

    end = room.subscribe(wake)
    try:
        yield news
    finally:
        end()


@class_socket_routes.websocket("/pupil")
async def pupil_socket(socket: WebSocket) -> None:
    """Serves one page of a pupil until it closes."""
    room = room_of(socket)
    try:
        pupil = pupil_of(socket)
    except KitRobotError:
        await socket.close(1008)
        return
    if pupil.pages >= MOST_PAGES:
        await socket.close(1013)
        return
    # Counted before anything is awaited: many that come at once are counted, too.
    room.open_page(pupil)
    try:
        await socket.accept()
        await _send_pupil_news(socket, room, pupil)
    finally:
        room.close_page(pupil)


async def _send_pupil_news(socket: WebSocket, room: ClassRoom, pupil: Pupil) -> None:
    receiver = asyncio.ensure_future(_receive_messages(socket, lambda text: _handle_pupil_message(room, pupil, text)))
    try:
        with _change_event(room) as news:
            sent: PupilStatus | None = None
            while not receiver.done() and room.pupils.get(pupil.folder) is pupil:
                now = room.status_of(pupil)
                if now != sent:
                    sent = now
                    await socket.send_text(_pupil_message(now).model_dump_json())
                await _wait_for_either(receiver, news)
    except (WebSocketDisconnect, RuntimeError):
        pass  # the page has gone meanwhile
    finally:
        await _close_socket(socket, receiver)


@class_socket_routes.websocket("/teacher/watch")
async def teacher_socket(socket: WebSocket) -> None:
    """Serves the teacher's page until it closes. The gateway refuses everybody else."""
    room = room_of(socket)
    overview: Overview = socket.app.state.overview
    await socket.accept()
    receiver = asyncio.ensure_future(_receive_messages(socket, lambda text: _handle_teacher_message(room, text)))
    sent: dict[str, BaseModel] = {}
    sent_class: BaseModel | None = None
    sent_arena = ("", "")
    try:
        while not receiver.done():
            whole, pupils = await run_in_background(lambda: (overview.class_message(), overview.pupils()))
            if whole != sent_class:
                sent_class = whole
                await socket.send_text(whole.model_dump_json())
            message = overview.pupils_message(sent, pupils)
            sent = dict(pupils)
            await socket.send_text(message.model_dump_json())
            arena = _current_arena(room)
            if arena != sent_arena:
                sent_arena = arena
                await socket.send_text(_arena_message(*arena).model_dump_json())
            await asyncio.wait({receiver}, timeout=LOOK_S)
    except (WebSocketDisconnect, RuntimeError):
        pass
    finally:
        TeacherActions(room).view_pupil(None)
        await _close_socket(socket, receiver)


async def _wait_for_either(receiver: asyncio.Future[None], news: asyncio.Event) -> None:
    waits: asyncio.Future[bool] = asyncio.ensure_future(news.wait())
    both: set[asyncio.Future[Any]] = {receiver, waits}
    await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
    waits.cancel()
    news.clear()


async def _close_socket(socket: WebSocket, receiver: asyncio.Future[None]) -> None:
    receiver.cancel()
    with suppress(asyncio.CancelledError, Exception):
        await receiver
    with suppress(RuntimeError, WebSocketDisconnect):
        await socket.close(1008)


async def _receive_messages(socket: WebSocket, take: Callable[[str], None]) -> None:
    """Handles the page's messages until it closes, sends too much, or sends an invalid one."""
    now = asyncio.get_running_loop().time
    allowance = RateLimit(MOST_A_SECOND, MOST_AT_ONCE)
    with suppress(WebSocketDisconnect, RuntimeError):
        while True:
            message = await socket.receive()
            text = message.get("text")
            if message["type"] == "websocket.disconnect" or not isinstance(text, str):
                return
            if len(text) > LONGEST_MESSAGE or not allowance.take(now()):
                return
            if text == "?":  # a ping
                await socket.send_text(HereMessage().model_dump_json())
                continue
            try:
                # It may write: a full or slow disk holds up nobody else.
                await run_in_background(take, text)
            except (ValidationError, ValueError):
                return


def _handle_pupil_message(room: ClassRoom, pupil: Pupil, text: str) -> None:
    said = PUPIL_REQUEST.validate_json(text)
    if isinstance(said, HandMessage):
        room.set_hand(pupil, said.up)
        return
    if isinstance(said, TurnMessage):
        room.give_turn(pupil, said.yes)
        return
    if isinstance(said, ShowArenaMessage):
        arena = said.arena.model_dump_json()
        # What cannot be read again would end the teacher's socket, not the pupil's.
        ClassArenaShape.model_validate_json(arena)
        room.show_arena(pupil, arena)
        return
    room.take_report(pupil, Report(said.running, said.edits, said.runs, said.file, said.exercise, said.goals))


def _handle_teacher_message(room: ClassRoom, text: str) -> None:
    TeacherActions(room).view_pupil(room.pupils.get(TEACHER_REQUEST.validate_json(text).folder))


def _current_arena(room: ClassRoom) -> tuple[str, str]:
    """The folder of the pupil whom the teacher watches, and what that page shows."""
    with room.lock:
        pupil = room.pupils.get(room.looked)
        return ("", "") if pupil is None else (pupil.folder, pupil.arena)


def _arena_message(folder: str, arena: str) -> ArenaMessage:
    shown = ClassArenaShape.model_validate_json(arena) if arena else None
    return ArenaMessage(type="arena", folder=folder, arena=shown)


def _pupil_message(status: PupilStatus) -> PupilNewsMessage:
    return PupilNewsMessage(type="pupil", **vars(status))
