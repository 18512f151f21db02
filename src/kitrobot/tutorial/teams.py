"""Whether a team is as a step wants it: the rules of its groups, and its spare robots."""

from __future__ import annotations

from kitrobot.primitives import Crew
from kitrobot.tutorial.model import GroupWant, TeamWant


def team_fits(want: TeamWant, crew: Crew | None) -> bool:
    """Whether the team is so; the `agents` of `crew` are those that run its program."""
    if crew is None:
        return False
    if isinstance(want, GroupWant):
        return any(group.failure == want.failure and want.name in ("", group.name) for group in crew.groups)
    return spare(crew) >= want.robots


def spare(crew: Crew) -> int:
    """How many robots play no role when a run begins.

    Each role in its order takes up to its largest number, but leaves what later roles of its kind need at least.
    """
    free: dict[str, int] = {}
    for _, kind in crew.agents:
        free[kind] = free.get(kind, 0) + 1
    for at, role in enumerate(crew.roles):
        there = free.get(role.robot, 0)
        later = sum(one.least for one in crew.roles[at + 1 :] if one.robot == role.robot)
        free[role.robot] = there - min(there, role.most, max(role.least, there - later))
    return sum(free.values())
