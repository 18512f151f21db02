"""What the USB of a board says of itself: a number of its own, which stays the same at any port of any machine."""

from __future__ import annotations


def usb_numbers() -> dict[str, str]:
    """The numbers of the boards that are plugged in, by address; "" for a board that has none."""
    from serial.tools import list_ports as usb  # as in `ports`

    return {port.device: port.serial_number or "" for port in usb.comports() if port.vid is not None}
