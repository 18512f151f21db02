"""There are so many runs at a time and no more, however many ask at once, and each gives its place back."""

from __future__ import annotations

import asyncio
import json
from typing import Any

import pytest

from kitrobot.live import runs
from kitrobot.live.feed import ChannelClosedError
from kitrobot.live.runs import MOST_RUNS, RunSession
from tests import coroutines
from tests.server.pages import FOREVER

MANY = 50


class Socket:
    """A page's side of a socket, all in one loop as on the real server."""

    def __init__(self, app: Any) -> None:
        self.app = app
        self._asked: asyncio.Queue[str | None] = asyncio.Queue()
        self.said: asyncio.Queue[dict[str, Any]] = asyncio.Queue()
        self._session = asyncio.create_task(RunSession(self, app.state.studio).serve())

    def ask(self, **request: Any) -> None:
        self._asked.put_nowait(json.dumps(request))

    async def receive(self) -> str:
        asked = await self._asked.get()
        if asked is None:
            raise ChannelClosedError
        return asked

    async def send_text(self, text: str) -> None:
        self.said.put_nowait(json.loads(text))

    async def send_bytes(self, data: bytes) -> None:
        pass

    async def until(self, *kinds: str) -> dict[str, Any]:
        while True:
            said = await self.said.get()
            if said["type"] in kinds:
                return said

    async def leave(self) -> None:
        self._asked.put_nowait(None)
        await self._session


@pytest.fixture
def start(page):
    mission = page.post("/api/mission/read", content=FOREVER.encode()).json()["mission"]
    return {"type": "start", "mission": mission, "path": "", "seed": 1, "speed": 1}


def test_of_fifty_that_start_at_once_eight_run_and_the_others_are_told(app, start):
    async def all_at_once() -> tuple[list[dict[str, Any]], int, int]:
        sockets = [Socket(app) for _ in range(MANY)]
        for one in sockets:
            one.ask(**start)
        said = await asyncio.gather(*(one.until("started", "error") for one in sockets))
        during = app.state.studio.runs
        await asyncio.gather(*(one.leave() for one in sockets))
        return said, during, app.state.studio.runs

    said, during, after = coroutines.run(all_at_once())
    assert sum(one["type"] == "started" for one in said) == during == MOST_RUNS
    assert {one["message"] for one in said if one["type"] == "error"} == {f"This studio has {MOST_RUNS} runs already."}
    assert after == 0


def test_who_leaves_while_the_run_is_made_ready_gives_the_place_back(app, start):
    async def leave_at_once() -> int:
        for _ in range(2 * MOST_RUNS):
            one = Socket(app)
            one.ask(**start)
            await one.leave()
        return int(app.state.studio.runs)

    assert coroutines.run(leave_at_once()) == 0


def test_what_breaks_while_the_run_is_made_ready_gives_the_place_back(app, start, monkeypatch):
    async def broken(*_: Any) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(runs, "create_run", broken)

    async def break_often() -> int:
        one = Socket(app)
        for _ in range(2 * MOST_RUNS):
            one.ask(**start)
            assert "inside KitRobot" in (await one.until("error"))["message"]
        await one.leave()
        return int(app.state.studio.runs)

    assert coroutines.run(break_often()) == 0


def test_a_run_that_is_taken_back_from_its_end_needs_a_place(app, page, start):
    short = page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]

    async def come_back() -> tuple[str, str]:
        ended = Socket(app)
        ended.ask(**start | {"mission": short, "speed": 0})
        while (await ended.until("state"))["status"] != "done":
            pass
        others = [Socket(app) for _ in range(MOST_RUNS)]
        for one in others:
            one.ask(**start)
            await one.until("started")
        ended.ask(type="seek", tick=0)
        refused = await ended.until("error", "state")
        await others[0].leave()
        ended.ask(type="seek", tick=0)
        again = await ended.until("error", "state")
        for one in [ended, *others[1:]]:
            await one.leave()
        return refused.get("message", ""), again["type"]

    assert coroutines.run(come_back()) == (f"This studio has {MOST_RUNS} runs already.", "state")
