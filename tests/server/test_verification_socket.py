"""A check over its WebSocket: columns as they come, a run that confirms what is broken, refusals, breaking off."""

from __future__ import annotations

import contextlib
import json
from typing import Any

import pytest
from pydantic import TypeAdapter

from kitrobot.wire.verification import VerifyMessage
from tests.server.conftest import SOCKET, TOKEN
from tests.verifier.check_fixtures import EXAMPLES

# The fixtures are those of test_run.
MESSAGE: TypeAdapter[Any] = TypeAdapter(VerifyMessage)


class Checker:
    """The page's end of a socket. Every message is held against its published shape."""

    def __init__(self, socket) -> None:
        self.socket = socket
        self.columns: list[dict[str, Any]] = []

    def send(self, **message) -> None:
        self.socket.send_text(json.dumps(message))

    def start(self, mission, **more) -> None:
        self.send(**{"type": "start", "mission": mission, "path": "", "seed": 1, "seconds": 600.0, **more})

    def next(self) -> dict[str, Any]:
        said: dict[str, Any] = json.loads(self.socket.receive_text())
        MESSAGE.validate_python(said)
        if said["type"] == "column":
            self.columns.append(said)
        return said

    def until(self, *kinds: str) -> dict[str, Any]:
        while (said := self.next())["type"] not in kinds:
            assert said["type"] in ("progress", "column"), said
        return said


@pytest.fixture
def reading(page):
    """The mission of a text."""

    def read(text: str) -> dict[str, Any]:
        made: dict[str, Any] = page.post("/api/mission/read", content=text.encode()).json()["mission"]
        return made

    return read


@pytest.fixture
def checking(page):
    """Opens a socket for checks."""

    @contextlib.contextmanager
    def connected(language="en"):
        with page.websocket_connect(f"{SOCKET}/api/verify?language={language}&token={TOKEN}") as socket:
            yield Checker(socket)

    return connected


def test_columns_come_one_by_one_in_the_readers_language_and_a_broken_one_is_played_as_it_says(
    checking, connect, reading
):
    text = (EXAMPLES / "passing-loop" / "passing-loop.krt").read_text(encoding="utf-8")
    loops = '<vertex id="v1" element="Repetition"><set name="count">3</set>'
    assert loops in text
    greedy = reading(text.replace(loops, loops.replace(">3<", ">9<")))
    with checking("fr") as checker:
        checker.start(greedy)
        first = checker.until("column")
        assert (first["timing"], first["failures"], first["cut"]) == ("lockstep", 0, None)
        assert first["states"] > 1000
        told = {one["name"]: one for one in first["properties"]}
        assert told["empty-storehouse"]["answer"] == "broken"
        assert not told["empty-storehouse"]["searched"]
        again = checker.until("column")
        broken = {one["name"]: one for one in again["properties"]}["empty-storehouse"]
        assert broken["searched"]
        assert broken["confirmed"]["failures"] == []
        assert broken["events"][-1]["text"].endswith("entrepôt vide A."), broken["events"][-1]
        (blamed,) = broken["guilty"]
        assert blamed["agent"] == "loader-1"
        assert blamed["program"] in {one["name"] for one in greedy["programs"]}
        assert not blamed["repeats"]
        assert blamed["sentence"] == broken["events"][-1]["text"]
        assert [blamed["program"], blamed["vertex"]] in [
            at for robot in broken["scenes"][-2]["robots"] for at in robot["at"]
        ]
        assert broken["scenes"][0]["step"] == 0
        assert broken["scenes"][-1]["step"] == broken["steps"]
        assert {len(scene["robots"]) for scene in broken["scenes"]} == {len(greedy["agents"])}
        assert told["deadlock"]["scenes"] == told["deadlock"]["guilty"] == []
        assert told["empty-storehouse"]["why"] is None
        why = broken["why"]
        assert why["sentences"][0].endswith("entrepôt vide A : cela viole `empty-storehouse`."), why
        assert 1 < len(why["sentences"]) <= 3
        if why["other"] is not None:
            assert why["other"]["scenes"][0]["step"] == why["step"]
            assert why["tick"] < broken["confirmed"]["tick"]
        checker.send(type="stop")
        checker.until("end")
    seen = broken["confirmed"]
    with connect() as watcher:
        watcher.send(type="start", mission=greedy, path="", seed=seen["seed"], speed=0, seconds=600)
        watcher.until("started")
        events: list[dict[str, Any]] = []
        while (said := watcher.until("tick"))["tick"] < seen["tick"]:
            events += said["events"]
        events += said["events"]
    assert any(one["tick"] == seen["tick"] for one in events)


def test_what_cannot_be_checked_is_refused_with_a_way_out_and_the_socket_goes_on(checking, mission, page):
    blink = mission()
    team = page.post("/api/mission/team", json={"mission": blink, "path": "blink.krt", "name": "team"}).json()
    with checking() as checker:
        checker.start(team)
        assert checker.until("end")
        checker.start({**blink, "agents": [{"name": "robot-1", "program": "missing", "start": ""}]})
        said = checker.until("refused")
        assert any("missing" in one["message"] for one in said["problems"])
        mistakes: list[dict[str, Any]] = [
            {"failures": 4},
            {"failures": -1},
            {"failures": 1, "kinds": ["rust"]},
            {"failures": 1, "kinds": []},
            {"seconds": 0},
            {"seconds": 1e9},
            {"mission": {}},
        ]
        for odd in mistakes:
            checker.start(**{"mission": blink, **odd})
            assert "not understood" in checker.until("refused")["message"]
        checker.start(blink, failures=1, kinds=["mute", "fail"])
        (limit,) = checker.until("end")["limits"]
        assert limit.startswith("Nobody loses its radio"), limit
        found = [(one["timing"], one["failures"]) for one in checker.columns]
        assert list(dict.fromkeys(found)) == [
            (timing, failures) for failures in (0, 1) for timing in ("lockstep", "prompt", "free")
        ]


def test_a_studio_is_at_one_check_at_a_time_and_it_tells_how_far_it_came_when_it_is_broken_off(
    checking, mission, transport
):
    ring, blink = mission(transport), mission()
    with checking() as first, checking() as second:
        first.start(ring)
        assert first.until("progress")["states"] > 0
        second.start(blink)
        assert "at a check already" in second.until("refused")["message"]
        first.send(type="stop")
        first.until("end")
        assert {one["answer"] for one in first.columns[-1]["properties"]} <= {"holds", "not finished"}
        assert first.columns[-1]["cut"] == "stopped"
        second.start(blink)
        second.until("end")
