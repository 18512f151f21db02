"""Boards with MicroPython 1.20 and later: a text of any length is told at once, through mpremote's transport.

They have raw paste mode, which tells the host when to wait, so nothing is lost in a burst. mpremote's class opens its
port itself and says nothing of why it could not; this one takes a line that is open, whatever kind of URL it came from.
"""

from __future__ import annotations

import struct

import serial

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.line import Line
from kitrobot.deploy.repl import GarbledError


def tell_at_once(line: Line, text: str) -> None:
    """Runs a text on a board that stands at the prompt of its raw REPL.

    Raises:
        GarbledError: it did not come through.
        LineError: the line broke.
    """
    # Only who talks to such a board waits for it.
    from mpremote import transport_serial
    from mpremote.transport import TransportError
    from mpremote.transport_serial import SerialTransport

    class OnOpenLine(SerialTransport):  # type: ignore[misc]
        def __init__(self) -> None:
            self.in_raw_repl = True
            self.use_raw_paste = True
            self.device_name = line.address
            self.mounted = False
            self.is_pty = False
            self.serial = line.port

    transport_serial.print = lambda *words: None  # it prints what it did not expect; we try again in another way
    transport = OnOpenLine()
    # Its first step is to look for the prompt, which was read already: a new one is asked for.
    line.write(b"\r\x03\x01")
    try:
        transport.exec(text)
    except serial.SerialException as error:
        raise LineError(f"the line to `{line.address}` broke", "run the command again") from error
    except (TransportError, ValueError, struct.error, IndexError) as error:
        raise GarbledError(str(error)) from error
    line.read_until(b">", 1)
