"""Starting the studio: a port, a token, the address on standard output, the browser, and a clean end."""

from __future__ import annotations

import gc
import ipaddress
import os
import secrets
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import uvicorn
from fastapi import FastAPI

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.app import create_app
from kitrobot.server.runs import LARGEST_MESSAGE_BYTES
from kitrobot.workspace import first_example

USUAL_PORT = 8765
"""Always the same where it is free: what the page remembers belongs to its address."""
MORE_PORTS = 10
END_WITHIN_S = 2
"""How long open connections may take to close after Ctrl-C."""


class ServerError(KitRobotError):
    """The studio cannot listen there."""


@dataclass(frozen=True)
class Place:
    """The folder that missions are in, and the mission to begin with."""

    workspace: Path
    mission: Path | None


def serve(target: Path | None, host: str = "127.0.0.1", port: int | None = None, browser: bool = True) -> None:
    """Serves the studio until Ctrl-C.

    Args:
        target: a mission's file, a folder of missions, or None for the first example.
        host: an address of this machine that only it can reach.
        port: the port; 0 is any free one, None the usual one or one near it.
        browser: whether to open the address in the browser.

    Raises:
        ServerError: the address is not this machine's alone, or the port is taken.
    """
    place = _place(target)
    listening = _listen(_loopback(host), port)
    token = secrets.token_urlsafe(24)
    address = f"http://{_name(host)}:{listening.getsockname()[1]}/?token={token}"
    app = create_app(place.workspace, place.mission, token)
    config = server_config(app)

    _calm_collector()

    def ready() -> None:
        threading.Thread(target=app.state.studio.folder.sweep, daemon=True).start()
        print(address, flush=True)
        print("Ctrl-C ends the studio.", file=sys.stderr, flush=True)
        if browser and _has_screen():
            # A browser that is slow to start must not keep the server waiting.
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()

    try:
        _Server(config, ready).run(sockets=[listening])
    except KeyboardInterrupt:
        pass
    finally:
        listening.close()


def server_config(app: FastAPI) -> uvicorn.Config:
    """How the studio is served. Nothing is compressed on a WebSocket: to the same machine that only costs time."""
    return uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        server_header=False,
        ws="websockets-sansio",
        ws_max_size=LARGEST_MESSAGE_BYTES,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=END_WITHIN_S,
    )


def _calm_collector() -> None:
    """Has Python's garbage collector look at everything less often, and never at what is there now.

    Hardly anything here is garbage that counting references does not find, and a look at a large mission's programs
    takes longer than the answer that it delays.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)


class _Server(uvicorn.Server):
    """A server that says when it listens."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._ready()


def _place(target: Path | None) -> Place:
    if target is None:
        return Place(Path.cwd(), first_example())
    if target.is_dir():
        return Place(target, None)
    mission = target.resolve()
    return Place(mission.parent, mission)


def _loopback(host: str) -> str:
    """The address to bind to.

    Raises:
        ServerError: it is not one that only this machine reaches.
    """
    address = "127.0.0.1" if host == "localhost" else host.strip("[]")
    try:
        if ipaddress.ip_address(address).is_loopback:
            return address
    except ValueError:
        pass
    raise ServerError(
        f"the studio does not listen on `{host}`",
        "it is for the people at this machine: use 127.0.0.1, ::1 or localhost",
    )


def _name(host: str) -> str:
    return f"[{host.strip('[]')}]" if ":" in host else host


def _listen(address: str, port: int | None) -> socket.socket:
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    wanted = [port] if port is not None else [*range(USUAL_PORT, USUAL_PORT + MORE_PORTS), 0]
    reason = ""
    for number in wanted:
        listening = socket.socket(family, socket.SOCK_STREAM)
        if os.name != "nt":  # there it would let two servers share a port
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listening.bind((address, number))
            listening.listen(128)
            return listening
        except OSError as error:
            listening.close()
            reason = (error.strerror or str(error)).lower()
    raise ServerError(
        f"the studio cannot listen on port {wanted[0]} of {address}: {reason}",
        "choose another port with --port, or leave the option out",
    )


def _has_screen() -> bool:
    """Whether a browser can open a window; one that lives in the terminal would take the terminal over."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "WSL_DISTRO_NAME", "BROWSER"))
