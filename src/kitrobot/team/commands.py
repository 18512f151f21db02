"""The commands that the log of a team decides. All are frozen, small and comparable."""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.team.records import Number, Numbers, Record, TaggedRecord


class Seat(NamedTuple):
    """A member (its number in the charter) in one of its lives; 0 is its first start in a run.

    A process that lost its memory comes back with a larger life, as somebody new, so that no promise is broken.
    """

    member: Number
    life: Number


class ViewChange(TaggedRecord, frozen=True):
    """The view after the one with this number: who leaves it, who joins it."""

    view: Number
    leaves: Numbers
    joins: tuple[Seat, ...]


class Note(TaggedRecord, frozen=True):
    """Numbers of the host's own, which the log puts in order and the tables do not read; reported as `AppliedNote`."""

    numbers: Numbers


Body = ViewChange | Note


class Command(Record, frozen=True):
    """A command; those of one seat are numbered from 1 and take effect once each, in this order."""

    seat: Seat
    number: Number
    body: Body


Batch = tuple[Command, ...]
"""What one slot of the log decides."""
