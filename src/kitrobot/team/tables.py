"""The tables over the log: what the decided commands have made of the view so far, equal at all members.

Plain values; only `table_transitions` makes one from another. A member that was away for long is sent them. The host
makes everything else that is agreed from the notes of the log (`fleet.replica`).
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Seat
from kitrobot.team.records import Number


class LastCommand(NamedTuple):
    """Which life of a member the view knows, and its last command that took effect."""

    life: Number
    last: Number


class View(NamedTuple):
    """Who decides: the seats of a numbered view."""

    number: Number
    seats: tuple[Seat, ...]


class Tables(NamedTuple):
    """Everything that the protocol agrees on by itself; `applied`: for each member, which of its commands have taken
    effect.
    """

    view: View
    applied: tuple[LastCommand, ...]


def initial_tables(charter: Charter) -> Tables:
    """The tables before the first decision: all members in their first life."""
    seats = tuple(Seat(member, 0) for member in range(charter.members))
    return Tables(View(0, seats), (LastCommand(0, 0),) * charter.members)
