"""The addresses where boards may be: serial ports on USB, and those in KITROBOT_BOARDS.

Ports are listed without opening them; `handshake` determines what is there.
"""

from __future__ import annotations

import os
from typing import NamedTuple

from kitrobot.deploy.firmware.requirements import DOWNLOADS, EVERYWHERE

BOARDS_VARIABLE = "KITROBOT_BOARDS"


class Port(NamedTuple):
    """A place where a board may be: what to connect to, a short name, what the port says of itself, the page from which
    MicroPython for it is to be had, and the board's own number by its USB, the same at any port. "": not known.
    """

    address: str
    name: str
    description: str
    firmware: str = ""
    number: str = ""


_KNOWN = {
    0x0D28: "micro:bit",
    0x2E8A: "Raspberry Pi Pico",
    0x303A: "ESP32",
    0xF055: "MicroPython board",
    0x239A: "Adafruit board",
    0x2341: "Arduino board",
    0x10C4: "CP210x",
    0x1A86: "CH340",
    0x0403: "FTDI",
}
"""USB vendors → what their boards are called; of the last three, the chip is on boards of many makers."""


def port_of(address: str, vendor: int | None, product: str = "", description: str = "", number: str = "") -> Port:
    """A port on USB as it is listed, by the number of its vendor."""
    name = _KNOWN.get(vendor or 0, product or "USB serial")
    return Port(address, name, description, DOWNLOADS.get(vendor or 0, EVERYWHERE), number)


def list_ports() -> list[Port]:
    """The places where boards may be, in the order of their addresses; those of KITROBOT_BOARDS last."""
    from serial.tools import list_ports as usb  # only who looks for ports needs it

    found = [
        port_of(port.device, port.vid, port.product or "", port.description or "", port.serial_number or "")
        for port in usb.comports()
        if port.vid is not None
    ]
    found.sort()
    known = {port.address for port in found}
    named = dict.fromkeys(os.environ.get(BOARDS_VARIABLE, "").split())
    return [*found, *(Port(address, "named", BOARDS_VARIABLE) for address in named if address not in known)]
