"""Whether a team is as a step wants it: the rules of its groups, and its spare robots."""

from __future__ import annotations

from kitrobot.primitives.crew import Crew
from kitrobot.tutorial.model import GroupWant, TeamWant


def team_fits(want: TeamWant, crew: Crew | None) -> bool:
    """Whether the team is so; the `agents` of `crew` are those that run its program."""
    if crew is None:
        return False
    if isinstance(want, GroupWant):
        return any(group.failure == want.failure and want.name in ("", group.name) for group in crew.groups)
    return len(crew.agents) - sum(crew.players) >= want.robots
