"""The page's end of sockets, as tests of the server hold it."""

from __future__ import annotations

import contextlib
import json
import warnings
from collections.abc import Callable, Iterator
from typing import Any

from pydantic import TypeAdapter

from kitrobot.wire.board import BoardsMessage
from kitrobot.wire.run import RunMessage

with warnings.catch_warnings():
    # It asks for a successor of httpx that is not needed yet.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient as TestClient

TOKEN = "the-right-token"
HOST = "http://127.0.0.1:8765"
SOCKET = "ws://127.0.0.1:8765"
ADDRESS = f"{SOCKET}/api/boards?token={TOKEN}"
RUN_MESSAGE: TypeAdapter[Any] = TypeAdapter(RunMessage)
BOARDS_MESSAGE: TypeAdapter[Any] = TypeAdapter(BoardsMessage)
FOREVER = """<kitrobot version="1">
  <program name="polling" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="While"/>
    <vertex id="v2" element="Run.IsTrue"/>
    <vertex id="v3" element="Wheel.Advance"><set name="speed">5</set></vertex>
    <vertex id="v4" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="v5" element="Wheel.Reverse"><set name="speed">5</set></vertex>
    <vertex id="v6" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v2" to="v1" at="condition"/>
    <arc from="v1" out="body" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v5"/>
    <arc from="v5" to="v6"/>
    <arc from="v6" to="v1" at="return"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="polling"/>
  </team>
</kitrobot>
"""


class Watcher:
    """The page's end of a socket. Every message is held against its published shape."""

    def __init__(self, socket) -> None:
        self.socket = socket
        self.frames: list[bytes] = []

    def send(self, **message) -> None:
        self.socket.send_text(json.dumps(message))

    def next(self) -> dict[str, Any]:
        """The next JSON message; frames before it are kept."""
        while True:
            message = self.socket.receive()
            assert message["type"] == "websocket.send", message
            if message.get("bytes") is not None:
                self.frames.append(message["bytes"])
                continue
            said: dict[str, Any] = json.loads(message["text"])
            RUN_MESSAGE.validate_python(said)
            return said

    def until(self, kind: str, **fields) -> dict[str, Any]:
        """The next message of that type with these fields; those before it are passed over."""
        while True:
            said = self.next()
            if said["type"] == kind and all(said[name] == value for name, value in fields.items()):
                return said
            # Nothing follows them: a test that waits for a start, or for another tick, would wait for ever.
            assert kind != "started" or said["type"] not in ("problems", "error"), said
            assert kind != "tick" or said.get("status", "running") in ("running", "paused"), said

    def start(self, mission, path="", seed=1, speed=0.0) -> dict[str, Any]:
        self.send(type="start", mission=mission, path=path, seed=seed, speed=speed)
        return self.until("started")


class RunPage(Watcher):
    """The page's end of a run of robots."""

    def __init__(self, socket) -> None:
        super().__init__(socket)
        self.begun: dict[str, Any] = {}
        self.agents: dict[str, dict[str, Any]] = {}

    def next(self) -> dict[str, Any]:
        said = super().next()
        if said["type"] == "tick":
            self.agents |= said["agents"]
        return said

    def report(self, wanted: Callable[[dict[str, Any]], bool], name: str = "") -> dict[str, Any]:
        """What a robot does, or the only one, once `wanted` holds."""
        while True:
            told = self.agents.get(name) or next(iter(self.agents.values()), None)
            if told is not None and wanted(told):
                return told
            self.until("tick")

    def restart(self) -> dict[str, Any]:
        """What is said once it runs from its beginning again; watchers are told that and its state in any order."""
        status, first = "", None
        while status != "running" or first is None:
            said = self.next()
            if said["type"] == "state":
                status = said["status"]
            elif said["type"] == "tick" and said["again"]:
                first = said
        return first


class Page:
    """The page's end of a socket. Every message is held against its published shape."""

    def __init__(self, socket, mission, client: TestClient) -> None:
        self.socket = socket
        self.mission = mission
        self.client = client
        self.first = self.next()
        self.you = self.first.get("you", "")

    def send(self, kind: str, address: str, **more) -> None:
        self.socket.send_text(json.dumps({"type": kind, "address": address, **more}))

    def give(self, kind: str, address: str, **more) -> None:
        """A request that brings the mission along."""
        self.send(kind, address, mission=self.mission, path="pulse.krt", program="pulse", **more)

    @contextlib.contextmanager
    def run(self, *addresses: str, **more) -> Iterator[RunPage]:
        """Watches robots that this page holds, as a run; it is on."""
        with self.client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
            page = RunPage(socket)
            request = {"mission": self.mission, "path": "pulse.krt", "holder": self.you, "speed": 1}
            page.send(type="robots", addresses=list(addresses), **request, **more)
            page.begun = page.until("started")
            yield page

    def next(self) -> dict[str, Any]:
        said: dict[str, Any] = json.loads(self.socket.receive_text())
        BOARDS_MESSAGE.validate_python(said)
        return said

    def until(self, kind: str, wanted: Callable[[dict[str, Any]], bool] = lambda said: True) -> dict[str, Any]:
        """The next message of that type for which `wanted` holds; those before it are passed over."""
        while True:
            said = self.next()
            if said["type"] == kind and wanted(said):
                return said

    def board(self, **fields) -> dict[str, Any]:
        """The next message of a robot with these fields."""
        return self.until("board", lambda said: all(said[name] == value for name, value in fields.items()))
