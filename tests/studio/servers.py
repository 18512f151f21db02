"""The studios of a worker's tests, served by one thread at a few addresses."""

from __future__ import annotations

import asyncio
import secrets
import socket
import threading
from dataclasses import dataclass
from pathlib import Path

import uvicorn
from fastapi import FastAPI
from starlette.types import Receive, Scope, Send

from kitrobot.server.app import create_app
from kitrobot.server.web_server import server_config
from tests.patience import PATIENCE_S
from tests.studio.tabs import NOTHING


async def answer_nothing(send: Send) -> None:
    """An empty page."""
    headers = [(b"content-type", b"text/html"), (b"cache-control", b"no-store")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b'<link rel="icon" href="data:,">'})


class Slot:
    """One address, at which the studios of a worker's tests are served one after another.

    The same address lets the browser keep what it has compiled of the page.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.app: FastAPI | None = None
        listening = socket.create_server(("127.0.0.1", 0))
        self.address = f"http://127.0.0.1:{listening.getsockname()[1]}"
        self._server = uvicorn.Server(server_config(self))
        self._ended = asyncio.run_coroutine_threadsafe(self._server.serve([listening]), loop)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope.get("path") == NOTHING:
            await answer_nothing(send)
            return
        assert self.app is not None, "a request to a studio whose test has ended"
        await self.app(scope, receive, send)

    def close(self) -> None:
        self._server.should_exit = True
        self._ended.result(PATIENCE_S)


class ServerThread:
    """One event loop on a thread, which serves the studios of a worker's tests.

    What only a process shows (a kill, a restart, its first line) has tests with processes: test_journal.py.
    """

    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="studios", daemon=True)
        self._thread.start()
        self._slots: list[Slot] = []

    def serve(self, target: Path) -> ServedStudio:
        """Serves the studio on a mission's file or a folder, as `kitrobot studio` does."""
        token = secrets.token_urlsafe(24)
        folder, mission = (target, None) if target.is_dir() else (target.parent, target)
        slot = next((slot for slot in self._slots if slot.app is None), None)
        if slot is None:
            slot = Slot(self._loop)
            self._slots.append(slot)
        slot.app = create_app(folder, mission, token)
        return ServedStudio(f"{slot.address}/?token={token}", slot)

    def close(self) -> None:
        for slot in self._slots:
            slot.close()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(PATIENCE_S)


@dataclass(frozen=True)
class ServedStudio:
    """A studio that is being served."""

    address: str
    slot: Slot

    def close(self) -> None:
        self.slot.app = None
