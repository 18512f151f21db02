"""All files of a program on a board that has none, for what is written to its flash at once.

They are those that an installation leaves: the package, the program file, `main.py`, and the line that names what
starts. Nothing is on trial: there is nothing to go back to.
"""

from __future__ import annotations

from collections.abc import Mapping

from kitrobot.deploy.installation.boot_records import MAIN, SLOTS, StartLine
from kitrobot.deploy.package.board_package import LoopInstaller
from kitrobot.deploy.package.driver_fit import refuse_misfits
from kitrobot.deploy.package.memory import refuse_what_does_not_fit
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import ProgramFile, program_name
from kitrobot.deploy.package.script import board_file
from kitrobot_onboard.link import checksum


def initial_files(
    program: ProgramFile, package: Package, family: str, installer: LoopInstaller, free: int
) -> Mapping[str, bytes]:
    """The files, by their names.

    Args:
        program: the file in which drivers have the names that robots' XML gives them.
        package: where drivers are looked for.
        family: of boards.
        installer: how the board comes to the loop.
        free: bytes of memory that the board has.

    Raises:
        PackageError: a driver is missing, is no Python, or does not understand its settings.
        NoMemoryError: it is sure to be too large, with what takes most.
    """
    built = package.build(family, program.drivers, installer)
    refuse_misfits(program, package, family)
    content = board_file(program, built)
    refuse_what_does_not_fit(program, built, len(content), free)
    name = program_name(content)
    line = StartLine(1, built.interpreter, name, checksum(content))
    return {**built.files, name: content, MAIN: built.main, SLOTS[0]: line.to_bytes()}
