"""Encodes the state of a team for the page: roles, groups, and who is at each point at which robots wait.

It is read from the numbers of a record (`TracePlan`), so a live run and a recording are encoded alike. Numbers of a
recording may be anything: one without a meaning is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kitrobot.trace.model import TEAM, TraceHeader, TracePoint
from kitrobot.wire.run import MeetingShape, MemberShape, TeamNowShape

MAX_NAMES = 100
"""Names of robots that are sent for one meeting; the rest are counted."""


class TeamSnapshotEncoder:
    """Encodes a team's numbers; a run without a team's program has no snapshot."""

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

    def encode(self, row: Sequence[int]) -> dict[str, Any] | None:
        """The snapshot, in the shape of `TeamNowShape`; None where there is no team."""
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

    def encode_if_changed(self, row: Sequence[int]) -> dict[str, Any] | None:
        """The snapshot, or None where it is the same as at the last call."""
        numbers = tuple([row[place] for place in self._places])
        if numbers == self._before:
            return None
        self._before = numbers
        return self.encode(row)


def _meeting(
    number: int,
    point: TracePoint,
    members: Sequence[MemberShape],
    waits: Sequence[int],
    groups: Sequence[str],
) -> MeetingShape:
    here = [one.name for one, at in zip(members, waits, strict=True) if at == number]
    awaited = [one.name for one in members if _is_expected_at(one, point, groups)]
    missing = [name for name in awaited if name not in here]
    return MeetingShape(
        point=number,
        program=point.program,
        vertex=point.vertex,
        here=here[:MAX_NAMES],
        missing=missing[:MAX_NAMES],
        here_count=len(here),
        count=len(here) + len(missing),
    )


def _is_expected_at(member: MemberShape, point: TracePoint, groups: Sequence[str]) -> bool:
    """Whether a point awaits a member: a name means a group before a role, a role before an agent."""
    if not member.role:
        return False
    return not point.members or any(
        name in member.groups if name in groups else name == member.role or name == member.stands_for
        for name in point.members
    )
