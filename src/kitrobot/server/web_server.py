"""The web server that the studio runs in: what it bounds, and how it begins and ends."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import uvicorn
from starlette.types import ASGIApp

from kitrobot.live.runs import LARGEST_MESSAGE_BYTES
from kitrobot.server.connections import LARGEST_HEAD_BYTES, MOST_CONNECTIONS, BoundedConnection
from kitrobot.server.garbage_collector import tune_garbage_collector
from kitrobot.server.tls_door import LONGEST_WAIT_S, PlainReply, TlsDoor

END_WITHIN_S = 2
"""How long open connections may take to close after Ctrl-C."""


@dataclass(frozen=True)
class Tls:
    """How a server encrypts: a certificate and its key in PEM, and what is said in plain HTTP."""

    certificate: Path
    key: Path
    greeting: PlainReply


def run_server(
    app: ASGIApp, listening: Sequence[socket.socket], ready: Callable[[], None], tls: Tls | None = None
) -> None:
    """Serves until Ctrl-C, over TLS if `tls` says how; `ready` is called once it listens."""
    tune_garbage_collector()
    server = (
        _Server(server_config(app), ready)
        if tls is None
        else _TlsServer(server_config(app, (tls.certificate, tls.key)), ready, tls.greeting)
    )
    with suppress(KeyboardInterrupt):
        server.run(sockets=list(listening))


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


class _TlsServer(_Server):
    """A server behind a door that tells plain HTTP from TLS."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None], greeting: PlainReply) -> None:
        super().__init__(config, ready)
        self._greeting = greeting
        self._door: TlsDoor | None = None
        self._handshakes: set[asyncio.Task[None]] = set()

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        loop = asyncio.get_running_loop()

        def admit(connection: socket.socket) -> None:
            loop.call_soon_threadsafe(self._admit, connection)

        self._door = TlsDoor(sockets or [], admit, self._greeting)
        self._door.start()
        await super().startup([])

    def _admit(self, connection: socket.socket) -> None:
        task = asyncio.ensure_future(self._encrypt(connection))
        self._handshakes.add(task)
        task.add_done_callback(self._handshakes.discard)

    async def _encrypt(self, connection: socket.socket) -> None:
        """Makes of a connection one that uvicorn knows, as it makes its own."""
        loop, state = asyncio.get_running_loop(), self.lifespan.state
        try:
            await loop.connect_accepted_socket(
                lambda: BoundedConnection(self.config, self.server_state, state, loop),
                connection,
                ssl=self.config.ssl,
                ssl_handshake_timeout=LONGEST_WAIT_S,
            )
        except (OSError, ConnectionError):
            connection.close()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        if self._door is not None:
            self._door.close()
        for task in self._handshakes:
            task.cancel()
        await super().shutdown(sockets)
