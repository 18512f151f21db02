"""The events of the model, one kind for each thing that can happen."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from kitrobot.verifier.tables.columns import E_AGENT, E_KIND, E_MASK, E_OTHER
from kitrobot.verifier.tables.motion import Move


class EventKind(IntEnum):
    """The kinds of events besides the moves of robots on roads."""

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
    MISSED = 22
    FREED = 23


TICK, DONE, LOADED, UNLOADED, NO_EMPTY_CARRIER, NO_LOADED_CARRIER, NO_BOX = map(int, list(EventKind)[:7])
FAIL, STALL, RESUME, MUTE, MISSED, FREED = map(int, list(EventKind)[7:])
"""The same as whole numbers, which Numba takes."""

SWINGS = (
    EventKind.LOADED,
    EventKind.UNLOADED,
    EventKind.NO_BOX,
    EventKind.NO_EMPTY_CARRIER,
    EventKind.NO_LOADED_CARRIER,
)
"""The completions of an arm's motion."""
ENDS = (EventKind.DONE, *SWINGS)
"""The completions of actions that take longer than a tick."""


MOST_AT_ONCE = 20_000
"""The most outcomes of one step of a model."""


class ModelTooLargeError(Exception):
    """One step of the model can go in more than `MOST_AT_ONCE` ways: exploring ends there."""


class Event(NamedTuple):
    """An event of an agent, and the other agent, dock or storehouse that takes part (-1: none)."""

    agent: int
    what: Move | EventKind
    other: int = -1


def event_of(number: int) -> Event:
    """Decodes an event from one number (see `columns.E_AGENT`)."""
    kind = number & E_KIND
    what = EventKind(kind) if kind >= EventKind.TICK else Move(kind)
    return Event(number >> E_AGENT & E_MASK, what, (number >> E_OTHER) - 1)
