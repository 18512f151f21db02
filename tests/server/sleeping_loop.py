"""An event loop as a browser with JSPI has it: what it calls may be put to sleep in the middle, and goes on later."""

from __future__ import annotations

import asyncio
import contextvars
from collections.abc import Awaitable, Callable
from typing import Any, TypeVarTuple

from greenlet import getcurrent, greenlet

Given = TypeVarTuple("Given")


class SleepingLoop(asyncio.SelectorEventLoop):
    """Each callback has a stack of its own."""

    def call_soon(
        self,
        callback: Callable[[*Given], object],
        *args: *Given,
        context: contextvars.Context | None = None,
    ) -> asyncio.Handle:
        """As a loop's."""
        its = contextvars.copy_context() if context is None else context
        stack = greenlet(lambda: its.run(callback, *args), parent=_stack_of_loop())
        return super().call_soon(stack.switch, context=contextvars.Context())


def sleep(awaited: Awaitable[Any]) -> Any:
    """Puts the call to sleep in which this is called."""
    here = getcurrent()
    assert here is not _stack_of_loop(), "this call cannot be put to sleep"
    future = asyncio.ensure_future(awaited)
    future.add_done_callback(lambda _: here.switch())
    _stack_of_loop().switch()
    return future.result()


def _stack_of_loop() -> Any:
    found = getcurrent()
    while found.parent is not None:
        found = found.parent
    return found
