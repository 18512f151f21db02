"""Cancels the long work of a request when its client disconnects."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TypeVar

from fastapi import Request

from kitrobot.live.background import StopSignal, run_in_background

Result = TypeVar("Result")


async def run_until_disconnect(
    request: Request, work: Callable[[StopSignal], Result], stop: StopSignal | None = None
) -> Result:
    """Runs the work in the background. `stop` is set when the client disconnects and when the studio ends; the work
    checks it now and then.

    Raises:
        Exception: what the work raises.
    """
    stop = stop or StopSignal()
    disconnect = asyncio.create_task(_stop_on_disconnect(request, stop))
    running = asyncio.ensure_future(run_in_background(work, stop))
    try:
        return await asyncio.shield(running)
    finally:
        stop.set()
        disconnect.cancel()
        # Nothing that it uses is released before it has ended.
        await asyncio.gather(running, return_exceptions=True)


async def _stop_on_disconnect(request: Request, stop: StopSignal) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
    stop.set()
