"""The two sockets of a class: a pupil's page reports and is told, the teacher's page sees all pupils.

A socket that says more than a page ever does is closed. What the teacher sees is looked at once a second, and only
pupils that changed are sent.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Annotated, Any, Final

from fastapi import WebSocket, WebSocketDisconnect
from pydantic import BaseModel, Field, TypeAdapter, ValidationError

from kitrobot.classroom import ClassRoom, Goal, Pupil, PupilStatus, RateLimit, Report, TeacherActions
from kitrobot.diagnostics import KitRobotError
from kitrobot.server.beside_loop import beside_loop
from kitrobot.server.class_overview import Overview
from kitrobot.server.class_routes import pupil_of, room_of
from kitrobot.server.routing import api_router
from kitrobot.server.shapes import HereMessage
from kitrobot.server.shapes.classroom import (
    ArenaMessage,
    ClassArenaShape,
    HandMessage,
    LookMessage,
    PupilNewsMessage,
    ReportMessage,
    ShowArenaMessage,
    TurnMessage,
)

LOOK_S: Final = 1.0
"""How often the teacher's page is told."""
MOST_A_SECOND: Final = 20.0
MOST_AT_ONCE: Final = 60.0
LONGEST_MESSAGE: Final = 64 * 1024
MOST_PAGES: Final = 6
"""Sockets of one pupil."""

class_socket_routes = api_router("/api/class")

_Said = Annotated[ReportMessage | HandMessage | TurnMessage | ShowArenaMessage, Field(discriminator="type")]
_SAID: TypeAdapter[_Said] = TypeAdapter(_Said)
_LOOKED: TypeAdapter[LookMessage] = TypeAdapter(LookMessage)


@contextmanager
def _woken(room: ClassRoom) -> Iterator[asyncio.Event]:
    """An event of this loop that is set, from whatever thread, when what pupils are told changes."""
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
        await _tell_pupil(socket, room, pupil)
    finally:
        room.close_page(pupil)


async def _tell_pupil(socket: WebSocket, room: ClassRoom, pupil: Pupil) -> None:
    hears = asyncio.ensure_future(_hear(socket, lambda text: _take(room, pupil, text)))
    try:
        with _woken(room) as news:
            sent: PupilStatus | None = None
            while not hears.done() and room.pupils.get(pupil.folder) is pupil:
                now = room.status_of(pupil)
                if now != sent:
                    sent = now
                    await socket.send_text(_news(now).model_dump_json())
                await _either(hears, news)
    except (WebSocketDisconnect, RuntimeError):
        pass  # gone while we spoke
    finally:
        await _end(socket, hears)


@class_socket_routes.websocket("/teacher/watch")
async def teacher_socket(socket: WebSocket) -> None:
    """Serves the teacher's page until it closes. The door lets nobody else come as far as here."""
    room = room_of(socket)
    overview: Overview = socket.app.state.overview
    await socket.accept()
    hears = asyncio.ensure_future(_hear(socket, lambda text: _look(room, text)))
    told: dict[str, BaseModel] = {}
    class_told: BaseModel | None = None
    arena_told = ("", "")
    try:
        while not hears.done():
            whole, pupils = await beside_loop(lambda: (overview.whole(), overview.pupils()))
            if whole != class_told:
                class_told = whole
                await socket.send_text(whole.model_dump_json())
            message = overview.news(told, pupils)
            told = dict(pupils)
            await socket.send_text(message.model_dump_json())
            arena = _arena(room)
            if arena != arena_told:
                arena_told = arena
                await socket.send_text(_arena_news(*arena).model_dump_json())
            await asyncio.wait({hears}, timeout=LOOK_S)
    except (WebSocketDisconnect, RuntimeError):
        pass
    finally:
        TeacherActions(room).view_pupil(None)
        await _end(socket, hears)


async def _either(hears: asyncio.Future[None], news: asyncio.Event) -> None:
    waits: asyncio.Future[bool] = asyncio.ensure_future(news.wait())
    both: set[asyncio.Future[Any]] = {hears, waits}
    await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
    waits.cancel()
    news.clear()


async def _end(socket: WebSocket, hears: asyncio.Future[None]) -> None:
    hears.cancel()
    with suppress(asyncio.CancelledError, Exception):
        await hears
    with suppress(RuntimeError, WebSocketDisconnect):
        await socket.close(1008)


async def _hear(socket: WebSocket, take: Callable[[str], None]) -> None:
    """Takes what the page says until it closes, says too much, or says what makes no sense."""
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
            if text == "?":  # whether anybody answers
                await socket.send_text(HereMessage().model_dump_json())
                continue
            try:
                # It may write: a full or slow disk holds up nobody else.
                await beside_loop(take, text)
            except (ValidationError, ValueError):
                return


def _take(room: ClassRoom, pupil: Pupil, text: str) -> None:
    said = _SAID.validate_json(text)
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
    goals = tuple(Goal(goal.reached, goal.why) for goal in said.goals)
    room.take_report(pupil, Report(said.running, said.edits, said.runs, said.file, said.exercise, goals))


def _look(room: ClassRoom, text: str) -> None:
    TeacherActions(room).view_pupil(room.pupils.get(_LOOKED.validate_json(text).folder))


def _arena(room: ClassRoom) -> tuple[str, str]:
    """Whom the teacher looks on, and what that page shows."""
    with room.lock:
        pupil = room.pupils.get(room.looked)
        return ("", "") if pupil is None else (pupil.folder, pupil.arena)


def _arena_news(folder: str, arena: str) -> ArenaMessage:
    shown = ClassArenaShape.model_validate_json(arena) if arena else None
    return ArenaMessage(type="arena", folder=folder, arena=shown)


def _news(status: PupilStatus) -> PupilNewsMessage:
    return PupilNewsMessage(
        type="pupil",
        class_name=status.class_name,
        name=status.name,
        word=status.word,
        frozen=status.frozen,
        exercise=status.exercise,
        handed=status.handed.number,
        handed_name=status.handed.name,
        note=status.note[0],
        note_text=status.note[1],
        looked=status.looked,
        hand=status.hand,
        turn=status.turn,
    )
