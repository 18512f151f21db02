"""What happens in the model, one event after another."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from tests.verifier.reference.motion import Move


class EventKind(IntEnum):
    """What happens besides the moves of robots on roads."""

    TICK = 11
    DONE = 12
    LOADED = 13
    UNLOADED = 14
    NO_EMPTY_CARRIER = 15
    NO_LOADED_CARRIER = 16
    NO_BOX = 17
    FAIL = 18
    STALL = 19
    RESUME = 20
    MUTE = 21


SWINGS = (
    EventKind.LOADED,
    EventKind.UNLOADED,
    EventKind.NO_BOX,
    EventKind.NO_EMPTY_CARRIER,
    EventKind.NO_LOADED_CARRIER,
)
"""An arm came to the end of its motion."""
ENDS = (EventKind.DONE, *SWINGS)
"""What takes longer than a tick came to its end."""


MOST_AT_ONCE = 20_000
"""Ways in which one step of a model can go, at most."""


class ModelTooLargeError(Exception):
    """One step of the model can go in more than `MOST_AT_ONCE` ways: exploring ends there."""


class Event(NamedTuple):
    """Something that happens: to which agent, and where it matters to which other one, dock or storehouse."""

    agent: int
    what: Move | EventKind
    other: int = -1


_CLASSES: dict[Move | EventKind, int] = {EventKind.TICK: 0, Move.BEGIN: 1, **dict.fromkeys(ENDS, 2), Move.ZONE: 3}


def progress(event: Event, agents: int) -> int:
    """The progress class of an event, as a bit (see `timing`); 0 for one that has none."""
    place = _CLASSES.get(event.what, -1)
    return 1 << place * agents + event.agent if place >= 0 else 0
