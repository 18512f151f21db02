"""A request that does not come to an end is answered all the same, and holds up no other one."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from typing import Any

import pytest
from fastapi import FastAPI, Request
from starlette.responses import StreamingResponse

from kitrobot.server.deadlines import DeadlineMiddleware
from kitrobot.server.security import refuse
from tests import coroutines
from tests.patience import PATIENCE_S


class Stuck:
    """Routes that wait until they are told to go on."""

    def __init__(self) -> None:
        self.on = threading.Event()
        self.entered = threading.Event()
        self.app = FastAPI()
        self.app.get("/api/disk")(self.disk)
        self.app.get("/api/quick")(self.quick)
        self.app.get("/api/stream")(self.stream)
        self.app.post("/api/body")(self.body)

    def disk(self) -> str:
        self.entered.set()
        self.on.wait(PATIENCE_S)
        raise OSError("the drive is gone")

    async def quick(self) -> str:
        return "quick"

    async def stream(self) -> StreamingResponse:
        async def pieces():
            yield b"one"
            while not self.on.is_set():
                await asyncio.sleep(0)
            yield b"two"

        return StreamingResponse(pieces())

    async def body(self, request: Request) -> int:
        return len(await request.body())


@pytest.fixture
def stuck():
    made = Stuck()
    yield made
    made.on.set()


async def ask(app: Any, path: str, receive: Callable[[], Any] | None = None, method: str = "GET") -> tuple[int, bytes]:
    """Status and body of an answer."""
    said: list[dict[str, Any]] = []

    asked = iter([{"type": "http.request", "body": b"", "more_body": False}])

    async def nothing() -> dict[str, Any]:
        for message in asked:
            return message
        return await asyncio.Future()  # whoever asked stays

    async def send(message: Any) -> None:
        said.append(message)

    scope = {
        "type": "http",
        "method": method,
        "path": path,
        "raw_path": path.encode(),
        "query_string": b"",
        "headers": [],
        "http_version": "1.1",
        "scheme": "http",
        "server": ("127.0.0.1", 80),
        "client": ("127.0.0.1", 1),
    }
    await app(scope, receive or nothing, send)
    return said[0]["status"], b"".join(one.get("body", b"") for one in said)


def test_what_never_ends_is_refused_and_others_are_served(stuck) -> None:
    app = DeadlineMiddleware(stuck.app, refuse, within_s=0.05)

    async def both() -> None:
        slow = asyncio.create_task(ask(app, "/api/disk"))
        while not (stuck.entered.is_set() or slow.done()):
            await asyncio.sleep(0)  # on a busy machine its time may be over before it begins
        assert await ask(DeadlineMiddleware(stuck.app, refuse), "/api/quick") == (200, b'"quick"')
        status, body = await slow
        assert status == 504
        assert b"did not come to the end" in body
        stuck.on.set()  # what it does now is told to nobody

    coroutines.run(both())


def test_while_too_much_is_under_way_the_next_one_is_refused_at_once(stuck) -> None:
    app = DeadlineMiddleware(stuck.app, refuse, within_s=0.05, at_once=1)

    async def both() -> None:
        assert (await ask(app, "/api/disk"))[0] == 504
        status, body = await ask(app, "/api/quick")
        assert status == 503
        assert b"try again in a moment" in body.lower()
        stuck.on.set()
        while (await ask(app, "/api/quick"))[0] == 503:
            await asyncio.sleep(0)  # until the thread has ended

    coroutines.run(both())


def test_an_answer_that_has_begun_is_not_cut(stuck) -> None:
    app = DeadlineMiddleware(stuck.app, refuse, within_s=0.05)

    async def both() -> tuple[int, bytes]:
        answer = asyncio.create_task(ask(app, "/api/stream"))
        done, _ = await asyncio.wait({answer}, timeout=0.2)
        assert not done
        stuck.on.set()
        return await answer

    assert coroutines.run(both()) == (200, b"onetwo")


def test_a_request_that_comes_slowly_is_no_slow_request(stuck) -> None:
    app = DeadlineMiddleware(stuck.app, refuse, within_s=PATIENCE_S)
    pieces = [b"a"] * 50

    async def receive() -> dict[str, Any]:
        await asyncio.sleep(0)
        return {"type": "http.request", "body": pieces.pop(), "more_body": bool(pieces)}

    assert coroutines.run(ask(app, "/api/body", receive, "POST")) == (200, b"50")
