"""A run over the WebSocket: started, steered, watched, ended."""

from __future__ import annotations

import asyncio
import itertools
import re
import struct
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import kitrobot
from kitrobot.live import runs
from kitrobot.live.run_encoder import RunEncoder
from kitrobot.live.watched_simulation import WatchedSimulation
from kitrobot.sim.source import SimulationSource
from tests.server.pages import FOREVER, TOKEN

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.fixture
def polling(page):
    """A mission whose program only waits until somebody takes its variable Run from 1."""
    waiting = re.sub(r'"Wheel.*/set>', '"Wait"><set name="duration">1</set>', FOREVER)
    return page.post("/api/mission/read", content=waiting.encode()).json()["mission"]


def test_a_short_run_starts_and_ends_as_done(connect, mission):
    with connect() as watcher:
        started = watcher.start(mission())
        assert started["tick_ms"] == 20
        assert started["agents"] == [
            {"name": "robot-1", "program": "blink", "robot": "mini-robot", "number": 1, "kind": "robot", "placed": True}
        ]
        assert started["world"]["name"] == "empty"
        end = watcher.until("state", status="done")
        assert end["tick"] == 11
        assert end["sentence"].endswith(".")


def test_the_first_news_comes_before_the_first_tick_and_shows_every_agent(connect, mission):
    with connect() as watcher:
        watcher.start(mission())
        first = watcher.next()
        assert (first["type"], first["tick"]) == ("tick", 0)
        assert list(first["agents"]) == ["robot-1"]
        assert len(watcher.frames) == 1


def test_a_frame_holds_the_tick_and_five_numbers_of_each_agent(connect, mission):
    with connect() as watcher:
        watcher.start(mission())
        watcher.next()
        tick, robots, things, x, y, heading, load, flags = struct.unpack("<8f", watcher.frames[0])
        assert (tick, robots, things) == (0, 1, 0)
        assert (x, y, heading, load, flags) == (2000, 1250, 0, 0, 0)


def test_a_frame_says_how_many_things_there_are_and_holds_two_numbers_of_each():
    source = SimulationSource(kitrobot.open(EXAMPLES / "tidy-up" / "tidy-up.krt").simulation(seed=1))
    frame = RunEncoder(source.header).encode_frame(source.record())
    numbers = struct.unpack(f"<{len(frame) // 4}f", frame)
    assert numbers[:3] == (0, 1, 3)
    assert numbers[3 + 5 :] == (700, 610, 1000, 585, 1250, 640)


def test_at_full_speed_the_way_between_two_frames_comes_too(connect, mission, transport):
    with connect() as watcher:
        watcher.start(mission(transport), path=transport)
        watcher.until("state", status="done")
        ticks: list[int] = []
        for message in watcher.frames:
            numbers = struct.unpack(f"<{len(message) // 4}f", message)
            size = 3 + 5 * int(numbers[1]) + 2 * int(numbers[2])
            assert len(numbers) % size == 0
            ticks += [int(tick) for tick in numbers[::size]]
        assert ticks == sorted(ticks)
        assert max(after - before for before, after in itertools.pairwise(ticks)) <= 24


def test_the_example_with_carriers_ends_as_done_with_all_stock_delivered(connect, mission, transport):
    with connect() as watcher:
        started = watcher.start(mission(transport), path=transport)
        assert {agent["kind"] for agent in started["agents"]} >= {"carrier", "loader", "unloader", "store-manager"}
        assert started["stock"] == {"A": 12, "B": 0}
        assert started["total"] == 12
        kinds, last = set(), {}
        while True:
            said = watcher.next()
            if said["type"] == "tick":
                last = said
                kinds |= {event["kind"] for event in said["events"]}
            elif said["type"] == "state" and said["status"] == "done":
                break
        assert last["stock"] == {"A": 0, "B": 12}
        assert sum(last["delivered"].values()) == 12
        assert kinds >= {"load", "unload", "message", "end"}


def test_active_instructions_are_told_as_vertices(connect, mission):
    with connect() as watcher:
        watcher.send(type="start", mission=mission(), path="", seed=1, speed=1)
        watcher.send(type="pause")
        watcher.until("state", status="paused")
        watcher.send(type="step")
        said = watcher.until("tick", tick=1)
        assert said["agents"]["robot-1"]["active"] == [[0, "v2"]]


def test_a_step_runs_one_tick_while_paused(connect, forever):
    with connect() as watcher:
        watcher.start(forever, speed=0.1)
        watcher.send(type="pause")
        at = watcher.until("state", status="paused")["tick"]
        for number in range(1, 4):
            watcher.send(type="step")
            assert watcher.until("tick")["tick"] == at + number
            assert watcher.until("state")["tick"] == at + number


def test_several_steps_asked_for_at_once_are_all_run(connect, forever):
    with connect() as watcher:
        watcher.start(forever, speed=0.1)
        watcher.send(type="pause")
        at = watcher.until("state", status="paused")["tick"]
        for _ in range(5):
            watcher.send(type="step")
        while watcher.until("tick")["tick"] < at + 5:
            pass


def test_a_step_while_running_is_passed_over(connect, forever):
    with connect() as watcher:
        watcher.start(forever)
        watcher.send(type="step")
        watcher.send(type="stop")
        assert watcher.until("state", status="stopped")


def test_resume_goes_on_after_a_pause(connect, forever):
    with connect() as watcher:
        watcher.start(forever)
        watcher.send(type="pause")
        at = watcher.until("state", status="paused")["tick"]
        watcher.send(type="resume")
        watcher.until("state", status="running")
        assert watcher.until("tick")["tick"] > at


def test_a_run_in_which_nothing_can_change_goes_on_when_a_person_changes_something(connect, polling):
    """What was there before its end is gone back to as ever, and the run then stands."""
    with connect() as watcher:
        watcher.start(polling)
        tick = watcher.until("state", status="stuck")["tick"]
        watcher.send(type="set", agent="robot-1", variable="Run", value=0)
        watcher.until("state", status="running")
        assert watcher.until("state", status="done")["tick"] > tick
        watcher.send(type="seek", tick=5)
        watcher.until("state", status="paused")
        watcher.send(type="set", agent="robot-1", variable="Run", value=0)
        watcher.send(type="resume")
        watcher.until("state", status="done")


def test_stop_ends_a_run_that_never_would(connect, forever):
    with connect() as watcher:
        watcher.start(forever)
        watcher.send(type="stop")
        assert watcher.until("state", status="stopped")


def test_stop_ends_a_paused_run(connect, forever):
    with connect() as watcher:
        watcher.start(forever)
        watcher.send(type="pause")
        watcher.until("state", status="paused")
        watcher.send(type="stop")
        assert watcher.until("state", status="stopped")


def test_the_speed_can_be_changed_in_a_run(connect, forever):
    with connect() as watcher:
        watcher.start(forever, speed=0.1)
        watcher.send(type="speed", value=0)
        # Paced at a tenth this would take minutes.
        while watcher.until("tick")["tick"] < 500:
            pass


def test_another_run_starts_on_the_same_socket_after_the_first(connect, mission):
    with connect() as watcher:
        first = watcher.start(mission())["run"]
        watcher.until("state", status="done")
        assert watcher.start(mission())["run"] != first
        watcher.until("state", status="done")


def test_a_second_run_beside_the_first_is_refused(connect, mission, forever):
    with connect() as watcher:
        watcher.start(forever)
        watcher.send(type="start", mission=mission(), path="", seed=1, speed=0)
        assert "already" in watcher.until("error")["message"]
        watcher.send(type="stop")
        assert watcher.until("state", status="stopped")


def test_there_are_only_so_many_runs_at_a_time(connect, forever, monkeypatch):
    monkeypatch.setattr(runs, "MOST_RUNS", 1)
    with connect() as one, connect() as other:
        one.start(forever)
        other.send(type="start", mission=forever, path="", seed=1, speed=0)
        assert "1 runs already" in other.until("error")["message"]


def test_a_run_ends_when_its_socket_closes(app, connect, forever):
    with connect() as watcher:
        watcher.start(forever)
        assert app.state.studio.runs == 1
    with connect() as watcher:
        watcher.send(type="nothing")
        watcher.until("error")
        assert app.state.studio.runs == 0


def test_the_same_seed_gives_the_same_run(connect, mission, transport):
    def told():
        with connect() as watcher:
            watcher.start(mission(transport), path=transport, seed=7)
            return watcher.until("state", status="done")

    assert told() == told()


def test_only_what_changed_is_told_again(connect, mission, transport):
    with connect() as watcher:
        watcher.start(mission(transport), path=transport, speed=0.1)
        watcher.send(type="pause")
        watcher.until("state", status="paused")
        watcher.send(type="step")
        watcher.until("tick")
        sizes = []
        for _ in range(20):
            watcher.send(type="step")
            sizes.append(len(watcher.until("tick")["agents"]))
        assert min(sizes) < 7


def test_a_mission_with_errors_is_told_its_problems_and_not_started(connect, mission):
    broken = mission()
    broken["programs"][0]["vertices"][1]["element"] = "Light.Glow"
    with connect() as watcher:
        watcher.send(type="start", mission=broken, path="", seed=1, speed=0)
        said = watcher.next()
        assert said["type"] == "problems"
        assert said["problems"][0]["vertices"] == ["v1"]
        assert watcher.frames == []


def test_a_team_that_does_not_fit_its_world_is_a_problem(connect, mission):
    crowded = mission()
    crowded["agents"] = [{"name": f"r{n}", "program": "blink", "start": "robot-1"} for n in range(2)]
    with connect() as watcher:
        watcher.send(type="start", mission=crowded, path="", seed=1, speed=0)
        said = watcher.next()
        assert said["type"] == "problems"
        assert said["problems"][0]["code"] == "run-start"


def test_a_mission_without_agents_is_a_problem(connect, mission):
    with connect() as watcher:
        watcher.send(type="start", mission={**mission(), "agents": []}, path="", seed=1, speed=0)
        assert watcher.next()["problems"][0]["code"] == "run-no-agent"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "null",
        "[]",
        '"start"',
        "{}",
        '{"type":"start"}',
        '{"type":"fly"}',
        '{"type":"speed"}',
        '{"type":"speed","value":-1}',
        '{"type":"speed","value":1e9}',
        '{"type":"speed","value":NaN}',
        '{"type":"speed","value":"fast"}',
        "[" * 50_000,
        "\x00",
    ],
)
def test_a_message_that_is_not_understood_is_answered_and_the_socket_stays_open(connect, mission, text):
    with connect() as watcher:
        watcher.socket.send_text(text)
        said = watcher.next()
        assert said["type"] == "error"
        assert said["message"].endswith(".")
        watcher.start(mission())
        watcher.until("state", status="done")


def test_bytes_that_are_no_text_are_answered_too(connect):
    with connect() as watcher:
        watcher.socket.send_bytes(b"\xff\xfe\x00")
        assert watcher.next()["type"] == "error"


def test_steering_without_a_run_is_passed_over(connect, mission):
    with connect() as watcher:
        for kind in ("pause", "resume", "step", "stop"):
            watcher.send(type=kind)
        watcher.start(mission())
        watcher.until("state", status="done")


def test_a_path_outside_the_folder_is_refused(connect, mission):
    with connect() as watcher:
        watcher.send(type="start", mission=mission(), path="../secret.krt", seed=1, speed=0)
        assert watcher.next()["type"] == "error"


def test_a_run_that_breaks_is_one_sentence(connect, mission, monkeypatch, caplog):
    def broken(*arguments: object) -> None:
        raise ZeroDivisionError("secret detail")

    monkeypatch.setattr(WatchedSimulation, "advance", broken)
    with connect() as watcher:
        watcher.start(mission())
        assert watcher.until("error")["message"] == "Something went wrong inside KitRobot."
    assert "Traceback" not in caplog.text


@pytest.mark.parametrize(
    "path", ["run", "sweep", "experiment", "verify", "drawing-check", "watch", "boards", "boards/port"]
)
def test_a_page_that_goes_while_it_is_told_something_is_no_mistake(app, path):
    """Whatever the socket is for: nothing is raised, so the server has no traceback to show."""

    async def scenario(said: list[dict[str, Any]], breaks: bool) -> None:
        heard = [{"type": "websocket.connect"}, *said]

        async def receive() -> Any:
            if heard:
                return heard.pop(0)
            return {"type": "websocket.disconnect", "code": 1006}

        async def send(message: Any) -> None:
            if breaks and message["type"] == "websocket.send":
                raise OSError("the line is broken")
            if message["type"] == "websocket.send" and not heard:
                raise RuntimeError("Unexpected ASGI message 'websocket.send', after sending 'websocket.close'.")

        headers = [(b"host", b"127.0.0.1:8765"), (b"x-kitrobot-token", TOKEN.encode())]
        scope = {
            "type": "websocket",
            "asgi": {"version": "3.0"},
            "path": f"/api/{path}",
            "raw_path": b"",
            "scheme": "ws",
        }
        scope |= {"query_string": b"key=x&mark=y", "root_path": "", "headers": headers, "subprotocols": []}
        scope |= {"server": ("127.0.0.1", 8765), "client": ("127.0.0.1", 1)}
        await app(scope, receive, send)

    async def every() -> None:
        for breaks in (False, True):
            await scenario([], breaks)
            await scenario([{"type": "websocket.receive", "text": "{"}], breaks)
            await scenario([{"type": "websocket.receive", "text": '{"type": "start"}'}] * 3, breaks)

    thread = ThreadPoolExecutor(1)
    thread.submit(asyncio.run, every()).result()


def test_what_a_part_showed_between_two_messages_is_told_in_the_end(connect, page):
    source = """<kitrobot version="1"><program name="p" robot="microbit">
      <vertex id="start" element="Start"/>
      <vertex id="v1" element="Wait"><set name="duration">200</set></vertex>
      <vertex id="v2" element="Music.Tone"><set name="frequency">440</set><set name="duration">400</set></vertex>
      <vertex id="v3" element="Wait"><set name="duration">200</set></vertex>
      <vertex id="stop" element="Stop"/>
      <arc from="start" to="v1"/><arc from="v1" to="v2"/><arc from="v2" to="v3"/><arc from="v3" to="stop"/>
    </program><team><agent name="robot-1" program="p"/></team></kitrobot>"""
    tune = page.post("/api/mission/read", content=source.encode()).json()["mission"]
    with connect() as watcher:
        watcher.start(tune)
        reports = []
        while (said := watcher.next())["type"] != "state" or said["status"] != "done":
            if said["type"] == "tick":
                reports += said["agents"].values()
        assert reports[0]["used"] == []
        assert reports[-1]["used"] == ["Music"]
        assert not any(reports[-1]["shown"]["Music"])
