"""A program that can be put on a robot: its file, its drivers, and its names."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.firmware.requirements import FirmwareRequirements
from kitrobot.deploy.installation.loop_installers import build_for_all_boards
from kitrobot.deploy.kits.kits import fit_to_kit, parts_used, refuse_what_is_missing
from kitrobot.deploy.package.driver_fit import refuse_misfits, refuse_what_fits_no_board
from kitrobot.deploy.package.package import FAMILIES, Package
from kitrobot.deploy.package.program_file import ProgramFile, make_program_file, program_name
from kitrobot.deploy.package.script import board_file
from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.image.model import Image
from kitrobot.image.verification import verify
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Robot
from kitrobot.robots.names import BoardNames, names_of
from kitrobot.robots.recording_context import RecordingContext
from kitrobot.robots.session import InstalledProgram
from kitrobot.robots.shared_variable_check import SHARED_ON_BOARD
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.user_folders import config_folder


@dataclass(frozen=True)
class BoardProgram:
    """A program that can be sent, with its names.

    Attributes:
        package: finds its drivers.
        recording_context: what recordings of it embed; None: it belongs to no mission.
        needs: the firmware that its kit requires.
    """

    names: BoardNames
    file: ProgramFile
    package: Package
    diagnostics: tuple[Diagnostic, ...] = ()
    sources: tuple[Source, ...] = ()
    recording_context: RecordingContext | None = None
    needs: FirmwareRequirements | None = None

    @property
    def warning(self) -> Diagnostic | None:
        """A warning about it on a robot, beside its problems as a program."""
        return next((item for item in self.diagnostics if item.code == SHARED_ON_BOARD.code), None)

    @cached_property
    def called(self) -> frozenset[str]:
        """Its names on robots of each kind for which it has drivers, and on robots that know drivers by name."""
        found = {program_name(self.file.to_bytes())[2:]}
        for built in build_for_all_boards(self.package, self.file.drivers):
            found.add(program_name(board_file(self.file, built))[2:])
        return frozenset(found)

    @property
    def known(self) -> InstalledProgram:
        """What a session needs to know of it."""
        return InstalledProgram(self.names, self.recording_context)

    def is_called(self, installed: str) -> bool:
        """Whether that is the program that a robot has, by the name that the robot gives."""
        return installed in self.called


def program_of(
    name: str,
    robot: Robot,
    compiled: CompiledProgram,
    diagnostics: tuple[Diagnostic, ...] = (),
    sources: tuple[Source, ...] = (),
    folder: Path | None = None,
    *,
    member: bool = False,
    kit: Kit | None = None,
) -> BoardProgram:
    """A program that was compiled without errors, ready to be sent; `folder`: where a user's own drivers may lie;
    `member`: it is to be one of a team; `kit`: how its robot is wired; None: as in its XML.

    Raises:
        KitRobotError: a driver is missing, the kit lacks a part, or the program fits no board.
    """
    assert compiled.image is not None
    verify(compiled.image)
    package = Package((config_folder(), *([folder] if folder is not None else [])))
    if kit is not None:
        refuse_what_is_missing(robot, kit, compiled.image)
        robot = fit_to_kit(robot, kit, package)
    file = make_program_file(compiled.image, robot, member=member)
    if kit is None:
        refuse_unwired(robot, compiled.image, package)
    missing = package.missing(file.drivers, kit.family if kit is not None else None)
    if missing:
        raise no_driver(robot, missing[0], package)
    if kit is not None:
        refuse_misfits(file, package, kit.family)
    else:
        refuse_what_fits_no_board(file, package)
    needs = (
        FirmwareRequirements(kit.name, kit.micropython, kit.firmware, kit.family, kit.chip) if kit is not None else None
    )
    return BoardProgram(names_of(name, robot, compiled), file, package, diagnostics, sources, needs=needs)


def refuse_unwired(robot: Robot, image: Image, package: Package) -> None:
    """Raises a PackageError when a robot does not define the wiring of parts that a program uses, and their drivers on
    every kind of board need to know it: what it is built of is missing, and not one setting.
    """
    unwired = [
        part.name
        for part in parts_used(image, robot)
        if part.board.driver in ("", part.device) and not part.board.settings and _needs_settings(part.device, package)
    ]
    if unwired:
        raise PackageError(
            Sentence(
                "the robot `{robot}` does not say how these are wired: {parts}",
                robot.name,
                listed(list(dict.fromkeys(unwired))),
            ),
            Sentence("name what it is built of with --board, such as {command}", "`--board pico`"),
        )


def _needs_settings(driver: str, package: Package) -> bool:
    there = [family for family in FAMILIES if not package.missing([driver], family)]
    declarations = [package.declared(driver, family) for family in there]
    return bool(declarations) and all(any(one.needed for one in each.known({}).values()) for each in declarations)


def no_driver(robot: Robot, driver: str, package: Package) -> PackageError:
    """The error of a driver that is there for no kind of board: which part wants it, and where it was looked for."""
    parts = [part.name for part in (*robot.actuators, *robot.sensors) if (part.board.driver or part.device) == driver]
    files = list(dict.fromkeys(path for family in FAMILIES for path in package.candidates(driver, family)))
    return PackageError(
        Sentence(
            "`{part}` of the robot `{robot}` wants the driver `{driver}`, and there is none",
            parts[0],
            robot.name,
            driver,
        ),
        Sentence(
            "name what it is built of with --board, such as {command}; a driver of your own is looked for as {files}",
            "`--board pico`",
            Series(COMMA, (f"`{path}`" for path in files)),
        ),
    )
