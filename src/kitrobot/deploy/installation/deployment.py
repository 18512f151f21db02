"""Installs a program on a board and starts it: `deploy`."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import dataclass
from threading import Event

from kitrobot.deploy.errors import (
    DeployError,
    LineError,
)
from kitrobot.deploy.installation.installation import Installation, Progress, RobotContext
from kitrobot.deploy.installation.program_start import ProgramStart
from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.package.content_names import MODULE, PROGRAM
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import read_program_file


@dataclass(frozen=True)
class DeployResult:
    """The result of a deploy: `free` bytes of memory are left while the program runs.

    `program` and `package` by eight digits, as in `Hello`; files by their names on the board; `micropython` is the
    version that the board has.
    """

    name: str
    program: str
    package: str
    free: int
    generation: int
    sent_files: tuple[str, ...]
    kept_files: tuple[str, ...]
    bytes_sent: int
    seconds: float
    hello: Hello
    micropython: str = ""


def deploy(
    address: str,
    program: bytes,
    package: Package,
    progress: Progress = lambda stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
    robot: RobotContext | None = None,
    over: Event | None = None,
) -> DeployResult:
    """Puts a program onto a board and starts it.

    Args:
        address: a port or URL.
        program: a program file in which drivers have the names that robots' XML gives them.
        package: where drivers are looked for.
        progress: called with how far it is.
        replace: whether a `main.py` of somebody else may be overwritten.
        fresh: whether to remove what KitRobot put there first; for boards that have no room for two.
        robot: what is known of the robot that the program is for.
        over: once it is set, the board is left with what it had.

    Raises:
        BrokenOffError: `over` was set.
        LineError, SilentError: the board cannot be reached.
        PackageError: a driver is missing or is no Python.
        BoardError: the board refuses, is full, or did not start it; then it starts what it had before.
    """
    meant = read_program_file(program)
    began = time.monotonic()
    progress("connect", 0, 0)
    line = Line(address, over)
    try:
        job = Installation(line, meant, package, progress, replace, fresh, robot or RobotContext())
        job.insist(job.install)
        hello = ProgramStart(job).run()
    except DeployError:
        raise
    except BaseException:  # somebody wants no more of it
        line.over = None
        with suppress(LineError):
            RawRepl(line).release()
        raise
    finally:
        line.close()
    sent = job.sent
    return DeployResult(
        job.line.address,
        job.name[len(PROGRAM) :],
        job.built.module[len(MODULE) :],
        hello.free,
        hello.generation,
        tuple(sent),
        tuple(name for name in job.wanted if name not in sent),
        sum(sent.values()),
        time.monotonic() - began,
        hello,
        job.board.micropython,
    )
