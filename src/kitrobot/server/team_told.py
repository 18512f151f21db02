"""What the page is told of a team: who is in which role and group, and of each point at which robots wait who is there.

It comes from the numbers of a record (`TracePlan`), so a run that is on and a recording are told alike. Numbers of a
recording may be anything: one that counts nothing is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kitrobot.server.shapes import MeetingShape, MemberShape, TeamNowShape
from kitrobot.trace import TEAM, TraceHeader, TracePoint

MOST_NAMED = 100
"""Names of robots that are told of one meeting; the rest are counted."""


class TeamTold:
    """What is told of a team's numbers; of a run without a team's program there is nothing to tell."""

    def __init__(self, header: TraceHeader) -> None:
        self._plan = header.plan
        self._agents = [agent.name for agent in header.agents]
        self._before: tuple[int, ...] | None = None
        self._places: list[int] = []
        if header.plan is not None:
            words = ["role", "seat", "waits", "missed", *(f"group {n}" for n in range(len(header.plan.groups)))]
            at = {column.name: place for place, column in enumerate(header.columns) if column.owner == TEAM}
            wanted = [f"{word} of {name}" for word in words for name in header.plan.members]
            if all(name in at for name in wanted):
                self._places = [at[name] for name in wanted]

    def now(self, row: Sequence[int]) -> dict[str, Any] | None:
        """Who is where, in the shape of `TeamNowShape`; None where there is no team."""
        plan = self._plan
        if plan is None or not self._places:
            return None
        count = len(plan.members)
        values = [row[place] for place in self._places]
        role, seat, waits, missed, *groups = [values[at : at + count] for at in range(0, len(values), count)]
        members = [
            MemberShape(
                name=name,
                role=plan.roles[role[i]] if 0 <= role[i] < len(plan.roles) else "",
                groups=[group for group, inside in zip(plan.groups, groups, strict=True) if inside[i]],
                stands_for=self._agents[seat[i]] if 0 <= seat[i] < len(self._agents) else "",
                missed=missed[i] == 1,
            )
            for i, name in enumerate(plan.members)
        ]
        places = sorted({point for point in waits if 0 <= point < len(plan.points)})
        meetings = [
            _meeting(number, plan.points[number], members, waits, plan.groups)
            for number in places
            if plan.points[number].waits
        ]
        return TeamNowShape(members=members, groups=list(plan.groups), meetings=meetings).model_dump(mode="json")

    def news(self, row: Sequence[int]) -> dict[str, Any] | None:
        """The same where it is not what was told the last time; None where it is."""
        numbers = tuple([row[place] for place in self._places])
        if numbers == self._before:
            return None
        self._before = numbers
        return self.now(row)


def _meeting(
    number: int,
    point: TracePoint,
    members: Sequence[MemberShape],
    waits: Sequence[int],
    groups: Sequence[str],
) -> MeetingShape:
    here = [one.name for one, at in zip(members, waits, strict=True) if at == number]
    awaited = [one.name for one in members if _comes(one, point, groups)]
    missing = [name for name in awaited if name not in here]
    return MeetingShape(
        point=number,
        program=point.program,
        vertex=point.vertex,
        here=here[:MOST_NAMED],
        missing=missing[:MOST_NAMED],
        here_count=len(here),
        count=len(here) + len(missing),
    )


def _comes(member: MemberShape, point: TracePoint, groups: Sequence[str]) -> bool:
    """Whether a member is one of those who come to a point: a group is meant before a role, a role before an agent."""
    if not member.role:
        return False
    return not point.members or any(
        name in member.groups if name in groups else name == member.role or name == member.stands_for
        for name in point.members
    )
