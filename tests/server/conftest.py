"""A studio on a folder of its own, and a client that knows its token."""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path

import pytest

with warnings.catch_warnings():
    # It asks for a successor of httpx that is not needed yet.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

from kitrobot.files.examples import examples_folder
from kitrobot.server.app import create_app

__all__ = ["HOST", "SHORT", "SOCKET", "TOKEN", "TestClient"]

TOKEN = "the-right-token"
HOST = "http://127.0.0.1:8765"
SOCKET = "ws://127.0.0.1:8765"
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
