"""`WS /api/boards/port`: the bytes of one serial port that a page has opened where its visitor sits.

Bytes travel as binary messages; a text is one word: `open` and `close` to the page; `opened`, `busy`, `failed` and
`gone` from it. The page shows by the key of its welcome that the port is its own. When the socket closes the port is
gone, and a robot that runs held receives nothing any more.
"""

from __future__ import annotations

import contextlib
from typing import Annotated, Final

from fastapi import APIRouter, Query, WebSocket, WebSocketDisconnect

from kitrobot.live.robot_registry import AddressError
from kitrobot.server.routes.api_router import refuse_visitors, studio_of

page_port_routes = APIRouter()
MOST_PIECE: Final = 64 * 1024
"""Bytes of one message of the page."""
_NOT_ALLOWED, _TOO_MUCH = 1008, 1009


@page_port_routes.websocket("/api/boards/port")
async def page_port(
    socket: WebSocket,
    key: Annotated[str, Query(max_length=100)] = "",
    mark: Annotated[str, Query(pattern="^[0-9a-f]{32}$")] = "",
    vendor: Annotated[int, Query(ge=0, le=0xFFFF)] = 0,
) -> None:
    """Serves one port until it goes."""
    await socket.accept()
    try:
        refuse_visitors(socket)
    except AddressError:
        await socket.close(_NOT_ALLOWED)
        return
    from kitrobot.live.page_ports import register_port

    async def send(words: str | bytes) -> None:
        try:
            await (socket.send_text(words) if isinstance(words, str) else socket.send_bytes(words))
        except WebSocketDisconnect as error:
            raise OSError("the page hung up") from error

    registry = studio_of(socket).boards
    owner = registry.page_by_key(key)
    port = None if owner is None or not owner.has_room else register_port(mark, vendor, send)
    if owner is None or port is None:
        await socket.close(_NOT_ALLOWED)
        return
    owner.hold(port)
    try:
        while True:
            message = await socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            data, word = message.get("bytes"), message.get("text")
            if data is None:
                if word == "opened":
                    port.opened()
                elif word in ("busy", "failed"):
                    port.refused(word)
                elif word == "gone":
                    break
            elif len(data) > MOST_PIECE:
                await socket.close(_TOO_MUCH)
                return
            else:
                port.receive_data(data)
                await port.room()
        with contextlib.suppress(RuntimeError, OSError):
            await socket.close()
    finally:
        port.disconnect()
        owner.drop(port)
