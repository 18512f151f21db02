"""A line over a connection (`socket://`): read in whole pieces, broken when the other end goes, closed at once."""

from __future__ import annotations

import socket
from collections.abc import Iterator

import pytest
from serial.urlhandler import protocol_socket

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.line.line import Line
from tests.patience import PATIENCE_S


@pytest.fixture
def ends() -> Iterator[tuple[Line, socket.socket]]:
    """A line, and what is at its other end."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        line = Line(f"socket://127.0.0.1:{listener.getsockname()[1]}")
        other, _ = listener.accept()
        with other:
            yield line, other
        line.close()


def test_what_came_together_is_read_at_once(ends: tuple[Line, socket.socket]) -> None:
    line, other = ends
    assert line.read(0) == b""
    other.sendall(b"together")
    assert line.read(PATIENCE_S) == b"together"


def test_a_line_whose_other_end_goes_is_broken(ends: tuple[Line, socket.socket]) -> None:
    line, other = ends
    other.sendall(b"bye")
    other.close()
    assert line.read(PATIENCE_S) == b"bye"
    with pytest.raises(LineError, match="broke"):
        line.read(PATIENCE_S)


def test_nobody_waits_after_a_line_that_is_closed_not_even_when_it_is_collected(
    ends: tuple[Line, socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    waited: list[float] = []
    monkeypatch.setattr(protocol_socket.time, "sleep", waited.append)
    line, other = ends
    port = line.port
    line.close()
    assert other.recv(1) == b""
    port.__del__()  # what collecting it does
    assert waited == []
