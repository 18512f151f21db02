"""Every long work ends at once: by STOP, when its page closes, when the studio ends; and a step to the next part ends.

Each is tried with threads here, and where there are none, as in a page, in a process of its own (long_work_in_page).
What is still on when its studio ends would hold up the end of the test: threads are waited for.
"""

from __future__ import annotations

import asyncio
import json
import subprocess
import sys
import threading
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live import watched_run
from kitrobot.server.routes import exercise as exercise_routes
from kitrobot.text.sentences import Sentence
from tests.server.conftest import HOST, SOCKET, TOKEN
from tests.server.in_page_scenario import environment

# The fixture is that of test_run.
SCENARIO = Path(__file__).with_name("long_work_in_page.py")
HOURS = 10**7
WAITS_BESIDE = """<kitrobot version="1">
  <program name="waits" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait Until"/>
    <vertex id="v2" element="Captor.LessThan"><set name="value">0</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v2" to="v1" at="condition"/>
    <arc from="v1" to="stop"/>
  </program>
  <program name="drives" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="f" element="Forever"/>
    <vertex id="a" element="Wheel.Advance"><set name="speed">50</set></vertex>
    <vertex id="w" element="Wait"><set name="duration">5</set></vertex>
    <vertex id="b" element="Wheel.Reverse"><set name="speed">50</set></vertex>
    <vertex id="u" element="Wait"><set name="duration">5</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="f"/>
    <arc from="f" out="body" to="a"/>
    <arc from="a" to="w"/>
    <arc from="w" to="b"/>
    <arc from="b" to="u"/>
    <arc from="u" to="f" at="return"/>
    <arc from="f" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="waits"/>
    <agent name="robot-2" program="drives"/>
  </team>
  <world version="1" name="yard" width="3000" height="3000">
    <start name="robot-1" x="500" y="500" heading="0"/>
    <start name="robot-2" x="1500" y="1500" heading="0"/>
  </world>
</kitrobot>
"""
"""One robot stands still for ever while another goes on."""


@pytest.fixture
def waiting(page) -> dict[str, Any]:
    """Its mission, as the page has it."""
    read: dict[str, Any] = page.post("/api/mission/read", content=WAITS_BESIDE.encode()).json()["mission"]
    return read


def paused_at(watcher, mission, tick: int) -> None:
    """A run of it that stands there."""
    watcher.start(mission)
    while watcher.until("tick")["tick"] < tick:
        pass
    watcher.send(type="pause")
    watcher.until("state", status="paused")


JOBS: dict[str, dict[str, Any]] = {
    "to the next part": {"type": "step", "by": "vertex", "agent": "robot-1"},
    "to the part before": {"type": "step", "by": "vertex", "agent": "robot-1", "back": True},
    "to a moment": {"type": "seek", "tick": 0},
}


@pytest.mark.parametrize("name", JOBS)
def test_what_a_run_is_asked_for_ends_with_stop_and_with_its_page(
    connect, waiting, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(watched_run, "LONGEST_STEP_S", HOURS)
    with connect() as watcher:
        paused_at(watcher, waiting, 1000)
        watcher.send(**JOBS[name])
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
    with connect() as watcher:
        paused_at(watcher, waiting, 1000)
        watcher.send(**JOBS[name])


def test_more_steps_than_the_studio_has_threads_hold_up_nobody(
    page, connect, waiting, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(watched_run, "LONGEST_STEP_S", HOURS)
    with connect() as one, connect() as two, connect() as three, connect() as four, connect() as five, connect() as six:
        for watcher in (one, two, three, four, five, six):
            paused_at(watcher, waiting, 10)
            watcher.send(**JOBS["to the next part"])
        with connect() as seventh:
            paused_at(seventh, waiting, 10)


def test_a_step_is_bounded_and_says_so_where_the_run_stands(connect, waiting, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watched_run, "LONGEST_STEP_S", 120)
    with connect() as watcher:
        paused_at(watcher, waiting, 10)
        watcher.send(**JOBS["to the next part"])
        said = watcher.until("error")
        assert said["message"] == "`robot-1` came to no other part within 2 minutes of the run."
        assert not said["ended"]
        further = watcher.until("tick")["tick"]
        assert further >= 6000
        watcher.send(**JOBS["to the part before"])
        assert further - 6000 <= watcher.until("tick")["tick"] < further
        watcher.send(type="step", by="vertex", agent="robot-2")
        assert watcher.until("tick")["agents"]["robot-2"]


SOCKETS: dict[str, tuple[str, dict[str, Any]]] = {
    "sweep": ("sweep", {"moments": 100, "seconds": 36_000.0}),
    "check": ("verify", {"seconds": 3600.0, "failures": 2}),
}


@pytest.mark.parametrize("name", SOCKETS)
def test_work_on_a_socket_of_its_own_ends_with_stop_and_with_its_page(page, waiting, name: str) -> None:
    address, more = SOCKETS[name]
    start = {"type": "start", "mission": waiting, "path": "", "seed": 1, **more}
    for closing in (False, True):
        with page.websocket_connect(f"{SOCKET}/api/{address}?token={TOKEN}") as socket:
            socket.send_text(json.dumps(start))
            if not closing:
                socket.send_text('{"type": "stop"}')
                while (said := json.loads(socket.receive_text()))["type"] not in ("refused", "end"):
                    assert said["type"] in ("progress", "column")
                assert "understood" not in said.get("message", "")


def test_a_check_while_drawing_ends_with_its_page(page, waiting) -> None:
    with page.websocket_connect(f"{SOCKET}/api/drawing-check?token={TOKEN}") as socket:
        socket.send_text(json.dumps({"type": "start", "mission": waiting, "path": "", "seed": 1}))


class Page:
    """A request of the application `app`, whose page hangs up when `hang_up` is called."""

    def __init__(self, app: Any) -> None:
        self._app = app
        self._gone = asyncio.Event()

    def hang_up(self) -> None:
        self._gone.set()

    async def ask(self, method: str, path: str, query: str = "", body: bytes = b"") -> None:
        asked = [{"type": "http.request", "body": body, "more_body": False}]

        async def receive() -> Any:
            if asked:
                return asked.pop()
            await self._gone.wait()
            return {"type": "http.disconnect"}

        async def send(message: Any) -> None:
            pass

        headers = [(b"host", HOST.removeprefix("http://").encode()), (b"x-kitrobot-token", TOKEN.encode())]
        headers += [(b"content-type", b"application/json")]
        scope: dict[str, Any] = {
            "type": "http",
            "asgi": {"version": "3.0"},
            "http_version": "1.1",
            "method": method,
            "path": path,
        }
        scope |= {"raw_path": path.encode(), "query_string": query.encode(), "root_path": "", "headers": headers}
        scope |= {"scheme": "http", "server": ("127.0.0.1", 8765), "client": ("127.0.0.1", 1)}
        await self._app(scope, receive, send)


def in_a_loop(scenario: Coroutine[Any, Any, None]) -> None:
    thread = threading.Thread(target=asyncio.run, args=(scenario,))
    thread.start()
    thread.join()


@pytest.mark.parametrize("ending", ["hangs up", "is called off"])
def test_what_a_request_asked_for_is_broken_off_when_nobody_waits_any_more(app, ending: str) -> None:
    begun, ended = threading.Event(), threading.Event()

    class Endless:
        """A run that is recorded until it is told to stop."""

        def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
            begun.set()
            while not stop():
                pass
            path.write_bytes(b"")
            ended.set()

    app.state.studio.watches["run-x"] = Endless()

    async def scenario() -> None:
        page = Page(app)
        asked = asyncio.create_task(page.ask("GET", "/api/run/trace", "run=run-x"))
        await asyncio.to_thread(begun.wait)
        if ending == "hangs up":
            page.hang_up()
            await asked
        else:
            asked.cancel()
        await asyncio.to_thread(ended.wait)

    in_a_loop(scenario())


def test_a_judgement_is_broken_off_when_its_page_hangs_up(app, page, monkeypatch: pytest.MonkeyPatch) -> None:
    begun, ended = threading.Event(), threading.Event()

    def evaluate_submission(exercise: Any, opened: Any, options: Any, **more: Any) -> Any:
        begun.set()
        while not options.stop():
            pass
        ended.set()
        raise KitRobotError(Sentence("nothing was judged"))

    monkeypatch.setattr(exercise_routes, "evaluate_submission", evaluate_submission)
    start = page.get("/api/mission", params={"path": "example:exercises/03-square.krt"}).json()["mission"]
    asked = {"exercise": "example:exercises/03-square.exercise.xml", "mission": start, "seed": 1}

    async def scenario() -> None:
        hanging = Page(app)
        task = asyncio.create_task(hanging.ask("POST", "/api/exercise/judge", body=json.dumps(asked).encode()))
        await asyncio.to_thread(begun.wait)
        hanging.hang_up()
        await task

    in_a_loop(scenario())
    assert ended.is_set()


def test_each_long_work_is_broken_off_where_there_are_no_threads(tmp_path: Path) -> None:
    ran = subprocess.run(
        [sys.executable, str(SCENARIO), str(tmp_path / "missions")],
        input=WAITS_BESIDE,
        capture_output=True,
        text=True,
        check=False,
        env=environment(tmp_path),
    )
    assert ran.returncode == 0, ran.stderr
    told = json.loads(ran.stdout.splitlines()[-1])
    every = ["to the next part", "to the part before", "to a moment"]
    assert told["calls that cannot sleep"] == dict.fromkeys(every, "stopped")
    assert told["calls that sleep"] == dict.fromkeys(every, "stopped")
    assert "broken off" in told["sweep"]
    assert told["verify"] == "end"
    assert told["recorded"] == "broken off"
