"""Visits to a static site, which a plain file server hands out under a path."""

from __future__ import annotations

import base64
import re
import threading
import zlib
from dataclasses import dataclass, field
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, Page, expect

from tests.patience import STATE_MS
from tests.studio.studio_page import EXAMPLES, IS_OPEN, Studio

PATH = "/school/kit/"
BLINK = """<kitrobot version="1">
  <program name="blink" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">17</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="blink"/>
  </team>
</kitrobot>
"""
MEMORY = "caches.keys().then((names) => names.filter((name) => name.startsWith('kitrobot memory')).join())"
"""Where the browser keeps Python's memory, or nothing."""


def link(text: str, name: str) -> str:
    """The part of a link behind its `#`, made without the page's own code."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = packer.compress(text.encode()) + packer.flush()
    return f"mission={base64.urlsafe_b64encode(packed).decode().rstrip('=')}&name={name}"


class Files(SimpleHTTPRequestHandler):
    """A file server as Python brings it along: no header of ours, nothing compressed."""

    def __init__(self, *words: Any, gate: threading.Event, **named: Any) -> None:
        self._gate = gate
        super().__init__(*words, **named)

    def do_GET(self) -> None:
        if self.path.endswith(".packed"):
            assert self._gate.wait(STATE_MS / 1000)
        super().do_GET()

    def log_message(self, *_: object) -> None:
        """Says nothing."""


class FileServer:
    """Hands out a folder under PATH."""

    def __init__(self, root: Path) -> None:
        self.folder = root / PATH.strip("/")
        # Nothing of Python is handed out while it is closed.
        self.gate = threading.Event()
        self.gate.set()
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Files, directory=str(root), gate=self.gate))
        self.address = f"http://127.0.0.1:{self._server.server_port}{PATH}"
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    def end(self) -> None:
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


@dataclass
class Visit:
    """A browser that was never here; what its pages said, and what they asked for."""

    context: BrowserContext
    faults: list[str] = field(default_factory=list)
    warned: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.context.set_default_timeout(STATE_MS)
        self.context.on("request", lambda request: self.asked.append(request.url))
        self.context.on("weberror", lambda error: self.faults.append(str(error.error)))
        said = {"error": self.faults, "warning": self.warned}
        self.context.on("console", lambda message: said.get(message.type, []).append(message.text))


def wait_for_python(page: Page) -> None:
    """Waits until the studio of the page is there; in each frame would take half of the time that Python needs."""
    page.wait_for_function(IS_OPEN, polling=300)


def opened(page: Page, address: str) -> Studio:
    page.goto(address)
    wait_for_python(page)
    return Studio(page, Path(), [])


def follow_link(studio: Studio, text: str, name: str) -> None:
    """Opens the mission of a link in a page that is there."""
    studio.page.evaluate("hash => location.hash = hash", link(text, name))
    expect(studio.page).to_have_title(re.compile(name))


def example(name: str) -> str:
    return (EXAMPLES / name / f"{name}.krt").read_text(encoding="utf-8")
