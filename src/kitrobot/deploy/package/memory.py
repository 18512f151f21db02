"""Estimates whether a program fits a board's memory, before anything is sent.

The estimate is the least memory of the loop while the board compiles it, of the package's modules, of the program's
arrays, and of the working memory; each `LoopInstaller` has its own. It refuses only what certainly does not fit; a
program that passes and does not fit after all is refused by the board itself, which then keeps its previous program.
"""

from __future__ import annotations

from collections.abc import Iterable

from kitrobot.deploy.errors import NoMemoryError
from kitrobot.deploy.package.board_package import BoardPackage
from kitrobot.deploy.package.program_file import ProgramFile
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot_onboard.image import header

WORKING = 2200
"""Bytes without which a board cannot compile what it is asked while its program runs: with 2 064 a micro:bit of 2016
could not do a tick on request, with 2 304 it could."""

_PER_LETTER = {"interpreter": 0.74, "loop": 1.04, "driver": 1.0}
"""Bytes that a letter of source takes once it is compiled, as measured on the micro:bit of 2016."""

_ALWAYS = 1500
"""Bytes that the list of the robot, main.py and the names take."""


_NAMED = 3
"""Drivers that are named when a program is too large."""


def image_bytes(image: bytes) -> int:
    """Bytes of memory that the arrays of an image take on a board."""
    fields = header(image)
    inputs, variables, counters, temporaries, constants, slots, parallels, stops, commands = fields[6:15]
    actuators, most_arguments, instructions = fields[15], fields[16], fields[17]
    numbers = 1 + inputs + variables + counters + temporaries + constants  # cells
    numbers += 2 * slots  # threads
    numbers += 4 + 4 * slots + 5 * parallels + 3 * stops + commands  # pars
    numbers += (3 + most_arguments) * actuators  # out
    return int(4 * instructions + 4 * numbers)


def refuse_what_does_not_fit(program: ProgramFile, built: BoardPackage, file_bytes: int, free: int) -> None:
    """Raises a NoMemoryError when the program is sure to be too large for a board with so much memory free.

    `file_bytes`: of the file that the board executes.
    """
    needed, kept = built.installer.memory_bytes(program, built, file_bytes)
    room = free - kept - WORKING
    if needed <= room:
        return
    costs = sorted((-len(built.files[file]), driver) for driver, file in built.drivers.items())
    most = Series(COMMA, (Sentence("`{driver}` ({bytes} bytes)", driver, -bytes_) for bytes_, driver in costs[:_NAMED]))
    smaller = Sentence("make the program smaller, or take a board with more memory, such as a micro:bit V2")
    raise NoMemoryError(
        Sentence(
            "the program needs {needed} bytes of memory, and beside KitRobot the board has {free}; nothing was sent",
            needed,
            max(room, 0),
        ),
        Sentence("{way}; the drivers that take most are {drivers}", smaller, most) if costs else smaller,
    )


def package_bytes(built: BoardPackage) -> int:
    """Bytes of memory that a package and its drivers take, once they are compiled."""

    def letters(names: Iterable[str]) -> int:
        return sum(len(built.files[name]) for name in names)

    own = _PER_LETTER["interpreter"] * letters([f"{built.interpreter}.py"])
    own += _PER_LETTER["loop"] * letters(built.loop)
    own += _PER_LETTER["loop"] * letters([built.member] if built.member else [])
    return int(_ALWAYS + own + _PER_LETTER["driver"] * letters(built.drivers.values()))
