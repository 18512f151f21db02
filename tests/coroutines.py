"""Coroutines run to their end from a test, whichever tests its worker ran before."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

T = TypeVar("T")


def run(coroutine: Coroutine[Any, Any, T]) -> T:
    """What the coroutine returns, or raises.

    It runs in a thread of its own: once a worker has opened its browser, Playwright's loop counts as
    running in the worker's thread, and `asyncio.run` is refused there.
    """
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, coroutine).result()
