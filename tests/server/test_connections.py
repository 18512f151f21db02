"""Connections that ask nothing, or never come to the end of asking, are closed; large heads are refused."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
import uvicorn
from websockets.sync.client import connect
from websockets.typing import Origin

from kitrobot.server import connections, web_server
from kitrobot.server.app import create_app
from kitrobot.server.connections import LARGEST_HEAD_BYTES, BoundedConnection
from tests.patience import PATIENCE_S
from tests.server.conftest import SHORT, TOKEN


@pytest.fixture
def port(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """The port of a studio that waits for requests only for a moment."""
    monkeypatch.setattr(BoundedConnection, "whole_within_s", 0.2)
    with serving_studio(tmp_path) as port:
        yield port


@contextlib.contextmanager
def serving_studio(folder: Path) -> Iterator[int]:
    """The port of a studio."""
    (folder / "blink.krt").write_text(SHORT)
    listening = socket.create_server(("127.0.0.1", 0), backlog=200)
    server = uvicorn.Server(web_server.server_config(create_app(folder, folder / "blink.krt", TOKEN)))
    thread = threading.Thread(target=lambda: asyncio.run(server.serve([listening])))
    thread.start()
    yield listening.getsockname()[1]
    server.should_exit = True
    thread.join(PATIENCE_S)


def head(port: int, path: str = "/api/missions", more: str = "") -> bytes:
    return f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nX-KitRobot-Token: {TOKEN}\r\n{more}".encode()


POST = "Content-Type: application/json\r\nContent-Length: 100\r\n\r\n{"


@pytest.mark.parametrize("said", ["", "GET", "head", "body", "second"])
def test_who_never_asks_to_the_end_is_let_go(port: int, said: str) -> None:
    with socket.create_connection(("127.0.0.1", port), PATIENCE_S) as line:
        if said == "body":
            line.sendall(head(port, more=POST).replace(b"GET /api/missions", b"POST /api/text"))
        elif said == "second":
            line.sendall(head(port, more="\r\n") + b"GET /api")
        else:
            line.sendall(head(port) if said == "head" else said.encode())
        got = b""
        while data := line.recv(65536):
            got += data
        assert got.startswith(b"HTTP/1.1 200" if said == "second" else b"")


def test_a_head_that_is_too_large_is_refused(port: int) -> None:
    with socket.create_connection(("127.0.0.1", port), PATIENCE_S) as line:
        line.sendall(head(port, more=f"X-Much: {'x' * LARGEST_HEAD_BYTES}\r\n"))
        assert line.recv(65536).startswith(b"HTTP/1.1 400")


@pytest.mark.parametrize("said", ["", "GET", "body", "kept alive"])
def test_connections_that_say_nothing_make_room_for_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: str
) -> None:
    monkeypatch.setattr(connections, "MOST_BEFORE_ROOM_IS_MADE", 10)
    monkeypatch.setattr(web_server, "MOST_CONNECTIONS", 20)
    with serving_studio(tmp_path) as port, contextlib.ExitStack() as lines:
        for _ in range(60):
            line = lines.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE_S))
            if said == "body":
                line.sendall(head(port, more=POST).replace(b"GET /api/missions", b"POST /api/text"))
            elif said == "kept alive":
                line.sendall(head(port, "/api/session", more="\r\n"))
                assert line.recv(65536).startswith(b"HTTP/1.1 200")
            else:
                line.sendall(said.encode())
        last = lines.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE_S))
        last.sendall(head(port, more="\r\n"))
        assert last.recv(65536).startswith(b"HTTP/1.1 200")


def test_a_socket_that_says_nothing_stays_open(port: int) -> None:
    address = f"ws://127.0.0.1:{port}/api/run?token={TOKEN}"
    with connect(address, origin=Origin(f"http://127.0.0.1:{port}"), proxy=None, open_timeout=PATIENCE_S) as line:
        with pytest.raises(TimeoutError):
            line.recv(1)
        assert line.ping().wait(PATIENCE_S)
