"""What a trace records of a team: who plays which role and is in which group, who waits where, who is missed.

The numbers stand among those of the whole team, so that they are recorded of all members also where of very many agents
only the poses are. `TracePlan` names what they count.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.compiler.team.points import PointKind, TeamPlan
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables import team_columns as c
from kitrobot.sim.tables.state import State, numbers
from kitrobot.sim.team.meetings import in_group
from kitrobot.trace.model import TEAM, Column, TracePlan, TracePoint

MOST_MEMBERS = 1000
"""Of a larger team nothing is recorded: its numbers would be more than those of its robots."""
WAITING = frozenset((PointKind.MEET, PointKind.ASK, PointKind.COUNT, PointKind.MOVE))
"""Kinds of points at which robots wait for each other."""
_ROWS = (("role", c.T_ROLE), ("seat", c.T_SEAT), ("waits", c.T_AT), ("missed", c.T_MISSED))


class TeamRecord:
    """The columns of a team, and its numbers as they are; of a run without a team's program there is nothing."""

    def __init__(self, plan: TeamPlan | None, roles: Sequence[str], agents: Sequence[Agent], state: State) -> None:
        actuators = state.team.robots[c.T_ACTUATOR]
        members = [one for one in agents if actuators and actuators[one.index] >= 0] if plan is not None else []
        if len(members) > MOST_MEMBERS:
            members = []
        self._members = [one.index for one in members]
        self._groups = len(plan.groups) if plan is not None and members else 0
        words = [word for word, _ in _ROWS] + [f"group {number}" for number in range(self._groups)]
        self.columns = [Column(TEAM, f"{word} of {one.name}") for word in words for one in members]
        self.plan: TracePlan | None = None
        if plan is not None and members:
            points = (
                TracePoint(point.program, point.vertex or "", point.kind in WAITING, tuple(sorted(point.members)))
                for point in plan.points
            )
            self.plan = TracePlan(tuple(one.name for one in members), tuple(roles), tuple(plan.groups), tuple(points))

    def numbers(self, state: State) -> list[int]:
        """The numbers of the columns, in their order."""
        found: list[int] = []
        if self._members:
            team = state.team
            for row in (team.robots[row] for _, row in _ROWS):
                values = numbers(row)
                found += [values[index] for index in self._members]
            for group in range(self._groups):
                found += [int(in_group(index, group, team)) for index in self._members]
        return found
