"""What a program of a team is for each kind of robot, in a mission that was opened."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.model import Program
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.team_objects import with_team
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.robots import find_robot


@dataclass(frozen=True)
class ForKind:
    """A team's program for one kind of robot: `compiled` is None when there are errors, which `diagnostics` tell."""

    robot: Robot
    compiled: CompiledProgram | None
    diagnostics: list[Diagnostic]


def for_kind(opened: OpenMission, program: Program, robot: str) -> ForKind:
    """A team's program for a kind of robot, by its name or file.

    Raises:
        KitRobotError: there is no such robot.
    """
    folder = opened.path.parent if opened.path is not None else None
    known = opened.catalogue.robots.get(robot)
    meant = known if known is not None else find_robot(robot, folder)
    opened.catalogue.robots.setdefault(meant.name, meant)
    made = opened.compile_team(program.name, [meant.name])
    if made is None:
        found = [item for one in opened.compiled.values() for item in one.diagnostics]
        return ForKind(meant, None, found)
    whole = opened.compiled[program.name].diagnostics
    return ForKind(with_team(meant, opened.mission.team.works), made.kinds.get(meant.name), [*whole, *made.diagnostics])
