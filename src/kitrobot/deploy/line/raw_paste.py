"""Boards with MicroPython 1.20 and later: a text of any length is sent at once, through mpremote's transport.

They have raw paste mode with flow control, so nothing is lost in a burst. mpremote's class opens its port itself and
hides why that failed; this one takes a line that is open, of any kind of URL.
"""

from __future__ import annotations

import struct
from typing import Any

from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.repl import GarbledError

_PATIENCE_S = 2.0
"""Silence after which something was lost; the text is sent in another way then."""

_PACES = 10
_MOST = 16_000
"""Bytes of an answer, at most: a board that sends for ever sends more."""


def run_by_raw_paste(line: Line, text: str, pace_s: float = 0.0) -> None:
    """Runs a text on a board that stands at the prompt of its raw REPL, and needs `pace_s` seconds for a reset.

    Raises:
        GarbledError: it did not come through.
        LineError: the line broke.
    """
    # Only who talks to such a board waits for it.
    from mpremote import transport_serial
    from mpremote.transport import TransportError
    from mpremote.transport_serial import SerialTransport

    port = _BufferedPort(line, max(_PATIENCE_S, _PACES * pace_s))

    class OnOpenLine(SerialTransport):  # type: ignore[misc]
        def __init__(self) -> None:
            self.in_raw_repl = True
            self.use_raw_paste = True
            self.device_name = line.address
            self.mounted = False
            self.is_pty = False
            self.serial = port

        def read_until(self, min_num_bytes: int, ending: bytes, *times: float | None, **more: Any) -> bytes:
            return port.read_until(ending)  # mpremote looks every 10 ms whether something came, for 10 s

    transport_serial.print = lambda *words: None  # it prints what it did not expect; we try again in another way
    transport = OnOpenLine()
    # Its first step is to look for the prompt, which was read already: a new one is asked for.
    line.write(b"\r\x03\x01")
    try:
        transport.exec(text)
    except (TransportError, ValueError, struct.error, IndexError) as error:
        raise GarbledError(str(error)) from error
    if b">" not in port.left:
        line.read_until(b">", 1)


class _BufferedPort:
    """The port of a line as mpremote reads it, which takes it for an error when a byte is not there at once."""

    def __init__(self, line: Line, patience_s: float) -> None:
        self.line = line
        self.patience_s = patience_s
        self.left = b""

    def read(self, count: int) -> bytes:
        """So many bytes, or fewer when no more come."""
        until = self.line.now() + self.patience_s
        while len(self.left) < count and (wait := until - self.line.now()) > 0:
            self.left += self.line.read(wait)
        found, self.left = self.left[:count], self.left[count:]
        return found

    def read_until(self, end: bytes) -> bytes:
        """What comes up to `end`, or all that came before a silence."""
        data = b""
        while not data.endswith(end) and len(data) < _MOST and (byte := self.read(1)):
            data += byte
        return data

    def write(self, data: bytes) -> Any:
        """Sends bytes."""
        self.line.write(data)

    def inWaiting(self) -> int:
        """How many bytes can be read at once."""
        return len(self.left) + self.line.waiting()
