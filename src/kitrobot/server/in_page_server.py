"""The studio without a network: requests and sockets come as calls, as a page makes them of the Python that runs in it.

The application is the one that a web server serves, with the same shell around it; calls bring along what a browser
would: the host's name and the token. Left to others: the browser (`in_worker`), keeping files.
"""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from starlette.types import ASGIApp, Message

from kitrobot.files.examples import first_example
from kitrobot.live.background import disable_threads
from kitrobot.server.app import create_app
from kitrobot.server.garbage_collector import tune_garbage_collector
from kitrobot.server.security import TOKEN_HEADER

HOST = "127.0.0.1"
_NORMAL, _GONE = 1000, 1006

MessageHandler = Callable[[str | bytes | None], None]
"""Receives each message of the studio, and None when the socket is closed."""


@dataclass(frozen=True)
class PageResponse:
    """What came of a request."""

    status: int
    headers: tuple[tuple[str, str], ...]
    body: bytes


class InPageServer:
    """A studio that is called. `token` is what every request must bring along."""

    def __init__(self, app: ASGIApp, token: str) -> None:
        self._app = app
        self._token = token
        self._sockets: set[asyncio.Task[None]] = set()

    async def fetch(self, method: str, address: str, headers: Mapping[str, str], body: bytes = b"") -> PageResponse:
        """Asks: `address` is a path with its query. Whatever breaks is an answer too."""
        scope = self._scope("http", address, headers) | {"method": method, "scheme": "http"}
        status, sent, pieces = 500, (), bytearray()  # type: tuple[int, tuple[tuple[str, str], ...], bytearray]
        asked = [{"type": "http.request", "body": body, "more_body": False}]

        async def receive() -> Message:
            if asked:
                return asked.pop()
            # Nobody hangs up before the answer.
            return await asyncio.get_running_loop().create_future()  # type: ignore[no-any-return]

        async def send(message: Message) -> None:
            nonlocal status, sent
            if message["type"] == "http.response.start":
                status = message["status"]
                sent = tuple((name.decode("latin-1"), value.decode("latin-1")) for name, value in message["headers"])
            else:
                pieces.extend(message.get("body", b""))

        await self._app(scope, receive, send)
        return PageResponse(status, sent, bytes(pieces))

    def open(self, address: str, handler: MessageHandler) -> Socket:
        """Opens a socket; `address` as for `fetch`."""
        socket = Socket(handler)
        scope = self._scope("websocket", address, {}) | {"scheme": "ws", "subprotocols": []}
        task = asyncio.create_task(self._serve(scope, socket))
        self._sockets.add(task)
        task.add_done_callback(self._sockets.discard)
        return socket

    async def _serve(self, scope: dict[str, Any], socket: Socket) -> None:
        try:
            await self._app(scope, socket.receive, socket.send)
        finally:
            socket.end()

    def _scope(self, kind: str, address: str, headers: Mapping[str, str]) -> dict[str, Any]:
        place = urlsplit(address)
        brought = {name.lower(): value for name, value in headers.items()}
        brought |= {"host": HOST, TOKEN_HEADER: self._token}
        return {
            "type": kind,
            "asgi": {"version": "3.0", "spec_version": "2.4"},
            "http_version": "1.1",
            "path": unquote(place.path),
            "raw_path": place.path.encode(),
            "query_string": place.query.encode(),
            "root_path": "",
            "headers": [(name.encode("latin-1"), value.encode("latin-1")) for name, value in brought.items()],
            "server": (HOST, 80),
            "client": None,
        }


class Socket:
    """The page's end of a socket."""

    def __init__(self, handler: MessageHandler) -> None:
        self._handler: MessageHandler | None = handler
        self._said: asyncio.Queue[Message] = asyncio.Queue()
        self._said.put_nowait({"type": "websocket.connect"})

    def say(self, words: str | bytes) -> None:
        """Sends the studio a message."""
        kind = "text" if isinstance(words, str) else "bytes"
        self._said.put_nowait({"type": "websocket.receive", kind: words})

    def close(self) -> None:
        """Hangs up."""
        self._handler = None
        self._said.put_nowait({"type": "websocket.disconnect", "code": _NORMAL})

    def end(self) -> None:
        """The studio has hung up."""
        handler, self._handler = self._handler, None
        if handler is not None:
            handler(None)

    async def receive(self) -> Message:
        """The next message for the application."""
        return await self._said.get()

    async def send(self, message: Message) -> None:
        """Takes a message of the application.

        Raises:
            OSError: the socket is closed.
        """
        if message["type"] == "websocket.close":
            self.end()
        elif message["type"] == "websocket.send":
            if self._handler is None:
                raise OSError("the page hung up")
            text = message.get("text")
            self._handler(text if text is not None else message["bytes"])


def begin(folder: Path, in_class: bool = False) -> InPageServer:
    """A studio on a folder, which is made, in a process that has neither threads nor other processes.

    In a class it begins without a mission: the class chooses one.
    """
    disable_threads()
    folder.mkdir(parents=True, exist_ok=True)
    token = secrets.token_urlsafe(24)
    app = create_app(folder, None if in_class else first_example(), token)
    app.state.studio.folder.in_class = in_class
    app.state.studio.in_page = app.state.studio.boards.in_page = True
    with suppress(OSError):
        app.state.studio.folder.sweep()
    tune_garbage_collector()
    return InPageServer(app, token)
