"""A line to a board: bytes in both directions, over a serial port or any other pyserial URL.

A read waits at most as long as its timeout and returns what has arrived. Exceptions of pyserial become a `LineError`.
Addresses of other kinds are opened by their registered openers (`open_with`).
Left to others: what the bytes mean (repl, receiver, board).
"""

from __future__ import annotations

import contextlib
import errno
import os
import select
import socket
import time
from collections.abc import Callable
from threading import Event
from typing import Any

from kitrobot.deploy.errors import BrokenOffError, LineError
from kitrobot.text.sentences import Help, Sentence, Word

BAUD = 115200
_SLICE_S = 0.02
"""How long one read of the port waits; a fixed number, because to change it means to set the port up anew."""

_AT_ONCE = 4096
MOST = 256 * 1024
"""Bytes that are waited through at most: as much as the flash of a small board."""

LATE_READS = 64
"""How often something is read still when the time is over: what had come before a late look, and not all that a board
says that talks for ever.
"""

_WRITE_S = 10.0
_SILICON_LABS = 0x10C4

Trouble = (OSError, ValueError)
"""Errors of pyserial: its own error is an OSError."""

Opener = Callable[[str], Any]
"""Opens an address; what it gives is used as a port of pyserial is, and may raise a `LineError` of its own."""

_openers: dict[str, Opener] = {}


def open_with(kind: str, opener: Opener) -> None:
    """Addresses that begin with `kind:` are opened by that from now on."""
    _openers[kind] = opener


class Line:
    """An open line.

    Args:
        address: a serial port (`/dev/ttyACM0`, `COM3`), or a pyserial URL (`socket://127.0.0.1:4000`).
        over: once it is set, nothing is waited for any more: reading and writing raise a BrokenOffError.

    Raises:
        LineError: it cannot be opened.
    """

    over: Event | None = None

    def __init__(self, address: str, over: Event | None = None) -> None:
        self.address = address
        self.over = over
        try:
            self.port = _opened(address)
        except Trouble as error:
            raise LineError(
                Sentence("`{address}` cannot be opened: {reason}", address, _reason(error)), _way_out(address, error)
            ) from error
        # What registers its own kind of address may say what people call it.
        self.address = getattr(self.port, "called", address)
        wire = getattr(self.port, "_socket", None)
        self._wire = wire if isinstance(wire, socket.socket) else None
        """The connection of a `socket://` address, which pyserial would read byte by byte."""

    def read(self, timeout_s: float) -> bytes:
        """What has come, at once when there is something, else as soon as it comes; empty when the time is over."""
        until = self.now() + timeout_s
        try:
            while True:
                self._refuse_when_over()
                data = self._come() if self._wire is None else self._received(self._wire)
                if data or self.now() >= until:
                    return data
        except Trouble as error:
            raise self._broken(error) from error

    def _come(self) -> bytes:
        """What has come at the port; empty after a slice of time in which nothing came."""
        data: bytes = self.port.read(1)
        while data and (waiting := self.port.in_waiting) and len(data) < _AT_ONCE:
            data += self.port.read(min(waiting, _AT_ONCE))
        return data

    def _received(self, wire: socket.socket) -> bytes:
        """The same for a connection."""
        ready, _, _ = select.select([wire], [], [], _SLICE_S)
        if not ready:
            return b""
        if data := wire.recv(_AT_ONCE):
            return data
        raise ConnectionResetError(errno.ECONNRESET, os.strerror(errno.ECONNRESET))

    def waiting(self) -> int:
        """How many bytes have come and can be read at once."""
        try:
            return int(self.port.in_waiting)
        except Trouble as error:
            raise self._broken(error) from error

    def write(self, data: bytes) -> None:
        """Sends bytes."""
        self._refuse_when_over()
        try:
            self.port.write(data)
            self.port.flush()
        except Trouble as error:
            raise self._broken(error) from error

    def read_until(self, end: bytes, timeout_s: float) -> bytes:
        """What came up to `end`, or all that came in that time; what came after `end` in the same breath is dropped.

        Who sends for ever is listened to no longer than `MOST` bytes, and than `LATE_READS`.
        """
        until = self.now() + timeout_s
        data = bytearray()
        late = 0
        while len(data) < MOST and late < LATE_READS:
            left = until - self.now()
            late += left <= 0
            piece = self.read(max(left, 0.0))  # what is there is taken, however late we come
            looked = max(0, len(data) - len(end))
            data += piece
            if (at := data.find(end, looked)) >= 0:
                return bytes(data[: at + len(end)])
            if left <= 0 and not piece:
                break
        return bytes(data)

    def drain(self, quiet_s: float, most_s: float = 1.0) -> bytes:
        """Reads what still comes, until it is quiet for a moment."""
        until = self.now() + most_s
        data = b""
        while self.now() < until and len(data) < MOST and (piece := self.read(quiet_s)):
            data += piece
        return data

    def now(self) -> float:
        """The clock by which the line waits, in seconds."""
        return time.monotonic()

    def close(self) -> None:
        """Closes the line; a line that is broken already closes as well."""
        with contextlib.suppress(*Trouble):
            # In this order a board whose reset hangs on these two wires is not reset.
            self.port.rts = False
            self.port.dtr = False
        if self._wire is not None:
            # pyserial would wait a while after it, also when it is collected; nobody reads what was not answered.
            self.port.is_open = False
            self._wire.close()
            return
        with contextlib.suppress(*Trouble):
            self.port.close()

    def _refuse_when_over(self) -> None:
        if self.over is not None and self.over.is_set():
            raise BrokenOffError(Sentence("it was broken off"))

    def _broken(self, error: BaseException) -> LineError:
        return LineError(
            Sentence("the line to `{address}` broke: {reason}", self.address, _reason(error)),
            Sentence("look at the cable, then run the command again"),
        )


def _opened(address: str) -> Any:
    kind, colon, _ = address.partition(":")
    if colon and (opener := _openers.get(kind)) is not None:
        return opener(address)
    import serial  # only who opens a line waits for it, and needs it
    from serial.tools import list_ports

    port = serial.serial_for_url(address, do_not_open=True, baudrate=BAUD, timeout=_SLICE_S, write_timeout=_WRITE_S)
    if "://" not in address:
        port.exclusive = True
        if os.name == "nt" and any(found.vid == _SILICON_LABS for found in list_ports.grep(address)):
            # Its driver sets both wires at different moments, which resets an ESP32: they are set here, in order.
            port.dtr = port.rts = False
            port.open()
            port.dtr = port.rts = True
            return port
    port.open()
    wire = getattr(port, "_socket", None)
    if isinstance(wire, socket.socket):
        # Each of our messages waits for its answer: none may wait for the next.
        wire.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return port


def _reason(error: BaseException) -> str:
    """The last thing that pyserial's error says, without the numbers and names before it."""
    text = getattr(error, "strerror", None) or str(error).strip() or type(error).__name__
    return Word(text.rpartition("] ")[2].partition("\n")[0][:120])


def _way_out(address: str, error: BaseException) -> Help:
    text = str(error)
    if "ermission" in text or "Access is denied" in text:
        return Sentence(
            "another program may hold it; on Linux you must be in the group `dialout` (`sudo adduser $USER dialout`)"
        )
    if "busy" in text or "exclusively lock" in text:
        return Sentence("another program holds it: close the studio, Mu or Thonny where it is open on this board")
    if "://" in address:
        return Sentence("look whether the board is on and in the same network, and whether the address is right")
    return Sentence("look at the cable; `kitrobot boards` lists the boards that are there")
