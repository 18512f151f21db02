"""Notes that a robot of a fleet puts into the log of its team (`team.Note`): numbers that a `Replica` reads.

A note is `(kind, epoch, first, second, serial)`. The epoch is that of the robot it speaks of, as its sender knew it:
notes from before its team missed it have no effect afterwards. The serial makes the notes of one seat different.
"""

from __future__ import annotations

from typing import NamedTuple

COME, TAKE, DONE, FREE, END = range(5)
"""The robot comes to point `first` with the answer `second`; it wants a unit of work `first`; that unit is done; the
unit that robot `second` has of work `first` is free again, for its lease is over; the robot's program is at its end."""


class ReplicatedNote(NamedTuple):
    """A note as it is in the log."""

    kind: int
    epoch: int
    first: int
    second: int
    serial: int


def decode_note(numbers: tuple[int, ...]) -> ReplicatedNote | None:
    """The note that the numbers are; None for anything else."""
    if len(numbers) != len(ReplicatedNote._fields) or not COME <= numbers[0] <= END:
        return None
    return ReplicatedNote(*numbers)
