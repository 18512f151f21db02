"""What is said of a team: who waits at which point for whom."""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.compiler.team.points import PointKind, TeamPlan
from kitrobot.sim.outcome import list_names
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables import team_columns as c
from kitrobot.sim.tables.state import State
from kitrobot.sim.team.meetings import is_left_empty
from kitrobot.text.sentences import Recorded


class TeamText:
    """Words for the state of a team; without a `plan` there is nothing to say."""

    def __init__(self, plan: TeamPlan | None, members: Sequence[Agent]) -> None:
        self._plan = plan
        self._members = members

    def over(self, state: State) -> str:
        """Why the team cannot go on."""
        numbers = state.team.numbers
        assert self._plan is not None
        who = numbers[c.TEAM_OVER_WHO]
        if numbers[c.TEAM_OVER] == c.OVER_ABORT:
            group = list(self._plan.groups)[numbers[c.TEAM_OVER_GROUP]]
            return Recorded("{agent} is missed, without whom {group} does not go on", self._members[who].name, group)
        if numbers[c.TEAM_OVER] == c.OVER_NOBODY:
            return Recorded("nobody is left of it")
        return self._nobody(who)

    def lost_block(self, state: State) -> str:
        """Which block nobody is left of who could do it: all who were in it are missed, the last of them since before
        its end; "" for none.
        """
        points = self._plan.points if self._plan is not None else ()
        team = state.team
        for number, point in enumerate(points):
            members = int(team.points[c.P_MEMBERS][number])
            if point.kind is PointKind.BLOCK and is_left_empty(members, team) and team.emptied[members] - 2 <= number:
                return self._nobody(number)
        return ""

    def _nobody(self, number: int) -> str:
        assert self._plan is not None
        point = self._plan.points[number]
        names = list_names(sorted(point.members))
        return Recorded("nobody is left of {names} at {place}", names, point.vertex or point.program)

    def missing(self, state: State) -> list[str]:
        """Of each point at which robots wait, who waits there and who is missing."""
        if self._plan is None:
            return []
        team = state.team
        waiting = sorted({int(p) for p in team.robots[c.T_AT] if p >= 0})
        found = [self._missing(p, state) for p in waiting]
        return [words for words in found if words]

    def _missing(self, p: int, state: State) -> str:
        team = state.team
        at, inside = team.robots[c.T_AT], team.members[team.points[c.P_MEMBERS][p]]
        here = [one.name for one in self._members if at[one.index] == p]
        absent = [one.name for one in self._members if inside[one.index] and at[one.index] != p]
        if not absent:
            return ""
        assert self._plan is not None
        point = self._plan.points[p]
        if point.vertex is None:
            return Recorded(
                "{waiting}: waiting in {program} for {missing}", list_names(here), point.program, list_names(absent)
            )
        return Recorded(
            "{waiting}: waiting at {vertex} of {program} for {missing}",
            list_names(here),
            point.vertex,
            point.program,
            list_names(absent),
        )
