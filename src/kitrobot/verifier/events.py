"""What happens in the model, one event after another."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from kitrobot.verifier.motion import Move


class What(Enum):
    """What happens besides the moves of robots on roads."""

    TICK = "tick"
    DONE = "done"
    LOADED = "loaded"
    UNLOADED = "unloaded"
    NO_EMPTY_CARRIER = "no empty carrier"
    NO_LOADED_CARRIER = "no loaded carrier"
    NO_BOX = "no box"
    FAIL = "fail"
    STALL = "stall"
    RESUME = "resume"


SWINGS = (What.LOADED, What.UNLOADED, What.NO_BOX, What.NO_EMPTY_CARRIER, What.NO_LOADED_CARRIER)
"""An arm came to the end of its motion."""
ENDS = (What.DONE, *SWINGS)
"""What takes longer than a tick came to its end."""


MOST_AT_ONCE = 20_000
"""Ways in which one step of a model can go, at most."""


class TooManyError(Exception):
    """One step of the model can go in more than `MOST_AT_ONCE` ways: exploring ends there."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happens: to which agent, and where it matters to which other one, dock or storehouse."""

    agent: int
    what: Move | What
    other: int = -1
