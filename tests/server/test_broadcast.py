"""A run that one page steers and others watch."""

from __future__ import annotations

import contextlib
import json
from typing import Any

import pytest

from kitrobot.live import runs
from kitrobot.live.watched_simulation import WatchedSimulation
from tests.server.conftest import SOCKET, TOKEN
from tests.server.pages import FOREVER
from tests.server.pages import Watcher as Page

PATH = "forever.krt"


@pytest.fixture
def studio(page):
    """The client, with one event loop for all its sockets, as a server has."""
    with page:
        yield page


@pytest.fixture
def connect(studio):
    """Opens the socket of one page."""

    @contextlib.contextmanager
    def connected(language="en"):
        with studio.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}&language={language}") as socket:
            yield Page(socket)

    return connected


@pytest.fixture
def forever(studio):
    """A mission that never ends."""
    return studio.post("/api/mission/read", content=FOREVER.encode()).json()["mission"]


@pytest.fixture
def blink(studio):
    """A mission that ends at once."""
    return studio.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]


def watch(page: Page, run: str, mission: dict[str, Any]) -> dict[str, Any]:
    page.send(type="watch", run=run, mission=mission)
    return page.next()


def test_who_joins_is_told_the_run_as_it_stands(connect, forever):
    with connect() as owner, connect() as other:
        run = owner.start(forever, speed=1)["run"]
        owner.send(type="pause")
        at = owner.until("state", status="paused")["tick"]
        started = watch(other, run, forever)
        assert (started["type"], started["run"]) == ("started", run)
        assert (started["watching"], started["another"]) == (True, False)
        first = other.next()
        assert (first["type"], first["tick"], first["again"]) == ("tick", at, True)
        assert list(first["agents"]) == ["robot-1"]
        assert len(other.frames) == 1
        assert other.next()["status"] == "paused"


def test_the_page_that_steers_is_not_told_that_it_watches(connect, forever):
    with connect() as owner:
        started = owner.start(forever)
        assert (started["watching"], started["another"]) == (False, False)


def test_a_watcher_is_told_what_the_owner_is_told(connect, forever):
    with connect() as owner, connect() as other:
        run = owner.start(forever, speed=1)["run"]
        owner.send(type="pause")
        owner.until("state", status="paused")
        watch(other, run, forever)
        other.until("state", status="paused")
        for _ in range(3):
            owner.send(type="step")
            mine, theirs = owner.until("tick"), other.until("tick")
            assert mine == theirs
            assert owner.frames[-1] == other.frames[-1]
            assert owner.until("state") == other.until("state")


def test_everybody_is_told_the_end(connect, blink):
    with connect() as owner, connect() as one, connect() as two:
        owner.send(type="start", mission=blink, path="", seed=1, speed=1)
        owner.send(type="pause")
        run = owner.until("started")["run"]
        owner.until("state", status="paused")
        for other in (one, two):
            watch(other, run, blink)
            other.until("state", status="paused")
        owner.send(type="speed", value=0)
        owner.send(type="resume")
        end = owner.until("state", status="done")
        for other in (one, two):
            assert other.until("tick", tick=end["tick"])["events"][-1]["kind"] == "end"
            assert other.until("state", status="done") == end


def test_everybody_is_told_that_it_was_stopped(connect, forever):
    with connect() as owner, connect() as other:
        run = owner.start(forever)["run"]
        watch(other, run, forever)
        owner.send(type="stop")
        assert other.until("state", status="stopped")


@pytest.mark.parametrize(
    "request_",
    [
        {"type": "stop"},
        {"type": "pause"},
        {"type": "seek", "tick": 0},
        {"type": "harm", "agent": "robot-1", "kind": "fail"},
        {"type": "breakpoints", "breakpoints": []},
    ],
)
def test_who_watches_steers_nothing_and_is_told_so(connect, forever, request_):
    with connect() as owner, connect() as other:
        run = owner.start(forever)["run"]
        watch(other, run, forever)
        other.send(**request_)
        said = other.until("error")
        assert (said["message"], said["ended"]) == ("The page that started this run steers it.", False)
        owner.send(type="pause")
        at = owner.until("state", status="paused")["tick"]
        assert other.until("state", status="paused")["tick"] == at, "it went on until its owner paused it"


def test_the_run_ends_for_all_when_the_page_that_steers_is_gone(app, connect, forever):
    with connect() as other:
        with connect() as owner:
            run = owner.start(forever)["run"]
            watch(other, run, forever)
        said = other.until("error")
        assert said["ended"]
        assert said["message"] == "The page that steered this run is gone, and the run with it."
        assert app.state.studio.broadcasts == {}
        assert watch(other, run, forever)["ended"]


def test_a_run_goes_on_when_a_watcher_leaves(app, connect, forever):
    with connect() as owner:
        run = owner.start(forever, speed=1)["run"]
        with connect() as other:
            watch(other, run, forever)
        tick = owner.until("tick")["tick"]
        while owner.until("tick")["tick"] < tick + 10:
            pass
        assert len(app.state.studio.broadcasts[run]) == 0


def test_who_watches_may_start_a_run_of_its_own_and_watches_no_more(app, connect, forever, blink):
    with connect() as owner, connect() as other:
        run = owner.start(forever)["run"]
        watch(other, run, forever)
        other.send(type="start", mission=blink, path="", seed=1, speed=0)
        assert other.until("started", watching=False)["run"] != run
        other.until("state", status="done")
        assert len(app.state.studio.broadcasts[run]) == 0


def test_a_run_that_stands_at_its_end_is_not_offered_but_who_watches_sees_it_go_back(app, connect, blink):
    with connect() as owner, connect() as other:
        owner.send(type="start", mission=blink, path=PATH, seed=1, speed=1)
        owner.send(type="pause")
        run = owner.until("started")["run"]
        owner.until("state", status="paused")
        watch(other, run, blink)
        assert app.state.studio.runs_of(PATH) == [run]
        assert app.state.studio.runs_of("") == []
        owner.send(type="speed", value=0)
        owner.send(type="resume")
        other.until("state", status="done")
        assert app.state.studio.runs_of(PATH) == []
        owner.send(type="seek", tick=3)
        assert other.until("tick", tick=3)
        assert other.until("state", status="paused")["tick"] == 3
        assert app.state.studio.runs_of(PATH) == [run]


def test_pages_that_have_the_mission_open_are_told_of_its_runs(connect, studio, forever, blink):
    with connect() as owner, studio.websocket_connect(f"{SOCKET}/api/watch?token={TOKEN}") as tab:
        name = json.loads(tab.receive_text())["tab"]
        studio.post("/api/journal/claim", json={"tab": name, "path": "blink.krt", "journal": ""})
        owner.send(type="start", mission=forever, path="blink.krt", seed=1, speed=1)
        run = owner.until("started")["run"]
        while json.loads(tab.receive_text())["runs"] != [run]:
            pass
        owner.send(type="stop")
        while json.loads(tab.receive_text())["runs"] != []:
            pass


def test_another_mission_than_the_one_that_runs_is_said_to_be_another(connect, forever, blink):
    with connect() as owner, connect() as other:
        run = owner.start(forever)["run"]
        assert watch(other, run, blink)["another"]
        noted = {**forever, "breakpoints": [{"program": "polling", "vertex": "v4"}]}
        other.send(type="watch", run=run, mission=noted)
        assert not other.until("started")["another"], "a breakpoint makes no other run"


def test_a_run_that_is_not_there_is_one_sentence(connect, forever):
    with connect() as other:
        for name in ("run-0", "", "🤖" * 10, "../x"):
            said = watch(other, name, forever)
            assert (said["type"], said["ended"]) == ("error", True)
            assert said["message"] == "This run is over."


@pytest.mark.parametrize(
    "text",
    [
        '{"type":"watch"}',
        '{"type":"watch","run":1,"mission":{}}',
        '{"type":"watch","run":"run-1","mission":null}',
        '{"type":"watch","run":"%s","mission":{}}' % ("x" * 5000),
        '{"type":"watch","run":["run-1"]}',
    ],
)
def test_a_wish_to_watch_that_is_not_understood_is_answered(connect, text):
    with connect() as other:
        other.socket.send_text(text)
        assert other.next()["type"] == "error"


def test_who_steers_a_run_cannot_watch_another_on_the_same_socket(connect, forever):
    with connect() as owner, connect() as other:
        run = owner.start(forever)["run"]
        other.start(forever)
        other.send(type="watch", run=run, mission=forever)
        assert other.until("error")["message"] == "A run is on already."


def test_only_so_many_watch(connect, forever, monkeypatch):
    monkeypatch.setattr(runs, "MOST_WATCHERS", 1)
    with connect() as owner, connect() as one, connect() as two:
        run = owner.start(forever)["run"]
        assert watch(one, run, forever)["type"] == "started"
        assert watch(two, run, forever)["message"] == "1 pages watch this run already."


def test_a_run_that_breaks_is_over_for_all(connect, forever, monkeypatch):
    with connect() as owner, connect() as other:
        run = owner.start(forever, speed=1)["run"]
        watch(other, run, forever)

        def broken(*arguments: object) -> None:
            raise ZeroDivisionError("secret detail")

        monkeypatch.setattr(WatchedSimulation, "advance", broken)
        for page in (owner, other):
            said = page.until("error")
            assert (said["message"], said["ended"]) == ("Something went wrong inside KitRobot.", True)


def test_each_watcher_reads_in_its_language(connect, blink):
    ends = {}
    with connect() as owner, connect("fr") as french, connect("ur") as urdu:
        owner.send(type="start", mission=blink, path="", seed=1, speed=1)
        owner.send(type="pause")
        run = owner.until("started")["run"]
        owner.until("state", status="paused")
        for other in (french, urdu):
            watch(other, run, blink)
            other.until("state", status="paused")
        owner.send(type="speed", value=0)
        owner.send(type="resume")
        for name, other in (("en", owner), ("fr", french), ("ur", urdu)):
            events: list[dict[str, Any]] = []
            while not events:
                events = other.until("tick")["events"]
            ends[name] = (events[-1]["text"], other.until("state", status="done")["sentence"])
    assert len(set(ends.values())) == 3, ends


def test_what_a_watcher_looks_at_is_told_beside_what_the_owner_looks_at(app, connect, forever, monkeypatch):
    looked: list[set[str]] = []
    with connect() as owner, connect() as other:
        run = owner.start(forever, speed=1)["run"]
        watched = app.state.studio.watches[run]
        monkeypatch.setattr(watched, "look_at", lambda agents: looked.append(set(agents)))
        watch(other, run, forever)
        other.send(type="look", agents=["b"])
        while {"b"} not in looked:
            assert owner.next()["type"] != "error"
        owner.send(type="look", agents=["a"])
        while {"a", "b"} not in looked:
            assert owner.next()["type"] != "error"
