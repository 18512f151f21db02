"""Work that takes long, asked for by a request: it is broken off when nobody waits for the answer any more."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TypeVar

from fastapi import Request

from kitrobot.server.beside_loop import Stop, beside_loop

Result = TypeVar("Result")


async def work_for(request: Request, work: Callable[[Stop], Result], stop: Stop | None = None) -> Result:
    """Does the work beside the loop. `stop` is set when the page hangs up and when the studio ends; the work looks at
    it now and then.

    Raises:
        Exception: what the work raises.
    """
    stop = stop or Stop()
    listening = asyncio.create_task(_stop_at_hanging_up(request, stop))
    working = asyncio.ensure_future(beside_loop(work, stop))
    try:
        return await asyncio.shield(working)
    finally:
        stop.set()
        listening.cancel()
        # What it uses is not taken away before it has left off.
        await asyncio.gather(working, return_exceptions=True)


async def _stop_at_hanging_up(request: Request, stop: Stop) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
    stop.set()
