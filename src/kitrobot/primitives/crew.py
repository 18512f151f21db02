"""What the programs of a team speak of, and the target that they are read and drawn for.

A team's program calls what the robots of the team have, and its work. For that there is one made-up robot: the union of
the kinds of robot in the team, with an object for each work. Nothing is ever compiled for it; a call that it knows is
looked up once more in the robot that does it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from kitrobot.lll.tree import GroupDeclaration, RoleDeclaration, TeamProgram, WorkDeclaration
from kitrobot.primitives.automatic import work_object
from kitrobot.primitives.levels import Level
from kitrobot.primitives.robot import Category, Method, Robot, RobotObject


@dataclass(frozen=True)
class CrewProgram:
    """A program that a team's program can name: its level, and the kind of robot that it is for ("" for a team's)."""

    name: str
    target: str
    level: Level = Level.AGENT


@dataclass(frozen=True)
class Crew:
    """A team as its programs see it. `agents` are names with the kind of robot of each ("" where it is not known)."""

    agents: tuple[tuple[str, str], ...] = ()
    programs: tuple[CrewProgram, ...] = ()
    roles: tuple[RoleDeclaration, ...] = ()
    groups: tuple[GroupDeclaration, ...] = ()
    works: tuple[WorkDeclaration, ...] = ()

    @property
    def kinds(self) -> list[str]:
        """The kinds of robot in the team, each once."""
        found = [program.target for program in self.programs] + [role.robot for role in self.roles]
        return [kind for kind in dict.fromkeys(found) if kind]

    @property
    def players(self) -> list[int]:
        """For each role, how many robots play it when a run begins.

        Each role in its order takes up to its largest number, but leaves what later roles of its kind need at least.
        """
        free = Counter(kind for _, kind in self.agents)
        found = []
        for at, role in enumerate(self.roles):
            there = free[role.robot]
            later = sum(one.least for one in self.roles[at + 1 :] if one.robot == role.robot)
            found.append(min(there, role.most, max(role.least, there - later)))
            free[role.robot] -= found[-1]
        return found

    def spare(self, kind: str) -> int:
        """How many robots of a kind play no role when a run begins."""
        play = zip(self.roles, self.players, strict=True)
        return sum(own == kind for _, own in self.agents) - sum(n for role, n in play if role.robot == kind)


def declaring(crew: Crew, program: TeamProgram) -> Crew:
    """The same team with what a text declares in the place of its own declarations."""
    return replace(crew, roles=tuple(program.roles), groups=tuple(program.groups), works=tuple(program.works))


def team_robot(crew: Crew, robots: Mapping[str, Robot], level: Level) -> Robot:
    """The target of a team's programs of a level; all robots at hand where the team has none of them."""
    kinds = [robots[kind] for kind in crew.kinds if kind in robots] or list(robots.values())
    works = tuple(work_object(work.name, work.units) for work in crew.works)
    return Robot(
        "",
        _united([robot.actuators for robot in kinds]),
        _united([robot.sensors for robot in kinds]),
        _united([robot.variables for robot in kinds]),
        works + _united([robot.system for robot in kinds]),
        level=level,
    )


def _united(parts: Sequence[tuple[RobotObject, ...]]) -> tuple[RobotObject, ...]:
    """The objects of several robots, those of one name as one with the methods of all."""
    found: dict[tuple[str, Category], RobotObject] = {}
    for part in (part for row in parts for part in row):
        known = found.get((part.name, part.category))
        if known is None:
            found[part.name, part.category] = part
        elif known != part:
            methods = {method.name: method for method in known.methods}
            for method in part.methods:
                methods[method.name] = _both(methods.get(method.name), method)
            found[part.name, part.category] = replace(
                known,
                methods=tuple(methods.values()),
                minimum=min(known.minimum, part.minimum),
                maximum=max(known.maximum, part.maximum),
            )
    return tuple(found.values())


def _both(known: Method | None, method: Method) -> Method:
    """A method of two robots: what is in the range of one of them is in its."""
    if known is None or len(known.parameters) != len(method.parameters):
        return known or method
    parameters = (
        replace(one, minimum=min(one.minimum, other.minimum), maximum=max(one.maximum, other.maximum))
        for one, other in zip(known.parameters, method.parameters, strict=True)
    )
    return replace(known, parameters=tuple(parameters), completes_later=known.completes_later or method.completes_later)
