"""A fail sweep over its WebSocket; and that a field of its map, played as a run, ends as the map says."""

from __future__ import annotations

import contextlib
import json
from typing import Any

import pytest
from pydantic import TypeAdapter

from kitrobot.server.routes import sweep as sweep_socket
from kitrobot.wire.sweep import SweepMessage
from tests.server.conftest import SOCKET, TOKEN

# The fixtures are those of test_run.
MESSAGE: TypeAdapter[Any] = TypeAdapter(SweepMessage)


class Sweeper:
    """The page's end of a socket. Every message is held against its published shape."""

    def __init__(self, socket) -> None:
        self.socket = socket

    def send(self, **message) -> None:
        self.socket.send_text(json.dumps(message))

    def start(self, mission, moments=1, seconds=600.0) -> None:
        self.send(type="start", mission=mission, path="", seed=1, moments=moments, seconds=seconds)

    def until(self, *kinds: str) -> dict[str, Any]:
        while True:
            said: dict[str, Any] = json.loads(self.socket.receive_text())
            MESSAGE.validate_python(said)
            if said["type"] in kinds:
                return said
            assert said["type"] == "progress", said


@pytest.fixture
def sweeping(page):
    """Opens a socket for sweep_socket."""

    @contextlib.contextmanager
    def connected(language="en"):
        with page.websocket_connect(f"{SOCKET}/api/sweep?language={language}&token={TOKEN}") as socket:
            yield Sweeper(socket)

    return connected


def played(connect, mission, agent: str, at_s: float, seconds: float) -> tuple[str, float, str]:
    """How the run ends in which that agent fails then."""
    failures = [*mission.get("failures", ()), {"agent": agent, "at_s": at_s, "kind": "fail"}]
    with connect() as watcher:
        watcher.send(type="start", mission={**mission, "failures": failures}, path="", seed=1, speed=0, seconds=seconds)
        watcher.until("started")
        while (said := watcher.until("state"))["status"] in ("running", "paused"):
            pass
    return said["status"], said["seconds"], said["sentence"]


def test_a_field_that_is_played_ends_as_the_map_says(sweeping, connect, mission, transport):
    ring, limit = mission(transport), 40.0
    with sweeping() as sweeper:
        sweeper.start(ring, moments=3, seconds=limit)
        found = sweeper.until("map")
    assert found["total"] == len(found["fields"]) == 3 * len(ring["agents"])
    assert found["moments"][0] == 0 < found["moments"][1]
    by_outcome = {field["outcome"]: field for field in found["fields"]}
    assert {"stuck", "time"} <= set(by_outcome), "fields that end in several ways"
    for field in by_outcome.values():
        agent, at_s = found["agents"][field["agent"]], found["moments"][field["moment"]]
        expected = (field["outcome"], field["seconds"], field["sentence"])
        assert played(connect, ring, agent, at_s, limit) == expected


def test_a_sweep_is_told_in_the_readers_language(sweeping, mission):
    with sweeping("fr") as sweeper:
        sweeper.start(mission())
        assert sweeper.until("map")["fields"][0]["sentence"].startswith("Il ne reste personne")


def test_what_cannot_be_swept_is_refused_with_a_reason_and_the_socket_goes_on(sweeping, mission, monkeypatch):
    blink = mission()
    nobody = {**blink, "agents": []}
    broken = {**blink, "agents": [{"name": "robot-1", "program": "missing", "start": ""}]}
    monkeypatch.setattr(sweep_socket, "MOST_FIELDS", 5)
    with sweeping() as sweeper:
        for wrong, words in ((nobody, "agent"), (broken, "missing")):
            sweeper.start(wrong)
            said = sweeper.until("refused")
            assert "has errors" in said["message"]
            assert any(words in one["message"] for one in said["problems"] if one["severity"] == "error")
        sweeper.start(blink, moments=6)
        assert "6 fields; the studio shows at most 5" in sweeper.until("refused")["message"]
        for odd in ({"moments": 0}, {"moments": 201}, {"seconds": 0}, {"seconds": 1e9}):
            sweeper.start(blink, **odd)
            assert "not understood" in sweeper.until("refused")["message"]
        sweeper.start(blink, moments=5)
        assert len(sweeper.until("map")["fields"]) == 5


def test_a_studio_is_at_one_sweep_at_a_time_and_it_can_be_broken_off(sweeping, mission, forever):
    with sweeping() as first, sweeping() as second:
        first.start(forever, seconds=36_000)
        first.send(type="nothing")
        assert "not understood" in first.until("refused")["message"]
        second.start(mission())
        assert "at a sweep already" in second.until("refused")["message"]
        first.send(type="stop")
        assert "broken off" in first.until("refused")["message"]
        second.start(mission())
        assert second.until("map")["total"] == 1
        first.start(forever, seconds=36_000)
    # Where the socket closed the sweep ends with the next of its looks, and the place is free.
    with sweeping() as third:
        said: dict[str, Any] = {"type": "refused"}
        while said["type"] == "refused":
            third.start(mission())
            said = third.until("map", "refused")
        assert said["total"] == 1
