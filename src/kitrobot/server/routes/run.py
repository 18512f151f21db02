"""`WS /api/run`: a run that the page starts, steers and watches."""

from __future__ import annotations

from functools import partial

from fastapi import APIRouter, WebSocket

from kitrobot.live.runs import RunSession
from kitrobot.server.routes.api_router import refuse_visitors, studio_of
from kitrobot.server.sockets import SocketChannel

run_routes = APIRouter()


@run_routes.websocket("/api/run")
async def run(socket: WebSocket) -> None:
    """Serves one socket until it closes."""
    await socket.accept()
    await RunSession(SocketChannel(socket), studio_of(socket), partial(refuse_visitors, socket)).serve()
