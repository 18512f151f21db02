"""What a mission's robots are on a kit."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from kitrobot.boards.programs import board_program, load_board_program
from kitrobot.boards.teams import agent_program
from kitrobot.compiler.compilation import CompiledProgram, compile_program, compile_text
from kitrobot.compiler.target import robot_of
from kitrobot.deploy.kits.kits import PartOnKit, parts_on_kit
from kitrobot.deploy.package.package import Package
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import read_text
from kitrobot.graph.model import Program
from kitrobot.primitives.kit import Kit, lacks
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.primitives.team_objects import with_team
from kitrobot.user_folders import config_folder
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.robots import find_robot


@dataclass(frozen=True)
class ProgramOnKit:
    """A program of a mission on a kit: what becomes of each part of its robot; `problem`: why it cannot be sent."""

    program: str
    robot: str
    parts: tuple[PartOnKit, ...]
    problem: KitRobotError | None


def mission_on_kit(opened: OpenMission, kit: Kit, folder: Path | None = None) -> list[ProgramOnKit]:
    """What becomes of each program of a mission on a kit; of a whole team's program, for each kind of its robots."""
    beside = folder or (opened.path.parent if opened.path is not None else None)
    package = Package((config_folder(), *([beside] if beside is not None else [])))
    found = []
    for program in opened.mission.programs:
        if program.level.is_team:
            agents = {agent.robot: agent.name for agent in opened.mission.team.agents if agent.program == program.name}
            for kind, agent in agents.items():
                robot = with_team(opened.catalogue.robots[kind], opened.mission.team.works)
                compiled = opened.team.kinds.get(kind) if opened.team is not None else None
                problem = _why_not(partial(agent_program, opened, agent, beside, kit))
                found.append(_program_on_kit(program.name, robot, compiled, kit, package, problem))
        else:
            found.append(_on_kit(opened, program, kit, beside, package))
    return found


def absent_parts(robot: Robot, kit: Kit) -> list[RobotObject]:
    """The actuators and sensors of a robot that a kit has nothing for."""
    return [part for part in (*robot.actuators, *robot.sensors) if lacks(kit, part)]


def text_on_kit(path: Path, robot: str, kit: Kit) -> ProgramOnKit:
    """What becomes of the program of a text in LLL on a kit; `robot`: its name or its file.

    Raises:
        KitRobotError: the text or the robot cannot be read.
    """
    meant = find_robot(robot, path.parent)
    compiled = compile_text(read_text(path), meant, str(path))
    problem = _why_not(lambda: load_board_program(path, robot=robot, built_of=kit))
    package = Package((config_folder(), path.parent))
    return _program_on_kit(path.stem, meant, compiled, kit, package, problem)


@dataclass(frozen=True)
class KitFit:
    """Whether a program runs on a kit: the used parts that the kit lacks, and why it cannot be sent, or None."""

    kit: str
    missing: tuple[RobotObject, ...]
    problem: KitRobotError | None


def program_on_kits(opened: OpenMission, program: str, kits: Iterable[Kit], folder: Path | None = None) -> list[KitFit]:
    """Whether one program of a mission runs as its robot's own file says (the kit ""), and on each of the kits.

    Raises:
        KitRobotError: the mission has no such program.
    """
    meant = opened.program(program)
    beside = folder or (opened.path.parent if opened.path is not None else None)
    package = Package((config_folder(), *([beside] if beside is not None else [])))
    found = [KitFit("", (), _why_not(partial(board_program, opened, meant.name, beside, None)))]
    for kit in kits:
        on = _on_kit(opened, meant, kit, beside, package)
        found.append(
            KitFit(kit.name, tuple(one.part for one in on.parts if one.is_used and one.is_missing), on.problem)
        )
    return found


def _on_kit(opened: OpenMission, program: Program, kit: Kit, folder: Path | None, package: Package) -> ProgramOnKit:
    compiled = opened.compiled.get(program.name) or compile_program(program, opened.catalogue)
    problem = _why_not(partial(board_program, opened, program.name, folder, kit))
    return _program_on_kit(program.name, robot_of(program, opened.catalogue), compiled, kit, package, problem)


def _why_not(make: Callable[[], object]) -> KitRobotError | None:
    try:
        make()
    except KitRobotError as error:
        return error
    return None


def _program_on_kit(
    name: str, robot: Robot, compiled: CompiledProgram | None, kit: Kit, package: Package, problem: KitRobotError | None
) -> ProgramOnKit:
    image = compiled.image if compiled is not None else None
    return ProgramOnKit(name, robot.name, tuple(parts_on_kit(robot, kit, package, image)), problem)
