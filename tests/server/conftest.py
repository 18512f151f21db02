"""A studio on a folder of its own, and a client that knows its token."""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path
from typing import Any

import pytest

with warnings.catch_warnings():
    # It asks for a successor of httpx that is not needed yet.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

from kitrobot.files.examples import examples_folder
from kitrobot.server.app import create_app

__all__ = ["HOST", "SHORT", "SOCKET", "TOKEN", "TestClient", "whole", "whole_report"]

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


def whole(before: dict[str, Any], rows: dict[str, Any]) -> dict[str, Any]:
    """The program that rows say, as the page puts it together."""
    made = {
        part: [one for row in rows[part] for one in (before[part][slice(*row)] if isinstance(row, list) else [row])]
        for part in ("vertices", "arcs")
    }
    return before | made


def whole_report(told: dict[str, Any], known: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """A report, whole, as the page puts it together; `known`: programs of earlier ones by name, and then these."""
    programs = [_whole_program(one, known[one["of"]]) if "of" in one else one for one in told["programs"]]
    known.update({one["known"]: one for one in programs})
    return told | {"programs": programs}


def _whole_program(told: dict[str, Any], before: dict[str, Any]) -> dict[str, Any]:
    spans: list[dict[str, Any]] = []
    for row in told["spans"]:
        if "vertex" in row:
            spans.append(row)
            continue
        by = {"start": row["characters"], "end": row["characters"], "line": row["lines"]}
        stretch = before["spans"][row["start"] : row["end"]]
        spans += [one | {name: one[name] + more for name, more in by.items()} for one in stretch]
    at, text = told["at"], before["lll"]
    lll = text[:at] + told["inserted"] + text[at + told["removed"] :]
    plain = {name: told[name] for name in ("name", "instructions", "known")}
    return {**plain, "lll": lll, "spans": spans}


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
