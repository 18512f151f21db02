"""Runs work in the background of the event loop: in a thread, or without threads (WebAssembly) in a call of its own.

A browser may be able to suspend such a call in the middle of Python functions (`set_sleep_function`): then it blocks as
a thread does, and the loop goes on. Only one call runs at a time, until it sleeps or ends, so there is nothing to lock.
Long work that never blocks checks `StopSignal` now and then, and each check lets the loop run for a moment.
Where calls cannot sleep, no message is read until the work is over, and work that must block cannot be started.
"""

from __future__ import annotations

import asyncio
import sys
import threading
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import Any, ParamSpec, TypeVar

from kitrobot.workspace.child_processes import do_without_processes

Params = ParamSpec("Params")
Result = TypeVar("Result")
Sleep = Callable[[Awaitable[Any]], Any]
"""Returns the result of what is awaited; the loop goes on until then."""

YIELD_INTERVAL_S = 0.1
"""Between two moments in which long work lets the loop run."""

_threads = sys.platform != "emscripten"
_sleep: Sleep | None = None


def can_block() -> bool:
    """Whether work in the background can block."""
    return _threads or _sleep is not None


def disable_threads() -> None:
    """Runs everything in the loop of this process from now on, as in WebAssembly."""
    global _threads
    _threads = False
    import anyio.to_thread

    do_without_processes()

    async def in_loop(work: Callable[..., Any], *given: Any, **_: Any) -> Any:
        return await run_in_background(work, *given)

    # What FastAPI and Starlette do with functions that are not `async`.
    anyio.to_thread.run_sync = in_loop  # type: ignore[assignment]


def set_sleep_function(sleep: Sleep | None) -> None:
    """Sets how a function that the loop has called is suspended; None where that is impossible."""
    global _sleep
    _sleep = sleep


async def run_in_background(work: Callable[Params, Result], *args: Params.args, **kwargs: Params.kwargs) -> Result:
    """Runs `work` while the event loop goes on, as far as it can."""
    if _threads:
        return await asyncio.to_thread(work, *args, **kwargs)
    over: asyncio.Future[Result] = asyncio.get_running_loop().create_future()

    def call() -> None:
        try:
            result = work(*args, **kwargs)
        except BaseException as error:
            if not over.cancelled():
                over.set_exception(error)
        else:
            if not over.cancelled():
                over.set_result(result)

    # Not in the task that waits for it: one that sleeps in the middle of a step would hold up all other tasks.
    asyncio.get_running_loop().call_soon(call)
    return await over


class BackgroundTask:
    """Work in a thread, or a call, of its own. It must not raise."""

    def __init__(self, work: Callable[[], None], name: str) -> None:
        if _threads:
            thread = threading.Thread(target=work, name=name, daemon=True)
            thread.start()
            self._join: Callable[[float], object] = thread.join
            return
        condition, over = WakeCondition(), threading.Event()

        def call() -> None:
            try:
                work()
            finally:
                over.set()
                condition.notify_all()

        self._join = lambda within_s: condition.wait_for(over.is_set, within_s)
        asyncio.get_running_loop().call_soon(call)

    def wait(self, within_s: float) -> None:
        """Waits until the task is over, at most `within_s` seconds."""
        self._join(within_s)


class WakeCondition(threading.Condition):
    """A condition for which work in the background waits. The loop itself must not wait for it."""

    def __init__(self) -> None:
        super().__init__()
        self._asleep: list[asyncio.Future[bool]] = []

    def __enter__(self) -> bool:
        return super().__enter__() if _threads else True

    def __exit__(self, *error: Any) -> None:
        if _threads:
            super().__exit__(*error)

    def wait(self, timeout: float | None = None) -> bool:
        """Waits for a notification or the timeout; returns whether it was notified."""
        if _threads:
            return super().wait(timeout)
        assert _sleep is not None, "nothing may be begun that waits"
        loop = asyncio.get_running_loop()
        woken: asyncio.Future[bool] = loop.create_future()
        self._asleep.append(woken)
        late = loop.call_later(max(timeout, 0.0), _wake, woken, False) if timeout is not None else None
        try:
            return bool(_sleep(woken))
        finally:
            if late is not None:
                late.cancel()
            with suppress(ValueError):
                self._asleep.remove(woken)

    def notify(self, n: int = 1) -> None:
        """Wakes waiting work; each checks its own condition."""
        if _threads:
            super().notify(n)
            return
        asleep, self._asleep = self._asleep, []
        for woken in asleep:
            _wake(woken, True)

    def notify_all(self) -> None:
        """Wakes all waiting work."""
        if _threads:
            super().notify_all()
        else:
            self.notify()


def _wake(woken: asyncio.Future[bool], notified: bool) -> None:
    if not woken.done():
        woken.set_result(notified)


class StopSignal(threading.Event):
    """An event that long work checks now and then, to stop when it is set."""

    def __init__(self) -> None:
        super().__init__()
        self._breathed = time.monotonic()

    def is_set(self) -> bool:
        """Whether the event is set; without threads it also lets the loop run for a moment."""
        if not _threads and _sleep is not None and (now := time.monotonic()) - self._breathed > YIELD_INTERVAL_S:
            _sleep(asyncio.sleep(0))
            self._breathed = now
        return super().is_set()
