"""A run over the WebSocket taken back and on, paused at breakpoints, interfered with."""

from __future__ import annotations

import pytest

from tests.server.pages import Watcher

# The fixtures are those of test_run.
REVERSE = {"program": "polling", "vertex": "v5"}


def paused(watcher: Watcher) -> dict:
    return watcher.until("state", status="paused")


def position(watcher: Watcher) -> dict:
    """What is told after something was asked of a paused run."""
    return watcher.until("tick")


def test_a_breakpoint_of_the_mission_pauses_the_run_and_says_who(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        said = paused(watcher)
        assert said["hits"] == [{"program": "polling", "vertex": "v5", "agent": "robot-1", "visit": 1}]
        first = said["tick"]
        watcher.send(type="resume")
        said = paused(watcher)
        assert said["hits"][0]["visit"] == 2
        assert said["tick"] > first


def test_breakpoints_can_change_while_it_runs(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        paused(watcher)
        watcher.send(type="breakpoints", breakpoints=[{**REVERSE, "hits": 3}])
        watcher.send(type="resume")
        assert paused(watcher)["hits"][0]["visit"] == 3
        watcher.send(type="breakpoints", breakpoints=[])
        watcher.send(type="resume")
        watcher.until("state", status="running")
        watcher.send(type="pause")
        assert paused(watcher)["hits"] == []


def test_a_condition_that_is_none_is_said_and_the_run_stays(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        paused(watcher)
        watcher.send(type="breakpoints", breakpoints=[{**REVERSE, "when": "Count."}])
        assert "no condition" in watcher.until("error")["message"]
        watcher.send(type="resume")
        assert paused(watcher)["hits"][0]["visit"] == 2


def test_a_run_with_a_condition_that_is_none_does_not_start(connect, forever):
    with connect() as watcher:
        start = {"type": "start", "path": "", "seed": 1, "speed": 0}
        watcher.send(**start, mission={**forever, "breakpoints": [{**REVERSE, "when": "Wheel.Stop()"}]})
        assert watcher.until("error")["message"]
        watcher.start(forever)


def test_back_and_on_by_ticks(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        at = paused(watcher)["tick"]
        for tick in (at - 1, at - 2, at - 3):
            watcher.send(type="step", back=True)
            said = position(watcher)
            assert (said["tick"], said["latest"]) == (tick, at)
        watcher.send(type="step")
        assert position(watcher)["tick"] == at - 2


def test_going_to_a_tick_and_to_the_ends(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [{**REVERSE, "hits": 4}]})
        at = paused(watcher)["tick"]
        frames = len(watcher.frames)
        for asked, wanted in ((5, 5), (10**12, at), (0, 0)):
            watcher.send(type="seek", tick=asked)
            assert position(watcher)["tick"] == wanted
            assert paused(watcher)["tick"] == wanted
        assert len(watcher.frames) >= frames + 3


def test_steps_from_vertex_to_vertex_lead_back_where_they_came_from(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        paused(watcher)
        stood = []
        for _ in range(3):
            watcher.send(type="step", by="vertex", agent="robot-1")
            stood.append(position(watcher)["tick"])
            paused(watcher)
        assert stood == sorted(set(stood))
        watcher.send(type="step", by="vertex", back=True, agent="robot-1")
        assert position(watcher)["tick"] == stood[-1] - 1
        watcher.send(type="step", by="vertex", back=True, agent="robot-1")
        assert position(watcher)["tick"] == stood[-2] - 1


def test_what_is_done_in_the_past_begins_another_future(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [{**REVERSE, "hits": 3}]})
        at = paused(watcher)["tick"]
        watcher.send(type="seek", tick=at // 2)
        assert position(watcher)["latest"] == at
        watcher.send(type="set", agent="robot-1", variable="Count", value=7)
        said = position(watcher)
        assert (said["tick"], said["latest"], said["again"]) == (at // 2, at // 2, True)
        assert said["agents"]["robot-1"]["values"]["Count"] == 7


def test_a_forced_sensor_is_marked_and_given_back(connect, forever):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        paused(watcher)
        watcher.send(type="force", agent="robot-1", sensor="Captor", value=3)
        assert position(watcher)["agents"]["robot-1"]["forced"] == ["Captor"]
        watcher.send(type="step")
        assert position(watcher)["agents"]["robot-1"]["inputs"]["Captor"] == 3
        watcher.send(type="force", agent="robot-1", sensor="Captor", value=None)
        assert position(watcher)["agents"]["robot-1"]["forced"] == []


@pytest.mark.parametrize(
    "request_",
    [
        {"type": "force", "agent": "nobody", "sensor": "Captor", "value": 1},
        {"type": "force", "agent": "robot-1", "sensor": "Nothing", "value": 1},
        {"type": "set", "agent": "robot-1", "variable": "Nothing", "value": 1},
        {"type": "set", "agent": "robot-1", "variable": "Count", "value": 10**30},
        {"type": "seek", "tick": -1},
        {"type": "step", "by": "mile"},
    ],
)
def test_what_cannot_be_done_is_said_and_the_run_stays(connect, forever, request_):
    with connect() as watcher:
        watcher.start({**forever, "breakpoints": [REVERSE]})
        paused(watcher)
        watcher.send(**request_)
        assert watcher.until("error")["message"].endswith(".")
        watcher.send(type="resume")
        assert paused(watcher)["hits"][0]["visit"] == 2


def test_a_run_that_has_ended_can_be_gone_back_in_and_on(connect, mission):
    with connect() as watcher:
        watcher.start(mission())
        end = watcher.until("state", status="done")["tick"]
        watcher.send(type="seek", tick=end - 4)
        assert position(watcher)["tick"] == end - 4
        assert paused(watcher)["tick"] == end - 4
        watcher.send(type="resume")
        assert watcher.until("state", status="done")["tick"] == end
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
        watcher.start(mission())


def test_a_new_run_takes_the_place_of_one_that_has_ended(connect, mission):
    with connect() as watcher:
        for _ in range(3):
            watcher.start(mission())
            watcher.until("state", status="done")


def test_a_step_to_another_vertex_that_never_comes_can_be_stopped(connect, forever):
    never = {**forever, "breakpoints": [{**REVERSE, "hits": 2}]}
    with connect() as watcher:
        watcher.start(never)
        paused(watcher)
        watcher.send(type="breakpoints", breakpoints=[])
        watcher.send(type="step", by="vertex", agent="nobody")
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
