"""Programs for real robots: made from missions, sent, and their names when robots are listed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from kitrobot.boards.sent_firmware import load_firmware_version, store_firmware_version
from kitrobot.boards.sent_programs import load_names, store_sent_program
from kitrobot.compiler.compilation import CompiledProgram, compile_program, compile_text
from kitrobot.compiler.target import robot_of
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.disk import read_text
from kitrobot.files.embedded_mission import may_carry_mission
from kitrobot.files.examples import find_mission
from kitrobot.files.program_formats import Form, form_of
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Robot
from kitrobot.robots import board_operations
from kitrobot.robots.board_operations import BoardContents, Progress, SendResult, WaitListener
from kitrobot.robots.program import BoardProgram, program_of
from kitrobot.robots.recording_context import recording_context_of
from kitrobot.robots.shared_variable_check import warn_of_shared_variables
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.executables import NoRobotError
from kitrobot.workspace.kit_files import find_kit
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.robots import find_robot
from kitrobot.workspace.traces import parts_of


class NoHostError(KitRobotError):
    """The program of a team is to be sent to a robot that would have no host to speak for it there."""


_FORMS = (Form.TEXT, Form.MISSION)


def load_board_program(
    path: Path,
    *,
    robot: str | None = None,
    program: str | None = None,
    kit: str | None = None,
    built_of: Kit | None = None,
) -> BoardProgram:
    """A program of a file, made ready to be sent.

    Args:
        path: a `.krt`, a picture that carries one, an `.lll`, or the name of an example.
        robot: the robot's name or file; needed unless a mission names it.
        program: which program of a mission with several.
        kit: the name or the file of the kit that its robot is built of; None as the robot's XML says.
        built_of: the kit itself, in the place of its name.

    Raises:
        ProblemsError: the program has errors, with all that is to be said of it.
        KitRobotError: a file cannot be read, the robot or the program is not there, a driver is missing.
    """
    beside = path.parent
    path = find_mission(path)
    form = Form.MISSION if may_carry_mission(path.name) else form_of(path, _FORMS)
    built_of = find_kit(kit, beside) if kit is not None else built_of
    if form is Form.MISSION:
        return board_program(open_mission(path, robot=robot), program, path.parent, built_of)
    if robot is None:
        raise no_robot(path)
    meant = find_robot(robot, path.parent)
    source = Source(str(path), read_text(path))
    compiled = compile_text(source.text, meant, source.name)
    found = (*compiled.diagnostics, *warn_of_shared_variables(path.stem, meant, compiled))
    return ready_program(path.stem, meant, compiled, found, (source,), path.parent, kit=built_of)


def no_robot(path: Path) -> NoRobotError:
    """The error of a text whose robot nobody names."""
    return NoRobotError(
        Sentence("`{path}` does not say which robot it is for", path),
        Sentence("name the robot with --robot, a name or a `.robot.xml`"),
    )


def board_program(
    opened: OpenMission, program: str | None = None, folder: Path | None = None, kit: Kit | None = None
) -> BoardProgram:
    """A program of an open mission, made ready to be sent; `folder`: where drivers of the user's own may lie; `kit`:
    what its robot is built of, None as its XML says.

    Raises:
        ProblemsError: the program has errors, with all that is to be said of it.
        KitRobotError: the program is not there, its robot is none that is real, a driver is missing.
    """
    meant = opened.program(program)
    if meant.level.is_team:
        raise NoHostError(
            Sentence("`{program}` is the program of a team, and a robot by itself has none", meant.name),
            Sentence(
                "send it with {command}, and run it with `kitrobot team`",
                "`kitrobot deploy … --team --board AGENT=PORT`",
            ),
        )
    compiled = opened.compiled.get(meant.name) or compile_program(meant, opened.catalogue)
    robot = robot_of(meant, opened.catalogue)
    shared = warn_of_shared_variables(meant.name, robot, compiled)
    found = tuple(opened.placed([*opened.diagnostics, *compiled.diagnostics, *shared]))
    beside = folder or (opened.path.parent if opened.path is not None else None)
    ready = ready_program(meant.name, robot, compiled, found, opened.sources, beside, kit=kit)
    if opened.world is None:
        return ready  # a recording would embed the world
    return replace(
        ready, recording_context=recording_context_of(opened.mission, opened.world, parts_of(opened), robot, compiled)
    )


def ready_program(
    name: str,
    robot: Robot,
    compiled: CompiledProgram | None,
    found: tuple[Diagnostic, ...],
    sources: tuple[Source, ...],
    folder: Path | None,
    *,
    member: bool = False,
    kit: Kit | None = None,
) -> BoardProgram:
    """A program that was compiled, made ready to be sent; `member`: as that of a member of a team; `kit`: on which.

    Raises:
        ProblemsError: it has errors.
        KitRobotError: a driver is missing, or the program fits no board.
    """
    if compiled is None or compiled.image is None or any(item.is_error for item in found):
        raise ProblemsError(
            Sentence("the program `{program}` has errors", name), Sentence("mend them, then send it"), found, sources
        )
    return program_of(name, robot, compiled, found, sources, folder, member=member, kit=kit)


def send_program(
    program: BoardProgram,
    addresses: Sequence[str],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
) -> list[SendResult]:
    """As `board_operations.send_program`; what was sent is kept, so that its names are known later."""
    sent = board_operations.send_program(program, addresses, progress, replace=replace, fresh=fresh)
    store_sent_program(program, {one.deployed.program for one in sent if one.deployed is not None})
    for one in sent:
        if one.deployed is not None:
            store_firmware_version(one.address, one.deployed)
    return sent


def scan_boards(addresses: Sequence[str] = (), waits: WaitListener = lambda address: None) -> list[BoardContents]:
    """As `board_operations.scan_boards`, with the names of programs that were sent from here."""

    def name_of(installed: str) -> str:
        names = load_names(installed)
        return names.program if names is not None else ""

    seen = board_operations.scan_boards(addresses, waits, name_of)
    return [
        replace(one, micropython=load_firmware_version(one.port.address, one.hello)) if one.hello is not None else one
        for one in seen
    ]
