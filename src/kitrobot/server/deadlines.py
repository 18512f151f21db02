"""Deadlines for requests: ASGI middleware that refuses what takes too long, and requests beyond a limit.

A request waits for a disk that does not answer, or for more work than anybody has patience for. Its answer is 504, and
long work is cancelled (request_cancellation); any other thread cannot be stopped, so its work goes on, counts as under
way until it ends, and its result is dropped. The time
counts from the last piece of the request that came: a large file over a slow line is no slow request. An answer that
has begun may take as long as its reader does (connections).
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable, Callable

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from kitrobot.text.sentences import Sentence

DEADLINE_S = 120.0
"""How long an answer may keep a page waiting before it begins."""
MOST_AT_ONCE = 500
"""How many requests may be under way, those that were answered with 504 and still go on among them."""

Refuse = Callable[[Scope, Send, int, str, str], Awaitable[None]]

_log = logging.getLogger("kitrobot.server")


class DeadlineMiddleware:
    """`app`, each of whose answers begins within a time. `refuse` answers without it: status, message, help."""

    def __init__(self, app: ASGIApp, refuse: Refuse, within_s: float = DEADLINE_S, at_once: int = MOST_AT_ONCE) -> None:
        self._app = app
        self._refuse = refuse
        self._within_s = within_s
        self._at_once = at_once
        self._under_way: set[asyncio.Task[None]] = set()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serves one request; sockets and the start of the server pass."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
        elif len(self._under_way) >= self._at_once:
            await self._refuse(
                scope,
                send,
                503,
                Sentence("the studio is busy with more requests than it can do at once"),
                Sentence("try again in a moment"),
            )
        else:
            await self._serve(scope, receive, send)

    async def _serve(self, scope: Scope, receive: Receive, send: Send) -> None:
        now = asyncio.get_running_loop().time
        last_received, begun, late = now(), False, False

        async def tracked_receive() -> Message:
            nonlocal last_received
            message = await receive()
            last_received = now()
            return message

        async def tracked_send(message: Message) -> None:
            nonlocal begun
            if not late:
                begun = True
                await send(message)

        task = asyncio.create_task(self._work(scope, tracked_receive, tracked_send))
        self._under_way.add(task)
        task.add_done_callback(self._under_way.discard)
        try:
            while not (task.done() or begun) and (left := last_received + self._within_s - now()) > 0:
                await asyncio.wait({task}, timeout=left)
            if task.done() or begun:
                await task
                return
        except asyncio.CancelledError:
            task.cancel()
            raise
        late = True
        task.add_done_callback(_log_late_failure)
        # Waiting work in a thread is cancelled by this (`request_cancellation`).
        task.cancel()
        _log.warning("%s %s was not answered within %g s", scope["method"], scope["path"], self._within_s)
        await self._refuse(
            scope,
            send,
            504,
            Sentence("the studio did not come to the end of this in time"),
            Sentence("try again; when it stays so, look whether the disk or network drive with the missions answers"),
        )

    async def _work(self, scope: Scope, receive: Receive, send: Send) -> None:
        await self._app(scope, receive, send)


def _log_late_failure(task: asyncio.Task[None]) -> None:
    """Logs the failure of a request that has been answered already."""
    if not task.cancelled() and (error := task.exception()) is not None:
        _log.warning("what was not answered in time failed: %s: %s", type(error).__name__, error)
