"""The commands that the log of a team decides. All are frozen, small and comparable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class Seat(NamedTuple):
    """A member (its number in the charter) in one of its lives; 0 is its first start in a run.

    A process that lost its memory comes back with a larger life, as somebody new, so that no promise is broken.
    """

    member: int
    life: int


@dataclass(frozen=True, slots=True)
class ViewChange:
    """The view after the one with this number: who leaves it, who joins it."""

    view: int
    leaves: tuple[int, ...]
    joins: tuple[Seat, ...]


@dataclass(frozen=True, slots=True)
class Note:
    """Numbers of the host's own, which the log puts in order and the tables do not read; reported as `AppliedNote`."""

    numbers: tuple[int, ...]


Body = ViewChange | Note


@dataclass(frozen=True, slots=True)
class Command:
    """A command; those of one seat are numbered from 1 and take effect once each, in this order."""

    seat: Seat
    number: int
    body: Body


Batch = tuple[Command, ...]
"""What one slot of the log decides."""
