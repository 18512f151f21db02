"""What a team is before it starts: how many members it has, what they share, how long they wait. It never changes in a
run, and all members have the same. Members are numbered from 0. Times are whole milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass

MOST_MEMBERS = 64


@dataclass(frozen=True, slots=True)
class Charter:
    """A team; `members` is how many it can have, `variables` how many variables they share.

    Attributes:
        lease: ms without an answer after which a member is suspected, and for which the right to act is lent.

    Raises:
        ValueError: a size out of range.
    """

    members: int
    variables: int = 0
    lease: int = 1000

    def __post_init__(self) -> None:
        if not 1 <= self.members <= MOST_MEMBERS or self.lease < 10:
            raise ValueError(f"a team has 1 to {MOST_MEMBERS} members and a lease of 10 ms or more")

    @property
    def beat(self) -> int:
        """Ms from one heartbeat to the next."""
        return self.lease // 8

    @property
    def hold(self) -> int:
        """Ms that a robot in a new place waits: the lease of the one before it, by the slowest clock (an eighth)."""
        return self.lease + self.lease // 8
