"""What a mission's robots are on a kit."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.compiler import compile_program, robot_of
from kitrobot.deploy import Package, PartOnKit, look_at_parts
from kitrobot.diagnostics import KitRobotError
from kitrobot.primitives import Kit, config_folder
from kitrobot.workspace.opening import OpenMission
from kitrobot.workspace.robot_programs import board_program


@dataclass(frozen=True)
class ProgramOnKit:
    """A program of a mission on a kit: what becomes of each part of its robot; `problem`: why it cannot be sent."""

    program: str
    robot: str
    parts: tuple[PartOnKit, ...]
    problem: KitRobotError | None


def mission_on_kit(opened: OpenMission, kit: Kit, folder: Path | None = None) -> list[ProgramOnKit]:
    """What becomes of each program of a mission on a kit. Programs of a whole team have no robot, and are left out."""
    beside = folder or (opened.path.parent if opened.path is not None else None)
    package = Package((config_folder(), *([beside] if beside is not None else [])))
    single = [program.name for program in opened.mission.programs if not program.level.is_team]
    return [_looked_at(opened, name, kit, package, beside) for name in single]


def _looked_at(opened: OpenMission, name: str, kit: Kit, package: Package, folder: Path | None) -> ProgramOnKit:
    program = opened.program(name)
    robot = robot_of(program, opened.catalogue)
    compiled = opened.compiled.get(name) or compile_program(program, opened.catalogue)
    problem: KitRobotError | None = None
    try:
        board_program(opened, name, folder, kit)
    except KitRobotError as error:
        problem = error
    return ProgramOnKit(name, robot.name, tuple(look_at_parts(robot, kit, package, compiled.image)), problem)
