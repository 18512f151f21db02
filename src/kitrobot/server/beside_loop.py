"""Work beside the server's event loop: in a thread, and where there are none (WebAssembly) in the loop itself.

Without threads whoever works long holds everybody up. So such work looks at `stop` now and then, as it does in a
thread, and each look lets the loop go on for a moment, where the browser can put a Python function to sleep
(`breathe_with`); where it cannot, nothing is heard until the work is over.
"""

from __future__ import annotations

import asyncio
import sys
import threading
import time
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from kitrobot.workspace.child_processes import do_without_processes

Given = ParamSpec("Given")
Result = TypeVar("Result")

BREATH_S = 0.1
"""Between two moments in which the loop goes on."""

_threads = sys.platform != "emscripten"
_breathe: Callable[[], None] | None = None


def has_threads() -> bool:
    """Whether there are threads, and processes, to work in."""
    return _threads


def do_without_threads() -> None:
    """Everything is done in the loop from now on, in this process: as in WebAssembly."""
    global _threads
    _threads = False
    import anyio.to_thread

    do_without_processes()

    async def in_loop(work: Callable[..., Any], *given: Any, **_: Any) -> Any:
        return work(*given)

    # What FastAPI and Starlette do with functions that are not `async`.
    anyio.to_thread.run_sync = in_loop  # type: ignore[assignment]


def breathe_with(breathe: Callable[[], None] | None) -> None:
    """`breathe` lets the loop go on and comes back; it is called in the middle of Python functions."""
    global _breathe
    _breathe = breathe


async def beside_loop(work: Callable[Given, Result], *given: Given.args, **named: Given.kwargs) -> Result:
    """Does it, and others go on meanwhile as far as they can."""
    if _threads:
        return await asyncio.to_thread(work, *given, **named)
    await asyncio.sleep(0)
    return work(*given, **named)


class Stop(threading.Event):
    """What long work asks now and then whether it is to leave off."""

    def __init__(self) -> None:
        super().__init__()
        self._breathed = time.monotonic()

    def is_set(self) -> bool:
        """Whether it is; without threads a moment for the others too."""
        if not _threads and _breathe is not None and (now := time.monotonic()) - self._breathed > BREATH_S:
            _breathe()
            self._breathed = now
        return super().is_set()
