"""The studio in Pyodide, in a worker of the page: values of JavaScript in, values of JavaScript out."""

from __future__ import annotations

import importlib.util
import io
import os
import random
import sys
import zipfile
from contextlib import suppress
from pathlib import Path
from types import ModuleType
from typing import Any

from pyodide.ffi import can_run_sync, create_proxy, run_sync, to_js
from pyodide.http import pyfetch

import kitrobot
from kitrobot.live.background import set_sleep_function
from kitrobot.server.in_page_server import InPageServer, Socket, begin


class WorkerServer:
    """What the worker calls."""

    def __init__(self, studio: InPageServer) -> None:
        self._studio = studio

    async def fetch(self, method: str, address: str, headers: Any, body: Any) -> Any:
        """As `InPageServer.fetch`; the answer is an array: status, headers as pairs, bytes."""
        if address.startswith("/api/board-file"):
            await _fetch_firmware()
        made = await self._studio.fetch(method, address, headers.to_py(), bytes(body.to_py()))
        return to_js([made.status, [list(one) for one in made.headers], made.body])

    def open(self, address: str, heard: Any) -> Any:
        """As `InPageServer.open`."""

        def tell(words: str | bytes | None) -> None:
            heard(to_js(words) if isinstance(words, bytes) else words)

        return create_proxy(WorkerSocket(self._studio.open(address, tell)))


class WorkerSocket:
    """A socket of the studio, as the worker uses it."""

    def __init__(self, socket: Socket) -> None:
        self._socket = socket

    def say(self, words: Any) -> None:
        """As `Socket.say`; bytes come as an array."""
        self._socket.say(words if isinstance(words, str) else bytes(words.to_py()))

    def close(self) -> None:
        """As `Socket.close`."""
        self._socket.close()


async def begin_here(folder: str, in_class: bool) -> WorkerServer:
    """The studio on a folder of this worker's file system; `in_class` as for `begin`."""
    # A browser goes on from a stored memory: what was drawn at random before is the same each time.
    random.seed()
    # Where the browser can put a call to sleep (JSPI).
    set_sleep_function(run_sync if can_run_sync() else None)
    _without_ports()
    return WorkerServer(begin(Path(folder), in_class))


async def _fetch_firmware() -> None:
    """The site has the firmware of boards in a file of its own, which most pages never want.

    Without it the request itself says that it is not there.
    """
    if importlib.util.find_spec("micropython_microbit_fs") is not None:
        return
    with suppress(OSError, zipfile.BadZipFile):
        answer = await pyfetch(os.environ["KITROBOT_SITE"] + "microbit.zip")
        if answer.ok:
            with zipfile.ZipFile(io.BytesIO(await answer.bytes())) as archive:
                archive.extractall(Path(kitrobot.__file__).parent.parent)
        importlib.invalidate_caches()


def _without_ports() -> None:
    """Modules of mpremote import pySerial, which knows no browser; what uses it there is not called."""
    for name in ("serial", "serial.tools", "serial.tools.list_ports"):
        sys.modules[name] = ModuleType(name)
