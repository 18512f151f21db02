"""The web server that the studio runs in: what it bounds, and how it begins and ends."""

from __future__ import annotations

import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

import uvicorn
from starlette.types import ASGIApp

from kitrobot.live.runs import LARGEST_MESSAGE_BYTES
from kitrobot.server.connections import LARGEST_HEAD_BYTES, MOST_CONNECTIONS, BoundedConnection
from kitrobot.server.garbage_collector import tune_garbage_collector

END_WITHIN_S = 2
"""How long open connections may take to close after Ctrl-C."""


def run_server(
    app: ASGIApp, listening: Sequence[socket.socket], ready: Callable[[], None], tls: tuple[Path, Path] | None = None
) -> None:
    """Serves until Ctrl-C; `ready` is called once it listens, `tls` is a certificate and its key."""
    config = server_config(app, tls)
    tune_garbage_collector()
    with suppress(KeyboardInterrupt):
        _Server(config, ready).run(sockets=list(listening))


def server_config(app: ASGIApp, tls: tuple[Path, Path] | None = None) -> uvicorn.Config:
    """How the studio is served. Nothing is compressed on a WebSocket: to the same machine that only costs time."""
    certificate, key = (None, None) if tls is None else map(str, tls)
    return uvicorn.Config(
        app,
        ssl_certfile=certificate,
        ssl_keyfile=key,
        log_level="warning",
        access_log=False,
        # Else it asks standard output whether that is a terminal, which may be closed.
        use_colors=False,
        server_header=False,
        # There is no proxy: a header that names another client is forged.
        proxy_headers=False,
        http=BoundedConnection,
        h11_max_incomplete_event_size=LARGEST_HEAD_BYTES,
        limit_concurrency=MOST_CONNECTIONS,
        ws="websockets-sansio",
        ws_max_size=LARGEST_MESSAGE_BYTES,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=END_WITHIN_S,
    )


class _Server(uvicorn.Server):
    """A server that reports when it listens."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._ready()
