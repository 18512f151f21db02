"""Links whose other end is out of reach: closing them holds nobody up, and a run keeps its result."""

from __future__ import annotations

import os
import socket
import struct
from collections.abc import Iterator
from contextlib import ExitStack, closing
from threading import Event
from typing import Any

import pytest

from kitrobot.fleet import transport, zenoh_session
from kitrobot.fleet.envelopes import TEAM_PROCESS
from kitrobot.fleet.keys import key_of
from kitrobot.fleet.link_sockets import GIVEN_UP_MS, set_up_links
from kitrobot.fleet.transport import Channel, Network
from kitrobot.workspace.fleets import free_endpoint
from tests.patience import PATIENCE_S

KEY = key_of("a key of sixteen letters", "here")
LINGERS = struct.pack("ii", 1, 10)


def lingers(one: socket.socket) -> bool:
    return bool(struct.unpack("ii", one.getsockopt(socket.SOL_SOCKET, socket.SO_LINGER, 8))[0])


def lingering() -> set[int]:
    """The ports of this process's TCP sockets that wait when they are closed."""
    found = set()
    for name in os.listdir("/dev/fd"):
        try:
            one = socket.socket(fileno=int(name))
        except OSError:
            continue
        try:
            if one.type == socket.SOCK_STREAM and one.family == socket.AF_INET and lingers(one):
                found.add(one.getsockname()[1])
        except OSError:
            pass
        finally:
            one.detach()
    return found


@pytest.fixture
def pair() -> Iterator[tuple[socket.socket, socket.socket]]:
    with ExitStack() as stack:
        listener = stack.enter_context(socket.create_server(("127.0.0.1", 0)))
        one = stack.enter_context(socket.create_connection(listener.getsockname()))
        yield one, stack.enter_context(listener.accept()[0])


def test_a_socket_that_would_wait_when_it_is_closed_waits_no_more_and_others_stay(
    pair: tuple[socket.socket, socket.socket],
) -> None:
    one, other = pair
    one.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, LINGERS)
    assert set_up_links() == 1
    assert not lingers(one)
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        assert one.getsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT) == GIVEN_UP_MS
        assert other.getsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT) == 0
    one.sendall(b"still open")
    assert other.recv(100) == b"still open"
    assert set_up_links() == 0


def test_links_are_set_up_as_soon_as_they_are_there(monkeypatch: pytest.MonkeyPatch) -> None:
    linked = Event()

    def set_up() -> int:
        found = set_up_links()
        if found:
            linked.set()
        return found

    monkeypatch.setattr(transport, "set_up_links", set_up)
    where = free_endpoint()
    with (
        closing(Channel(Network("here", (where,)), TEAM_PROCESS, KEY)) as team,
        closing(Channel(Network("here", ("tcp/127.0.0.1:0",), (where,)), 0, KEY)) as agent,
    ):
        assert linked.wait(PATIENCE_S)
        agent.send(TEAM_PROCESS, 3)
        while not team.receive(1.0):
            pass
        assert lingering() == set()


class Violation:
    """A session that cannot be closed: it waits until it is let go of, and then fails, as Zenoh's does after 10 s."""

    def __init__(self) -> None:
        self.let_go, self.tried = Event(), Event()

    def close(self) -> None:
        self.tried.set()
        self.let_go.wait(PATIENCE_S)
        raise RuntimeError("close operation timed out")


def test_closing_a_channel_neither_waits_for_who_is_out_of_reach_nor_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(zenoh_session, "CLOSED_WITHIN_S", 0.0)
    channel = Channel(Network("here", ("tcp/127.0.0.1:0",)), 0, KEY)
    session: Any = channel._session
    broken: Any = Violation()
    channel._session = broken
    channel.close()
    assert broken.tried.wait(PATIENCE_S)
    broken.let_go.set()
    session.close()
