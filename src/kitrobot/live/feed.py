"""What a page is sent: the newest of each value, when it has taken what came before.

A `Channel` is the way to one page, whatever carries it. A `Feed` sends in a task of its own, so a slow page gets fewer
messages and holds up nobody.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Iterable
from typing import Protocol

Message = str | bytes
Key = tuple[int, str]
"""A value's place in each round, and its name among those of the same place."""


class ChannelClosedError(Exception):
    """The page is gone."""


class Channel(Protocol):
    """The way to a page and back. Each call raises a `ChannelClosedError` once the page is gone."""

    async def receive(self) -> Message:
        """The next message of the page."""

    async def send_text(self, data: str) -> None:
        """Sends a message; comes back when there is room for more."""

    async def send_bytes(self, data: bytes) -> None:
        """Sends a frame; comes back when there is room for more."""


class Feed:
    """Sends one page the values that are put into it, from now until it is closed, finished, or the page is gone.

    A round sends all that waits, in the order of the keys; of what is put under one key only the newest waits.
    `pause_s` is the time between two rounds, in seconds. It belongs to the loop that it was made in.
    """

    def __init__(self, channel: Channel, pause_s: float = 0.0) -> None:
        self._channel = channel
        self._pause_s = pause_s
        self._waiting: dict[Key, Callable[[], Iterable[Message]]] = {}
        self._due = asyncio.Event()
        self._is_finished = False
        self._task = asyncio.create_task(self._serve())

    def put(self, key: Key, encode: Callable[[], Iterable[Message]]) -> None:
        """Queues a value; `encode` gives its messages when its turn comes."""
        self._waiting[key] = encode
        self._due.set()

    def finish(self) -> None:
        """Ends the feed once all that waits is sent."""
        self._is_finished = True
        self._due.set()

    async def wait(self) -> None:
        """Waits until the feed has ended."""
        await asyncio.gather(self._task, return_exceptions=True)

    async def close(self) -> None:
        """Sends no more."""
        self._task.cancel()
        await self.wait()

    async def _serve(self) -> None:
        with contextlib.suppress(ChannelClosedError):
            while self._waiting or not self._is_finished:
                await self._due.wait()
                self._due.clear()
                waiting, self._waiting = self._waiting, {}
                for key in sorted(waiting):
                    for message in waiting[key]():
                        await self._send(message)
                if self._pause_s:
                    await asyncio.sleep(self._pause_s)

    async def _send(self, message: Message) -> None:
        if isinstance(message, bytes):
            await self._channel.send_bytes(message)
        else:
            await self._channel.send_text(message)
