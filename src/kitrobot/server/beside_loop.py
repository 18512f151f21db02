"""Work beside the server's event loop: in a thread, and where there are none (WebAssembly) in a call of its own.

A browser may be able to put such a call to sleep in the middle of Python functions (`sleep_with`): then it waits as a
thread does, and the loop goes on meanwhile. Only one call goes on at a time, until it sleeps or ends, so there is
nothing to lock. Long work that waits for nothing looks at `Stop` now and then, and each look lets the loop go on for a
moment. Where calls cannot sleep nothing is heard until the work is over, and what has to wait cannot be begun.
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

Given = ParamSpec("Given")
Result = TypeVar("Result")
Sleep = Callable[[Awaitable[Any]], Any]
"""Comes back with the result of what is awaited, and the loop goes on until then."""

BREATH_S = 0.1
"""Between two moments in which the loop goes on."""

_threads = sys.platform != "emscripten"
_sleep: Sleep | None = None


def has_threads() -> bool:
    """Whether there are threads, and processes, to work in."""
    return _threads


def can_wait() -> bool:
    """Whether work beside the loop can wait for something."""
    return _threads or _sleep is not None


def do_without_threads() -> None:
    """Everything is done in the loop from now on, in this process: as in WebAssembly."""
    global _threads
    _threads = False
    import anyio.to_thread

    do_without_processes()

    async def in_loop(work: Callable[..., Any], *given: Any, **_: Any) -> Any:
        return await beside_loop(work, *given)

    # What FastAPI and Starlette do with functions that are not `async`.
    anyio.to_thread.run_sync = in_loop  # type: ignore[assignment]


def sleep_with(sleep: Sleep | None) -> None:
    """How a function that the loop has called is put to sleep; None where that cannot be."""
    global _sleep
    _sleep = sleep


async def beside_loop(work: Callable[Given, Result], *given: Given.args, **named: Given.kwargs) -> Result:
    """Does it, and others go on meanwhile as far as they can."""
    if _threads:
        return await asyncio.to_thread(work, *given, **named)
    over: asyncio.Future[Result] = asyncio.get_running_loop().create_future()

    def call() -> None:
        try:
            result = work(*given, **named)
        except BaseException as error:
            if not over.cancelled():
                over.set_exception(error)
        else:
            if not over.cancelled():
                over.set_result(result)

    # Not in the task that waits for it: one that sleeps in the middle of a step would hold up all other tasks.
    asyncio.get_running_loop().call_soon(call)
    return await over


class Begun:
    """Work that has a thread, or a call, of its own as long as it lasts. It leaves nothing that it raises."""

    def __init__(self, work: Callable[[], None], name: str) -> None:
        if _threads:
            thread = threading.Thread(target=work, name=name, daemon=True)
            thread.start()
            self._join: Callable[[float], object] = thread.join
            return
        turn, over = Turn(), threading.Event()

        def call() -> None:
            try:
                work()
            finally:
                over.set()
                turn.notify_all()

        self._join = lambda within_s: turn.wait_for(over.is_set, within_s)
        asyncio.get_running_loop().call_soon(call)

    def wait(self, within_s: float) -> None:
        """Waits until it is over, but not for ever."""
        self._join(within_s)


class Turn(threading.Condition):
    """A condition that work beside the loop waits for. In the loop nobody waits for it."""

    def __init__(self) -> None:
        super().__init__()
        self._asleep: list[asyncio.Future[bool]] = []

    def __enter__(self) -> bool:
        return super().__enter__() if _threads else True

    def __exit__(self, *error: Any) -> None:
        if _threads:
            super().__exit__(*error)

    def wait(self, timeout: float | None = None) -> bool:
        """Waits until somebody notifies, or the time is over; whether somebody did."""
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
        """Wakes those that wait; each looks whether it was meant."""
        if _threads:
            super().notify(n)
            return
        asleep, self._asleep = self._asleep, []
        for woken in asleep:
            _wake(woken, True)

    def notify_all(self) -> None:
        """Wakes all that wait."""
        if _threads:
            super().notify_all()
        else:
            self.notify()


def _wake(woken: asyncio.Future[bool], told: bool) -> None:
    if not woken.done():
        woken.set_result(told)


class Stop(threading.Event):
    """What long work asks now and then whether it is to leave off."""

    def __init__(self) -> None:
        super().__init__()
        self._breathed = time.monotonic()

    def is_set(self) -> bool:
        """Whether it is; without threads a moment for the others too."""
        if not _threads and _sleep is not None and (now := time.monotonic()) - self._breathed > BREATH_S:
            _sleep(asyncio.sleep(0))
            self._breathed = now
        return super().is_set()
