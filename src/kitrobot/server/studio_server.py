"""Starting the studio: a port, a token, the address on standard output, the browser, and a clean end."""

from __future__ import annotations

import os
import secrets
import socket
import sys
import threading
import webbrowser
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlencode

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.examples import first_example
from kitrobot.files.folder import MissionFolder
from kitrobot.server.hosts import host_number, is_loopback
from kitrobot.server.presence import Presence, StudioInfo
from kitrobot.text.collection import collection_paused
from kitrobot.text.sentences import Sentence

USUAL_PORT = 8765
"""Always the same where it is free: what the page remembers belongs to its address."""
MORE_PORTS = 10


class ServerError(KitRobotError):
    """The studio cannot listen there."""


@dataclass(frozen=True)
class StudioLocation:
    """The folder of the missions, and the mission to open first."""

    workspace: Path
    mission: Path | None


def serve(
    target: Path | None, host: str = "127.0.0.1", port: int | None = None, browser: bool = True, new: bool = False
) -> None:
    """Serves the studio until Ctrl-C; where one of the folder runs already, opens a page of that and comes back.

    Args:
        target: a mission's file, a folder of missions, or None for the first example.
        host: an address of this machine that only it can reach.
        port: the port; 0 is any free one, None the usual one or one near it. The folder's last one goes before both.
        browser: whether to open the address in the browser.
        new: whether to start a second studio where one of the folder runs.

    Raises:
        ServerError: the address is not this machine's alone, or the port is taken.
        PresenceError: the folder's studio does not answer.
    """
    place = _place(target)
    bound = _loopback(host)
    presence = Presence(place.workspace)
    if new:
        presence.acquire()
    elif (running := presence.acquire_or_find()) is not None:
        _open_running_studio(presence, running, place, browser)
        return
    try:
        _serve(place, presence, bound, port, browser)
    finally:
        presence.leave()


def _open_running_studio(presence: Presence, running: StudioInfo, place: StudioLocation, browser: bool) -> None:
    """Opens another page of a studio that runs."""
    wanted = MissionFolder(place.workspace).name_of(place.mission) if place.mission is not None else ""
    address = f"{running.address}?{urlencode({'token': running.token, 'open': wanted})}"
    print_address(address)
    print(
        "The studio of this folder runs already: this is another page of it. --new starts a second one.",
        file=sys.stderr,
        flush=True,
    )
    if browser and has_screen():
        _open_browser(presence, address)


def _serve(place: StudioLocation, presence: Presence, bound: str, port: int | None, browser: bool) -> None:
    listening = listen(bound, port, presence.port)
    # Only now: where the studio is not served, nobody waits for the web server to load.
    with collection_paused():
        from kitrobot.server.app import create_app
        from kitrobot.server.web_server import run_server

    number = listening.getsockname()[1]
    running = StudioInfo(f"http://{_name(bound)}:{number}/", secrets.token_urlsafe(24))
    address = f"{running.address}?token={running.token}"
    app = create_app(place.workspace, place.mission, running.token, secret=presence.secret)

    def ready() -> None:
        presence.publish(running, number)
        threading.Thread(target=app.state.studio.folder.sweep, daemon=True).start()
        print_address(address)
        print("Ctrl-C ends the studio.", file=sys.stderr, flush=True)
        if browser and has_screen():
            # A browser that is slow to start must not keep the server waiting.
            threading.Thread(target=_open_browser, args=(presence, address), daemon=True).start()

    try:
        run_server(app, [listening], ready)
    finally:
        app.state.studio.boards.team.end()
        listening.close()


def print_address(address: str) -> None:
    """Prints the server's address on standard output; it serves even if that fails."""
    with suppress(OSError):
        print(address, flush=True)


def _open_browser(presence: Presence, address: str) -> None:
    """Opens the browser, without the token in its command line: other users of this machine can read that."""
    page = presence.write_redirect_page(address)
    if page is not None:
        webbrowser.open(page.as_uri())


def _place(target: Path | None) -> StudioLocation:
    if target is None:
        return StudioLocation(Path.cwd(), first_example())
    if target.is_dir():
        return StudioLocation(target, None)
    mission = target.resolve()
    return StudioLocation(mission.parent, mission)


def _loopback(host: str) -> str:
    """The address to bind to.

    Raises:
        ServerError: it is not one that only this machine reaches.
    """
    if is_loopback(host):
        return host_number(host)
    raise ServerError(
        Sentence("the studio does not listen on `{host}`", host),
        Sentence("it is for the people at this machine: use 127.0.0.1, ::1 or localhost"),
    )


def _name(host: str) -> str:
    return f"[{host.strip('[]')}]" if ":" in host else host


def listen(address: str, port: int | None, last: int | None = None) -> socket.socket:
    """A socket that listens: on the port, or, where none is named, on the last one if it is free."""
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    wanted = [*range(USUAL_PORT, USUAL_PORT + MORE_PORTS), 0] if port is None else [port]
    if last is not None and not port:
        wanted.insert(0, last)
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
        Sentence("the studio cannot listen on port {wanted} of {address}: {reason}", wanted[0], address, reason),
        Sentence("choose another port with --port, or leave the option out"),
    )


def has_screen() -> bool:
    """Whether a browser can open a window; one that lives in the terminal would take the terminal over."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "WSL_DISTRO_NAME", "BROWSER"))
