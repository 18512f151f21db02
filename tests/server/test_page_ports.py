"""Ports that a page has opened: whose they are, what travels, and what is cut off, floods or comes from another."""

from __future__ import annotations

import json
import secrets
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

import pytest
from starlette.websockets import WebSocketDisconnect

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.line.line import Line
from kitrobot.live.page_ports import MOST_WAITING
from kitrobot.server.routes.page_port import MOST_PIECE
from tests.patience import PATIENCE_S
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient

BOARDS = f"{SOCKET}/api/boards?token={TOKEN}"
MICROBIT = 0x0D28


class Visitor:
    """A page: its socket of robots, and the ports that it opens."""

    def __init__(self, client: TestClient, socket: Any) -> None:
        self.client, self.socket = client, socket
        self.key = self.next()["key"]

    def next(self) -> dict[str, Any]:
        return dict(json.loads(self.socket.receive_text()))

    def until(self, kind: str) -> dict[str, Any]:
        while (said := self.next())["type"] != kind:
            pass
        return said

    def ports(self, count: int) -> list[dict[str, Any]]:
        """The list of ports at this page, once there are so many."""
        while True:
            found = [one for one in self.until("ports")["ports"] if one["address"].startswith("page:")]
            if len(found) == count:
                return found

    def look(self) -> None:
        self.socket.send_text('{"type": "look", "on": true}')

    @contextmanager
    def port(self, mark: str = "", key: str | None = None) -> Iterator[Any]:
        words = {"key": self.key if key is None else key, "mark": mark or secrets.token_hex(16), "vendor": MICROBIT}
        query = "&".join(f"{name}={value}" for name, value in words.items())
        with self.client.websocket_connect(f"{SOCKET}/api/boards/port?token={TOKEN}&{query}") as socket:
            yield socket


@pytest.fixture
def visit(app, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[], Any]]:
    monkeypatch.setenv("KITROBOT_BOARDS", "")
    with TestClient(app, base_url=HOST, client=("127.0.0.1", 50000)) as client:

        @contextmanager
        def visit() -> Iterator[Visitor]:
            with client.websocket_connect(BOARDS) as socket:
                yield Visitor(client, socket)

        yield visit


@pytest.fixture
def robot() -> Iterator[Callable[..., Future[Any]]]:
    """Does something in a robot's thread."""
    with ThreadPoolExecutor(1) as pool:
        yield pool.submit


def opened(port: Any, address: str, robot: Callable[..., Future[Line]]) -> Line:
    """The line over that port, which the page opens when it is asked to."""
    line = robot(Line, address)
    assert port.receive_text() == "open"
    port.send_text("opened")
    return line.result(PATIENCE_S)


def refused(socket: Any) -> int:
    """With what the server hangs up."""
    with pytest.raises(WebSocketDisconnect) as told:
        socket.receive_text()
    return int(told.value.code)


def test_bytes_travel_both_ways_and_the_port_is_closed_with_the_line(visit, robot) -> None:
    with visit() as page, page.port() as port:
        page.look()
        [listed] = page.ports(1)
        assert (listed["name"], listed["firmware"]) == ("micro:bit", "https://python.microbit.org/")
        # What came before anybody listened is of an earlier program.
        port.send_bytes(b"old")
        line = opened(port, listed["address"], robot)
        assert line.address == "micro:bit"
        port.send_bytes(b"\x00new")
        assert robot(line.read_until, b"new", PATIENCE_S).result(PATIENCE_S) == b"\x00new"
        robot(line.write, b"\x03\xff")
        assert port.receive_bytes() == b"\x03\xff"
        robot(line.close).result(PATIENCE_S)
        assert port.receive_text() == "close"
        again = opened(port, listed["address"], robot)
        assert again.waiting() == 0
        with pytest.raises(LineError, match="in use already"):
            Line(listed["address"])
        # The one that has it keeps it.
        robot(again.write, b"!")
        assert port.receive_bytes() == b"!"


def test_a_port_is_seen_and_used_by_its_page_alone(visit) -> None:
    with visit() as one, visit() as other, one.port() as port:
        one.look()
        [listed] = one.ports(1)
        other.look()
        assert other.ports(0) == []
        other.socket.send_text(
            json.dumps({"type": "connect", "address": listed["address"], "mission": {}, "path": "", "program": ""})
        )
        assert other.until("refused")["address"] in ("", listed["address"])
        with other.port(listed["address"].removeprefix("page:")) as same:
            assert refused(same) == 1008
        # It was never opened for anybody.
        port.send_text("gone")
        assert one.ports(0) == []


@pytest.mark.parametrize("words", [{"key": ""}, {"key": "wrong"}, {"key": "%D0%BA"}, {"mark": "../x"}, {"mark": "0"}])
def test_nobody_has_a_port_without_the_key_of_a_page(visit, words) -> None:
    with visit() as page:
        # It is refused before it is accepted where the words are no mark, else at once.
        with pytest.raises(WebSocketDisconnect) as told, page.port(**words) as port:
            port.receive_text()
        assert told.value.code == 1008
        page.look()
        assert page.ports(0) == []


def test_without_the_token_of_the_studio_nothing_is_opened(app) -> None:
    stranger = TestClient(app, base_url=HOST)
    for query in ("", "?token=wrong", "?key=x"):
        with (
            pytest.raises(WebSocketDisconnect),
            stranger.websocket_connect(f"{SOCKET}/api/boards/port{query}"),
        ):
            pass
    with (
        pytest.raises(WebSocketDisconnect),
        stranger.websocket_connect(
            f"{SOCKET}/api/boards/port?token={TOKEN}", headers={"Origin": "http://evil.example"}
        ),
    ):
        pass


@pytest.mark.parametrize("way", ["gone", "hung up", "page left"])
def test_a_line_breaks_with_a_sentence_when_the_cable_the_tab_or_the_page_goes(visit, robot, way: str) -> None:
    with visit() as page, page.port() as port:
        page.look()
        [listed] = page.ports(1)
        line = opened(port, listed["address"], robot)
        reading = robot(line.read, PATIENCE_S)
        if way == "gone":
            port.send_text("gone")
        elif way == "hung up":
            port.close()
        else:
            page.socket.close()
        with pytest.raises(LineError) as told:
            reading.result(PATIENCE_S)
        assert "`micro:bit` is not connected to this page any more" in str(told.value)
        with pytest.raises(LineError):
            line.write(b"late")
        line.close()
        with pytest.raises(LineError, match="not connected to a page any more"):
            Line(listed["address"])


@pytest.mark.parametrize(
    ("word", "said"), [("busy", "another program or tab has it"), ("failed", "the browser cannot open `micro:bit`")]
)
def test_a_port_that_the_browser_does_not_open_is_told_and_can_be_tried_again(visit, robot, word, said) -> None:
    with visit() as page, page.port() as port:
        page.look()
        [listed] = page.ports(1)
        line = robot(Line, listed["address"])
        assert port.receive_text() == "open"
        port.send_text(word)
        with pytest.raises(LineError, match=said):
            line.result(PATIENCE_S)
        assert port.receive_text() == "close"
        assert opened(port, listed["address"], robot).waiting() == 0


def test_a_board_that_floods_is_not_taken_in_faster_than_it_is_read_and_odd_words_do_nothing(visit, robot) -> None:
    pieces = 4 * MOST_WAITING // MOST_PIECE
    with visit() as page, page.port() as port:
        page.look()
        [listed] = page.ports(1)
        line = opened(port, listed["address"], robot)
        for word in ("", "open", "opened", "{}", "x" * 100_000):
            port.send_text(word)
        for _ in range(pieces):
            port.send_bytes(bytes(MOST_PIECE))
        port.send_bytes(b"end")
        got = 0
        most = 0
        while got < pieces * MOST_PIECE + 3:
            most = max(most, line.waiting())
            got += len(robot(line.read, PATIENCE_S).result(PATIENCE_S))
        assert most <= MOST_WAITING + MOST_PIECE
        port.send_bytes(bytes(MOST_PIECE + 1))
        assert refused(port) == 1009


def test_a_page_has_no_more_ports_than_robots(visit, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kitrobot.live.robot_subscriber.MOST_BOARDS", 1)
    with visit() as page, page.port() as first, page.port() as second:
        assert refused(second) == 1008
        page.look()
        page.ports(1)
        first.send_text("gone")
        page.ports(0)
