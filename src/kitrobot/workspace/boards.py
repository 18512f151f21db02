"""Real robots: what a mission's program becomes on one, sending it to several at once, and which robots are there.

`deploy` talks to the robots; here it is told what to send, and what comes back gets its names (board_names).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TypeVar

from kitrobot.compiler import Compiled, compile_program, compile_text
from kitrobot.deploy import (
    FAMILIES,
    Board,
    Deployed,
    DeployError,
    Hello,
    Package,
    PackageError,
    Port,
    ProgramFile,
    board_file,
    connect,
    deploy,
    list_ports,
    make_program_file,
    program_name,
    refuse_what_fits_no_board,
)
from kitrobot.diagnostics import Diagnostic, KitRobotError, Source
from kitrobot.image import verify
from kitrobot.primitives import Robot, config_folder
from kitrobot.workspace.board_carried import Carried, carried_by, keep_carried
from kitrobot.workspace.board_names import BoardNames, keep_names, kept_names, names_of
from kitrobot.workspace.board_sharing import SHARED_ON_BOARD, warn_of_sharing
from kitrobot.workspace.carried import is_picture
from kitrobot.workspace.executables import NoRobotError
from kitrobot.workspace.files import read_text
from kitrobot.workspace.forms import Form, form_of
from kitrobot.workspace.opening import OpenMission, open_mission
from kitrobot.workspace.problems import ProblemsError
from kitrobot.workspace.robots import find_robot

_FORMS = (Form.TEXT, Form.MISSION)
_MOST_AT_ONCE = 32

Given = TypeVar("Given")
Made = TypeVar("Made")

Progress = Callable[[str, str, int, int], None]
"""Is told of an address: what is done now, and how many bytes of how many."""


Waits = Callable[[str], None]
"""Is told of an address where nobody has answered yet."""


def _nobody_asks(address: str) -> None:
    """Nobody wants to know."""


class NoBoardError(KitRobotError):
    """No robot is there, or several where one must be chosen."""


@dataclass(frozen=True)
class BoardProgram:
    """A program that can be sent, with its names; `package` knows where its drivers are looked for, `carried` is what
    recordings of it bring along (None: it is of no mission).
    """

    names: BoardNames
    file: ProgramFile
    package: Package
    diagnostics: tuple[Diagnostic, ...] = ()
    sources: tuple[Source, ...] = ()
    carried: Carried | None = None

    @property
    def warning(self) -> Diagnostic | None:
        """What its person should know of it on a robot, beside its problems as a program."""
        return next((item for item in self.diagnostics if item.code == SHARED_ON_BOARD.code), None)

    @cached_property
    def called(self) -> frozenset[str]:
        """What robots of each kind call it, as far as it has drivers for them, and robots that know drivers by name."""
        found = {program_name(self.file.to_bytes())[2:]}
        for family in FAMILIES:
            if not self.package.missing(self.file.drivers, family):
                built = self.package.built(family, self.file.drivers)
                found.add(program_name(board_file(self.file, built))[2:])
        return frozenset(found)

    def is_called(self, installed: str) -> bool:
        """Whether that is the program that a robot has, by the name that the robot gives."""
        return installed in self.called


@dataclass(frozen=True)
class Sent:
    """What became of one robot: `deployed`, or the `error` that kept it from it."""

    address: str
    deployed: Deployed | None
    error: KitRobotError | None


@dataclass(frozen=True)
class Seen:
    """A port, and who answers there: `hello` None when nobody does, and `error` says why."""

    port: Port
    hello: Hello | None
    program: str
    error: KitRobotError | None


def load_board_program(path: Path, *, robot: str | None = None, program: str | None = None) -> BoardProgram:
    """A program of a file, made ready to be sent.

    Args:
        path: a `.krt`, a picture that carries one, or an `.lll`.
        robot: the robot's name or file; needed unless a mission names it.
        program: which program of a mission with several.

    Raises:
        ProblemsError: the program has errors, with all that is to be said of it.
        KitRobotError: a file cannot be read, the robot or the program is not there, a driver is missing.
    """
    form = Form.MISSION if is_picture(path.name) else form_of(path, _FORMS)
    if form is Form.MISSION:
        return board_program(open_mission(path, robot=robot), program, path.parent)
    if robot is None:
        raise NoRobotError(
            f"`{path}` does not say which robot it is for", "name the robot with --robot, a name or a `.robot.xml`"
        )
    meant = find_robot(robot, path.parent)
    source = Source(str(path), read_text(path))
    compiled = compile_text(source.text, meant, source.name)
    found = (*compiled.diagnostics, *warn_of_sharing(path.stem, meant, compiled))
    return _ready(path.stem, meant, compiled, found, (source,), path.parent)


def board_program(opened: OpenMission, program: str | None = None, folder: Path | None = None) -> BoardProgram:
    """A program of an open mission, made ready to be sent; `folder`: where drivers of the user's own may lie.

    Raises:
        ProblemsError: the program has errors, with all that is to be said of it.
        KitRobotError: the program is not there, its robot is none that is real, a driver is missing.
    """
    meant = opened.program(program)
    compiled = opened.compiled.get(meant.name) or compile_program(meant, opened.catalogue)
    robot = opened.catalogue.robot(meant.robot)
    shared = warn_of_sharing(meant.name, robot, compiled)
    found = tuple(opened.placed([*opened.diagnostics, *compiled.diagnostics, *shared]))
    beside = folder or (opened.path.parent if opened.path is not None else None)
    ready = _ready(meant.name, robot, compiled, found, opened.sources, beside)
    return replace(ready, carried=carried_by(opened, robot, compiled))


def _ready(
    name: str,
    robot: Robot,
    compiled: Compiled,
    found: tuple[Diagnostic, ...],
    sources: tuple[Source, ...],
    folder: Path | None,
) -> BoardProgram:
    if compiled.image is None or any(item.is_error for item in found):
        raise ProblemsError(f"the program `{name}` has errors", "mend them, then send it", found, sources)
    verify(compiled.image)
    file = make_program_file(compiled.image, robot)
    package = Package((config_folder(), *([folder] if folder is not None else [])))
    missing = package.missing(file.drivers)
    if missing:
        raise no_driver(robot, missing[0], package)
    refuse_what_fits_no_board(file, package)
    return BoardProgram(names_of(name, robot, compiled), file, package, found, sources)


def no_driver(robot: Robot, driver: str, package: Package) -> PackageError:
    """The error of a driver that is there for no kind of board: which part wants it, and where it was looked for."""
    parts = [part.name for part in (*robot.actuators, *robot.sensors) if (part.board.driver or part.device) == driver]
    files = list(dict.fromkeys(path for family in FAMILIES for path in package.looked_for(driver, family)))
    return PackageError(
        f"`{parts[0]}` of the robot `{robot.name}` wants the driver `{driver}`, and there is none",
        f"it was looked for as {', '.join(f'`{path}`' for path in files)}",
    )


def chosen_boards(addresses: Sequence[str]) -> list[str]:
    """The addresses that were given, each once; without one, that of the only robot that may be there.

    Raises:
        NoBoardError: none is there, or several.
    """
    if addresses:
        return list(dict.fromkeys(addresses))
    ports = list_ports()
    if len(ports) == 1:
        return [ports[0].address]
    if not ports:
        raise NoBoardError(
            "no robot is plugged in", "plug one in with a USB cable that carries data, or name its address with --to"
        )
    names = ", ".join(f"`{port.address}` ({port.name})" for port in ports)
    raise NoBoardError(f"{len(ports)} robots may be meant: {names}", "choose with --to")


def send_program(
    program: BoardProgram,
    addresses: Sequence[str],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
) -> list[Sent]:
    """Sends a program to several robots at once; what goes wrong with one does not hold up the others."""
    data = program.file.to_bytes()

    def send(address: str) -> Sent:
        def told(stage: str, done: int, total: int) -> None:
            progress(address, stage, done, total)

        try:
            return Sent(address, deploy(address, data, program.package, told, replace=replace, fresh=fresh), None)
        except KitRobotError as error:
            return Sent(address, None, error)

    sent = _at_once(send, addresses)
    called = {one.deployed.program for one in sent if one.deployed is not None}
    if called:
        keep_program(program, called)
    return sent


def keep_program(program: BoardProgram, called: Iterable[str]) -> None:
    """Keeps what a program's numbers are called and what recordings of it need, for later; `called`: by robots."""
    names = tuple(called)
    keep_names(program.names, names)
    keep_carried(program.carried, names)


def look_at_boards(addresses: Sequence[str] = (), waits: Waits = _nobody_asks) -> list[Seen]:
    """Which robots are there: those of the addresses, or of every port where one may be; all are asked at once.

    `waits` is told of an address whose answer is waited for.
    """
    ports = [Port(address, "", "") for address in addresses] if addresses else list_ports()

    def look(port: Port) -> Seen:
        try:
            with connect(port.address, waits=lambda: waits(port.address)) as board:
                names = kept_names(board.hello.program)
                return Seen(port, board.hello, names.program if names is not None else "", None)
        except DeployError as error:
            return Seen(port, None, "", error)

    return _at_once(look, ports)


def at_boards(
    addresses: Sequence[str], act: Callable[[Board], object], waits: Waits = _nobody_asks
) -> list[tuple[str, KitRobotError | None]]:
    """Does something with each robot, all at once; what went wrong with which. `waits` as for `look_at_boards`."""

    def one(address: str) -> tuple[str, KitRobotError | None]:
        try:
            with connect(address, waits=lambda: waits(address)) as board:
                act(board)
        except DeployError as error:
            return address, error
        return address, None

    return _at_once(one, addresses)


def _at_once(make: Callable[[Given], Made], given: Sequence[Given]) -> list[Made]:
    if not given:
        return []
    with ThreadPoolExecutor(min(len(given), _MOST_AT_ONCE)) as threads:
        return list(threads.map(make, given))
