"""Pins of chips that cannot be used for everything."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.package.declarations import Wire
from kitrobot.text.sentences import Sentence

_READ = frozenset({"echo"})
"""Settings that are only read, though other parts may not be wired to their pins as to those of an `input`."""


@dataclass(frozen=True)
class Pins:
    """Pins of a chip: those that can only be read and have no pull-up, those of the line to the computer, and those of
    its flash.
    """

    read_only: frozenset[str] = frozenset()
    serial: frozenset[str] = frozenset()
    flash: frozenset[str] = frozenset()


def _numbers(*ranges: range) -> frozenset[str]:
    return frozenset(str(number) for one in ranges for number in one)


PINS: Mapping[str, Pins] = {
    # Espressif: ESP32 Series Datasheet, "Pin Overview", and GPIO & RTC GPIO in the ESP-IDF Programming Guide.
    "esp32": Pins(read_only=_numbers(range(34, 40)), serial=frozenset({"1", "3"}), flash=_numbers(range(6, 12))),
}
"""Kind of chip → its pins that are not like the others."""

PLATFORMS: Mapping[str, str] = {"rp2040": "rp2", "rp2350": "rp2", "esp32": "esp32"}
"""Kind of chip → what MicroPython on it calls its platform."""


def refuse_pin(part: str, wire: Wire, chip: str) -> None:
    """Raises a PackageError when a chip's pin cannot do what a part is wired to it for."""
    pins = PINS.get(chip)
    if pins is None or not wire.setting.is_pin:
        return
    help = Sentence("take another pin")
    if wire.target in pins.serial:
        raise PackageError(
            Sentence(
                "`{part}` is wired to the pin `{pin}`, over which the board talks with the computer", part, wire.target
            ),
            help,
        )
    if wire.target in pins.flash:
        raise PackageError(
            Sentence(
                "`{part}` is wired to the pin `{pin}`, which belongs to the flash of this chip", part, wire.target
            ),
            help,
        )
    if wire.target in pins.read_only and wire.setting.joined != "input" and wire.name not in _READ:
        raise PackageError(
            Sentence(
                "`{part}` is wired to the pin `{pin}`, which can only be read and has no pull-up", part, wire.target
            ),
            help,
        )
