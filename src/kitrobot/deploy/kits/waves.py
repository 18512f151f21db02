"""Square waves of a kit's pins that its chip cannot give at once.

On the RP2040 and the RP2350 pins share the parts that make waves (slices): two pins of a slice have one frequency, and
pins that are 16 apart have one wave. A driver declares at its top level which of its settings name such pins,

    WAVES = {"pin": "50", "left-forward": "frequency !left-power"}

with the frequency in Hz (0: one that changes) or the setting that says it; `!name` or `!name=value`: it is no wave
where that is given.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

SLICES: Mapping[str, Callable[[int], int]] = {
    "rp2040": lambda pin: pin >> 1 & 7,
    "rp2350": lambda pin: pin >> 1 & 7 if pin < 32 else 8 + (pin >> 1 & 3),
}
"""Kind of chip → the slice of a pin."""


class Wave(NamedTuple):
    """A square wave at a pin, in Hz, 0 for one that changes."""

    pin: int
    frequency: int


def waves_of(said: Mapping[str, str], settings: Mapping[str, str], usual: Mapping[str, str]) -> list[Wave]:
    """The waves of a part: `said` as its driver does, `usual` values of settings that are not given."""
    found = []
    for name, words in said.items():
        pin, (first, *unless) = settings.get(name, ""), words.split()
        if not pin.isdecimal() or any(_is_given(word[1:], settings) for word in unless):
            continue
        hertz = first if first.isdecimal() else settings.get(first, usual.get(first, ""))
        if hertz.isdecimal():
            found.append(Wave(int(pin), int(hertz)))
    return found


def _is_given(word: str, settings: Mapping[str, str]) -> bool:
    name, _, value = word.partition("=")
    return name in settings and (not value or settings[name] == value)


def clash(one: Wave, other: Wave, chip: str) -> str:
    """Why a chip cannot give both waves: `wave` they would be one, `frequency` they would have one; "" for it can."""
    slice_of = SLICES[chip]
    if one.pin == other.pin or slice_of(one.pin) != slice_of(other.pin):
        return ""
    if one.pin % 2 == other.pin % 2:
        return "wave"
    return "frequency" if one.frequency != other.frequency or not one.frequency else ""
