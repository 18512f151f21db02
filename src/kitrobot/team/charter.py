"""What a team is before it starts: members, roles, groups, meetings, work, shared variables. It never changes in a run.

Everything is numbered by its place in its tuple, and messages name things by these numbers. All members of a team
have the same charter. Times are whole milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Failure = Literal["drop", "substitute", "abort"]
Quantifier = Literal["any", "all", "most"]

MOST_MEMBERS = 64
MOST_UNITS = 4096


@dataclass(frozen=True, slots=True)
class Role:
    """Something that `wanted` members of a group do at any moment, and that only the members `able` can do."""

    able: tuple[int, ...]
    wanted: int
    group: int


@dataclass(frozen=True, slots=True)
class Group:
    """Its members at the start, and what happens when one of them leaves the team.

    `drop`: the others go on without it; `substitute`: a member without a role takes its roles, if one is able to;
    `abort`: the team is told to end. A member that comes back is a spare: in no group, without a role.
    """

    members: tuple[int, ...]
    failure: Failure = "drop"


@dataclass(frozen=True, slots=True)
class Move:
    """So many members of one group go over to another."""

    source: int
    target: int
    count: int


@dataclass(frozen=True, slots=True)
class MeetingRule:
    """Who takes part in a meeting (the members of these groups), how answers are combined, what it moves at its end.

    Moves are a part of the end of a meeting, so each is made once however many members ask for it.
    """

    groups: tuple[int, ...]
    quantifier: Quantifier = "all"
    moves: tuple[Move, ...] = ()


@dataclass(frozen=True, slots=True)
class Work:
    """So many units of work; one that is not done `lease` ms after it was taken is free again (0: never)."""

    units: int
    lease: int = 0


@dataclass(frozen=True, slots=True)
class Charter:
    """A team; `members` is how many it can have, `variables` how many variables they share.

    Attributes:
        lease: ms without an answer after which a member is suspected, and for which a right to act is lent.

    Raises:
        ValueError: a size out of range; a number of a member, group or role that does not exist.
    """

    members: int
    roles: tuple[Role, ...] = ()
    groups: tuple[Group, ...] = ()
    meetings: tuple[MeetingRule, ...] = ()
    works: tuple[Work, ...] = ()
    variables: int = 0
    lease: int = 1000

    def __post_init__(self) -> None:
        members = [m for role in self.roles for m in role.able] + [m for group in self.groups for m in group.members]
        groups = [role.group for role in self.roles] + [g for meeting in self.meetings for g in meeting.groups]
        groups += [g for meeting in self.meetings for move in meeting.moves for g in (move.source, move.target)]
        if not 1 <= self.members <= MOST_MEMBERS or self.lease < 10:
            raise ValueError(f"a team has 1 to {MOST_MEMBERS} members and a lease of 10 ms or more")
        if any(not 0 <= m < self.members for m in members) or any(not 0 <= g < len(self.groups) for g in groups):
            raise ValueError("a charter names a member or group that it does not have")
        if any(not 0 <= work.units <= MOST_UNITS for work in self.works):
            raise ValueError(f"work has at most {MOST_UNITS} units")

    @property
    def beat(self) -> int:
        """Ms from one heartbeat to the next."""
        return self.lease // 8

    @property
    def hold(self) -> int:
        """Ms that a new player of a role waits: the lease of the one before it, by the slowest clock (an eighth)."""
        return self.lease + self.lease // 8
