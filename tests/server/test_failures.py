"""Robots that fail, stall, lose their radio and come back over the socket; and that Stop stands everything still."""

from __future__ import annotations

import struct
from typing import Any

import pytest

from kitrobot.sim.agent_views import FAILED, MOVING, MUTED, STALLED
from tests.server.pages import Watcher

# The fixtures are those of test_run.
ROBOT = "carrier-1"


def flags(frame: bytes) -> list[int]:
    """Of every robot in the last frame."""
    numbers = struct.unpack(f"<{len(frame) // 4}f", frame)
    robots, things = int(numbers[1]), int(numbers[2])
    head = len(numbers) - (3 + 5 * robots + 2 * things)
    return [int(numbers[head + 3 + 5 * robot + 4]) for robot in range(robots)]


@pytest.fixture
def ring(mission, transport):
    """The mission with carriers on a ring."""
    return {**mission(transport)}


def paused_at(watcher: Watcher, ring: dict, seconds: float) -> None:
    """A run that pauses there."""
    watcher.start(ring, speed=1)
    while watcher.until("tick")["seconds"] < seconds:
        pass
    watcher.send(type="pause")
    watcher.until("state", status="paused")


@pytest.mark.parametrize(("kind", "flag"), [("fail", FAILED), ("stall", STALLED), ("mute", MUTED)])
def test_a_robot_that_is_harmed_shows_it_at_once_even_while_paused(connect, ring, kind, flag):
    with connect() as watcher:
        paused_at(watcher, ring, 1)
        watcher.frames.clear()
        watcher.send(type="harm", agent=ROBOT, kind=kind)
        said = watcher.until("tick")
        assert flags(watcher.frames[-1])[0] & flag
        assert [(one["agent"], one["kind"]) for one in said["events"]][-1] == (ROBOT, "failure")
        watcher.send(type="harm", agent=ROBOT, kind="revive")
        said = watcher.until("tick")
        assert not flags(watcher.frames[-1])[0] & flag
        assert said["events"][-1]["kind"] == "revival"


def test_what_was_told_at_once_is_not_told_again_with_the_step(connect, ring):
    with connect() as watcher:
        paused_at(watcher, ring, 1)
        watcher.send(type="harm", agent=ROBOT, kind="fail")
        watcher.until("tick")
        watcher.send(type="step")
        assert [one for one in watcher.until("tick")["events"] if one["kind"] == "failure"] == []


def test_failing_begins_another_future(connect, ring):
    with connect() as watcher:
        paused_at(watcher, ring, 3)
        watcher.send(type="seek", tick=20)
        said = watcher.until("tick")
        assert said["latest"] > said["tick"] == 20
        watcher.send(type="harm", agent=ROBOT, kind="fail")
        said = watcher.until("tick")
        assert said["latest"] == said["tick"] == 20
        assert said["agents"][ROBOT]["state"] == "failed"


def test_a_stranger_cannot_fail_and_a_strange_kind_is_not_understood(connect, ring):
    with connect() as watcher:
        paused_at(watcher, ring, 1)
        watcher.send(type="harm", agent="nobody", kind="fail")
        assert "nobody" in watcher.until("error")["message"]
        watcher.send(type="harm", agent=ROBOT, kind="explode")
        assert "not understood" in watcher.until("error")["message"]


def test_a_schedule_of_the_mission_holds_in_the_studio(connect, ring):
    failures = [{"agent": ROBOT, "at_s": 0.5, "kind": "fail"}]
    with connect() as watcher:
        watcher.start({**ring, "failures": failures}, speed=0)
        events: list[dict[str, Any]] = []
        while not events:
            events = [one for one in watcher.until("tick")["events"] if one["kind"] == "failure"]
        assert (events[0]["agent"], events[0]["tick"]) == (ROBOT, 25)


def test_stop_stands_everything_still_in_the_last_frame(connect, ring):
    with connect() as watcher:
        watcher.start(ring, speed=1)
        while not any(one & MOVING for one in flags(watcher.frames[-1] if watcher.frames else b"\0" * 12)):
            watcher.until("tick")
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
        assert not any(one & MOVING for one in flags(watcher.frames[-1]))


def test_of_very_many_only_those_looked_at_are_reported(connect, ring):
    arms = [agent for agent in ring["agents"] if agent["program"] != "carrier"]
    own = [{"name": f"c-{n}", "program": arms[0]["program"], "start": arms[0]["name"]} for n in range(150)]
    with connect() as watcher:
        watcher.start({**ring, "agents": [*ring["agents"], *own]}, speed=1)
        first = watcher.until("tick")["agents"]
        assert len(first) < 10
        watcher.send(type="look", agents=["c-77"])
        seen = watcher.until("tick")["agents"]
        while "c-77" not in seen:
            seen = watcher.until("tick")["agents"]
        assert "c-78" not in seen


def test_robots_fail_by_chance_at_the_rate_that_is_asked_for_and_the_recording_knows_it(connect, ring, page):
    with connect() as watcher:
        watcher.send(type="start", mission=ring, path="", seed=1, speed=0, fail_rate=1.0)
        started = watcher.until("started")
        assert started["fail_rate"] == 1.0
        events: list[dict[str, Any]] = []
        while len([one for one in events if one["kind"] == "failure"]) < len(started["agents"]):
            events += watcher.until("tick")["events"]
        assert {one["cause"] for one in events if one["kind"] == "failure"} == {"chance"}
        watcher.until("state", status="failed")
        trace = page.get("/api/run/trace", params={"run": started["run"]}).content
        assert page.post("/api/trace", content=trace).json()["fail_rate"] == 1.0


def test_without_a_rate_nobody_fails(connect, mission):
    with connect() as watcher:
        assert watcher.start(mission())["fail_rate"] == 0
        watcher.until("state", status="done")


@pytest.mark.parametrize("rate", [-0.1, 1.1, "often", None, float("nan"), 1e400])
def test_a_rate_that_is_no_probability_is_not_understood(connect, mission, rate):
    with connect() as watcher:
        watcher.send(type="start", mission=mission(), path="", seed=1, speed=0, fail_rate=rate)
        assert watcher.until("error")["message"].startswith("The request was not understood")


def test_every_event_says_what_brought_it_about(connect, ring):
    with connect() as watcher:
        watcher.start({**ring, "failures": [{"agent": ROBOT, "at_s": 0.1, "kind": "stall"}]}, speed=1)
        events: list[dict[str, Any]] = []
        while not any(one["kind"] == "failure" for one in events):
            events += watcher.until("tick")["events"]
        watcher.send(type="harm", agent="carrier-2", kind="mute")
        while len([one for one in events if one["kind"] == "failure"]) < 2:
            said = watcher.until("tick")
            events = said["events"] if said["again"] else events + said["events"]
        found = {(one["agent"], one["cause"]) for one in events if one["kind"] == "failure"}
        assert found == {(ROBOT, "mission"), ("carrier-2", "person")}
        assert {one["cause"] for one in events if one["kind"] == "message"} <= {"program"}
