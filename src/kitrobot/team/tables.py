"""The tables over the log: what the decided commands have made of the team so far, equal at all members.

Plain values; `applying` is the only code that makes one from another. They are what the hosts read, and what a member
that was away for long is sent.
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Seat


class Answered(NamedTuple):
    """A member that stands at a meeting, and its answer."""

    member: int
    occurrence: int
    answer: int


class Result(NamedTuple):
    """How a meeting ended, the n-th time."""

    occurrence: int
    answer: int


class Meeting(NamedTuple):
    """A meeting: the last announcement of each member, and its last results, in order of occurrence."""

    announced: tuple[Answered, ...] = ()
    results: tuple[Result, ...] = ()


class Unit(NamedTuple):
    """A unit of work: its holder (-1: nobody), how many holders it has had, whether it is done."""

    holder: int
    number: int
    done: bool


class WorkList(NamedTuple):
    """The units of a work, and the members that wait for one, in the order in which they get it."""

    units: tuple[Unit, ...]
    waiting: tuple[int, ...] = ()

    @property
    def left(self) -> int:
        """How many units are not done."""
        return sum(not unit.done for unit in self.units)


class Applied(NamedTuple):
    """Which life of a member the view knows, and its last command that took effect."""

    life: int
    last: int


class View(NamedTuple):
    """Who decides: the seats of a numbered view. A new number also stands for every change of who plays a role."""

    number: int
    seats: tuple[Seat, ...]

    def has(self, member: int) -> bool:
        """Whether the member is in it, in whatever life."""
        return any(seat.member == member for seat in self.seats)


class Tables(NamedTuple):
    """Everything that is agreed.

    Attributes:
        applied: for each member, which of its commands have taken effect.
        groups, players: for each group its members, for each role who plays it, ascending.
        aborted: the group whose failure ends the team; -1: none.
    """

    view: View
    applied: tuple[Applied, ...]
    groups: tuple[tuple[int, ...], ...]
    players: tuple[tuple[int, ...], ...]
    meetings: tuple[Meeting, ...]
    works: tuple[WorkList, ...]
    aborted: int = -1


def first_tables(charter: Charter) -> Tables:
    """The tables before the first decision: all members in their first life, roles to the first that can play them."""
    groups = tuple(tuple(sorted(set(group.members))) for group in charter.groups)
    players: list[tuple[int, ...]] = []
    busy: set[int] = set()
    for role in charter.roles:
        chosen = [m for m in sorted(role.able) if m in groups[role.group] and m not in busy][: role.wanted]
        players.append(tuple(chosen))
        busy.update(chosen)
    return Tables(
        view=View(0, tuple(Seat(member, 0) for member in range(charter.members))),
        applied=(Applied(0, 0),) * charter.members,
        groups=groups,
        players=tuple(players),
        meetings=(Meeting(),) * len(charter.meetings),
        works=tuple(WorkList((Unit(-1, 0, False),) * work.units) for work in charter.works),
    )
