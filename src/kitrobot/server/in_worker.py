"""The studio in Pyodide, in a worker of the page: values of JavaScript in, values of JavaScript out."""

from __future__ import annotations

import asyncio
import random
from pathlib import Path
from typing import Any

from pyodide.ffi import can_run_sync, create_proxy, run_sync, to_js

from kitrobot.server.beside_loop import breathe_with
from kitrobot.server.in_page import InPage, Socket, begin


class InWorker:
    """What the worker calls."""

    def __init__(self, studio: InPage) -> None:
        self._studio = studio

    async def fetch(self, method: str, address: str, headers: Any, body: Any) -> Any:
        """As `InPage.fetch`; the answer is an array: status, headers as pairs, bytes."""
        made = await self._studio.fetch(method, address, headers.to_py(), bytes(body.to_py()))
        return to_js([made.status, [list(one) for one in made.headers], made.body])

    def open(self, address: str, heard: Any) -> Any:
        """As `InPage.open`."""

        def tell(words: str | bytes | None) -> None:
            heard(to_js(words) if isinstance(words, bytes) else words)

        socket: Socket = self._studio.open(address, tell)
        return create_proxy(socket)


def begin_here(folder: str) -> InWorker:
    """The studio on a folder of this worker's file system."""
    # A browser goes on from a memory that it kept: what was drawn at random before is the same each time.
    random.seed()
    breathe_with(_breathe)
    return InWorker(begin(Path(folder)))


def _breathe() -> None:
    # Where the browser can put a call to sleep (JSPI).
    if can_run_sync():
        run_sync(asyncio.sleep(0))
