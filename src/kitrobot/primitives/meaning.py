"""What a number means to people: its unit with a scale, names for some of its values, and the field that sets it.

Programs, images and traces hold the number itself; only what people see and type is put into other words.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

WAIT_UNIT = "wait-unit"
"""The scale of a number that counts waits: how many seconds one is, the robot says."""

Field = Literal["", "slider", "time", "dial", "ruler", "choices", "lights", "piano", "colour"]
FIELDS = get_args(Field)[1:]
"""The fields that a number can be set with; "" where nothing is said."""

MOST_CHOICES = 64
"""Named values of one number, at most."""


@dataclass(frozen=True)
class Choice:
    """A value with a name, and one picture at most: an icon, five by five lights (digits 0 to 9), or a `#rrggbb`."""

    value: int
    label: Mapping[str, str]
    icon: str = ""
    lights: str = ""
    colour: str = ""


@dataclass(frozen=True)
class Meaning:
    """What a number means.

    `scale`: how many units one is, a decimal number above 0 or `WAIT_UNIT`. `units`: the unit in other languages than
    English, whose word stands beside the number.
    """

    scale: str = "1"
    units: Mapping[str, str] = field(default_factory=dict)
    field: Field = ""
    choices: tuple[Choice, ...] = ()
