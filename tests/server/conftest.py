"""A studio on a folder of its own, and a client that knows its token."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest

from kitrobot.files.examples import examples_folder
from kitrobot.server.app import create_app
from tests.boards.host import HostBoard, host_board, write_pulse
from tests.server.pages import ADDRESS, FOREVER, HOST, SOCKET, TOKEN, Page, TestClient, Watcher

__all__ = ["HOST", "SHORT", "SOCKET", "TOKEN", "TestClient"]

SHORT = """<kitrobot version="1">
  <program name="blink" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Light.LightOn"/>
    <vertex id="v2" element="Wait"><set name="duration">2</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="v2"/>
    <arc from="v2" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="blink"/>
  </team>
</kitrobot>
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A workspace with one short mission."""
    folder = tmp_path / "missions"
    folder.mkdir()
    (folder / "blink.krt").write_text(SHORT)
    return folder


@pytest.fixture
def transport(folder: Path) -> str:
    """The path, in the workspace, of a copy of the example with carriers."""
    examples = examples_folder()
    assert examples is not None
    shutil.copy(examples / "transport" / "transport.krt", folder / "transport.krt")
    return "transport.krt"


@pytest.fixture
def app(folder: Path, tmp_path: Path):
    """The application, with a page that says which it is."""
    static = tmp_path / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<!doctype html><title>the page</title>")
    (static / "assets" / "page.js").write_text("export {};")
    return create_app(folder, folder / "blink.krt", TOKEN, static=static)


@pytest.fixture
def stranger(app):
    """A client on this machine without the token."""
    return TestClient(app, base_url=HOST)


@pytest.fixture
def page(app):
    """The page: a client with the token."""
    return TestClient(app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN})


@pytest.fixture
def connect(page):
    """Opens a watched socket."""

    @contextmanager
    def connected():
        with page.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
            yield Watcher(socket)

    return connected


@pytest.fixture
def mission(page):
    """The mission of a path of the workspace."""

    def read(path="blink.krt"):
        return page.get("/api/mission", params={"path": path}).json()["mission"]

    return read


@pytest.fixture
def forever(page):
    """A mission that never ends."""
    return page.post("/api/mission/read", content=FOREVER.encode()).json()["mission"]


@pytest.fixture
def visit(app, folder) -> Iterator[Callable[..., Any]]:
    """Opens a page in this studio: on this machine, or on the one of that address."""
    with ExitStack() as stack:
        clients: dict[str, TestClient] = {}

        @contextmanager
        def visit(host: str = "127.0.0.1", language: str = "en", broken: bool = False) -> Iterator[Page]:
            write_pulse(folder, broken)
            if host not in clients:
                made = TestClient(app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN}, client=(host, 50000))
                # One event loop for all pages, as in a server.
                clients[host] = stack.enter_context(made)
            mission = clients[host].get("/api/mission?path=pulse.krt").json()["mission"]
            with clients[host].websocket_connect(f"{ADDRESS}&language={language}") as socket:
                yield Page(socket, mission, clients[host])

        yield visit


@pytest.fixture
def robot(folder) -> Iterator[HostBoard]:
    """A robot on the network with the program `pulse`."""
    write_pulse(folder)
    with host_board(folder / "pulse.krt", "pulse", waits=True) as board:
        yield board
