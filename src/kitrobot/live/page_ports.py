"""Serial ports that a page has opened where its visitor sits (Web Serial), for `kitrobot.deploy` as ports of its own.

The page is a pipe of bytes, also to Python that runs in it (`in_page_server`). A port has an address `page:…`, which is
sent only to the page that holds it; a robot's thread uses it as a port of pyserial, and the server's event loop passes
on the page's messages. Not here: the socket (`page_port_routes`), whose a port is (`robot_registry`).
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import Final, Literal

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.firmware.ports import Port, port_of
from kitrobot.deploy.line.line import open_with
from kitrobot.live.background import WakeCondition
from kitrobot.text.sentences import Sentence

KIND: Final = "page"
MOST_WAITING: Final = 64 * 1024
"""Bytes that wait to be read: the page is not read until there is room; and bytes that wait to be sent."""
OPEN_S: Final = 10.0
"""How long a page may take to open a port: the browser may show a prompt."""
WRITE_S: Final = 10.0
_SLICE_S: Final = 0.02

Send = Callable[[str | bytes], Awaitable[None]]
"""Sends the page bytes for the board, or `open` or `close`."""
Why = Literal["busy", "failed"]
State = Literal["shut", "opening", "open", "gone"]

_ports: dict[str, PagePort] = {}
"""All ports of pages in this process, by address."""


class PagePort:
    """A port at a page, as a robot's thread uses it; the page's messages come from the event loop it was made in."""

    rts = dtr = True
    """The page sets both wires itself when it closes the port."""

    def __init__(self, port: Port, send: Send) -> None:
        self.port = port
        self.called = port.name
        self._send = send
        self._loop = asyncio.get_running_loop()
        self._condition = WakeCondition()
        self._state: State = "shut"
        self._refused: Why | None = None
        self._waiting = bytearray()
        self._unsent = 0
        self._room = asyncio.Event()
        self._room.set()
        self._send_lock = asyncio.Lock()

    # -- from a robot's thread, as pyserial

    def open(self) -> None:
        """Has the page open it.

        Raises:
            LineError: it does not.
        """
        with self._condition:
            if self._state == "gone":
                raise self._unplugged()
            if self._state != "shut":
                raise LineError(
                    Sentence("`{robot}` is in use already", self.port.name), Sentence("wait until it is let go")
                )
            self._state, self._refused = "opening", None
            self._waiting.clear()
        try:
            self._post("open")
            with self._condition:
                self._condition.wait_for(lambda: self._state != "opening" or self._refused is not None, OPEN_S)
                answered, why = self._current_state(), self._refused
            if answered == "gone":
                raise self._unplugged()
            if answered != "open":
                raise _not_opened(self.port.name, why)
        except BaseException:
            self.close()
            raise

    def _current_state(self) -> State:
        """The state now: others have changed it while this thread waited."""
        return self._state

    @property
    def in_waiting(self) -> int:
        """How many bytes can be read at once."""
        with self._condition:
            self._refuse_when_broken()
            return len(self._waiting)

    def read(self, most: int) -> bytes:
        """The received bytes, at most `most`; waits a moment when there are none."""
        until = time.monotonic() + _SLICE_S
        with self._condition:
            while not self._waiting:
                self._refuse_when_broken()
                left = until - time.monotonic()
                if left <= 0:
                    return b""
                self._condition.wait(left)
            data = bytes(self._waiting[:most])
            del self._waiting[:most]
            self._make_room()
            return data

    def write(self, data: bytes) -> None:
        """Has the page send bytes; returns at once, unless the page has not taken earlier bytes."""
        with self._condition:
            self._condition.wait_for(lambda: self._state != "open" or self._unsent <= MOST_WAITING, WRITE_S)
            self._refuse_when_broken()
            if self._unsent > MOST_WAITING:
                raise self._unplugged()
            self._unsent += len(data)
        self._post(bytes(data))

    def flush(self) -> None:
        """Does nothing: bytes are not buffered."""

    def close(self) -> None:
        """Has the page close the port, without waiting."""
        with self._condition:
            if self._state not in ("open", "opening"):
                return
            self._state = "shut"
            self._waiting.clear()
            self._make_room()
        self._post("close")

    def _make_room(self) -> None:
        if not self._room.is_set() and len(self._waiting) < MOST_WAITING:
            self._from_thread(self._room.set)

    def _from_thread(self, work: Callable[[], object]) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(work)

    def _post(self, words: str | bytes) -> None:
        """Sends the page a message without waiting for it."""
        coroutine = self._send_in_order(words)
        try:
            asyncio.run_coroutine_threadsafe(coroutine, self._loop)
        except RuntimeError:  # the studio has ended meanwhile
            coroutine.close()

    async def _send_in_order(self, words: str | bytes) -> None:
        # One after another: a slow page must not get two at once.
        async with self._send_lock:
            # When it has disconnected, its socket reports that.
            with suppress(OSError, RuntimeError):
                await self._send(words)
        if isinstance(words, bytes):
            with self._condition:
                self._unsent -= len(words)
                self._condition.notify_all()

    def _refuse_when_broken(self) -> None:
        if self._state != "open":
            raise self._unplugged()

    def _unplugged(self) -> LineError:
        return LineError(
            Sentence("`{robot}` is not connected to this page any more", self.port.name),
            Sentence("look at its cable; where the page was asleep or closed, choose the board again"),
        )

    # -- from the event loop

    def opened(self) -> None:
        """The page has opened the port."""
        with self._condition:
            if self._state == "opening":
                self._state = "open"
                self._condition.notify_all()

    def refused(self, why: Why) -> None:
        """The page could not open it."""
        with self._condition:
            if self._state == "opening":
                self._refused = why
                self._condition.notify_all()

    def receive_data(self, data: bytes) -> None:
        """Takes bytes of the board; drops them when the port is not open."""
        with self._condition:
            if self._state != "open":
                return
            self._waiting += data
            if len(self._waiting) >= MOST_WAITING:
                self._room.clear()
            self._condition.notify_all()

    async def room(self) -> None:
        """Waits until there is room for more bytes."""
        await self._room.wait()

    def disconnect(self) -> None:
        """Marks the port as gone: the cable is out, or the page has closed."""
        with self._condition:
            self._state = "gone"
            self._condition.notify_all()
        self._room.set()
        if _ports.get(self.port.address) is self:
            del _ports[self.port.address]


def _not_opened(name: str, why: Why | None) -> LineError:
    if why == "busy":
        return LineError(
            Sentence("the browser cannot open `{robot}`: another program or tab has it", name),
            Sentence("close the other tab, the editor or the terminal that uses the board"),
        )
    if why == "failed":
        return LineError(
            Sentence("the browser cannot open `{robot}`", name), Sentence("pull the cable, plug it in, and try again")
        )
    return LineError(
        Sentence("the page did not open `{robot}`", name), Sentence("look at the window in which it was chosen")
    )


def register_port(mark: str, vendor: int, send: Send) -> PagePort | None:
    """Registers a port of a page; None where another port has that mark.

    Args:
        mark: the page's name of the port, which nobody can guess.
        vendor: the number of its vendor on USB, 0 where it has none.
        send: sends the page a message.
    """
    address = f"{KIND}:{mark}"
    if address in _ports:
        return None
    open_with(KIND, _opened)
    made = _ports[address] = PagePort(port_of(address, vendor), send)
    return made


def _opened(address: str) -> PagePort:
    found = _ports.get(address)
    if found is None:
        raise LineError(
            Sentence("the board is not connected to a page any more"),
            Sentence("look at its cable; where the page was asleep or closed, choose the board again"),
        )
    found.open()
    return found
