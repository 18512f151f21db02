"""The package for one kind of board, and how the loop comes onto it.

The loop is the interpreter, the port and what answers requests. A board compiles it from files
(`kitrobot.deploy.package.compiled_loop`); the micro:bit of 2016, which has no memory for that, runs it from its flash
(`kitrobot.deploy.microbit_2016`). `LoopInstaller` is all that the rest of `deploy` knows of the difference.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.package.program_file import ProgramFile


@dataclass(frozen=True)
class LoopFiles:
    """The loop as files of a package.

    Args:
        interpreter: as in `BoardPackage`.
        compiled: names of files that the board compiles, the port first.
        start: the content of the file that loads it all.
    """

    interpreter: str
    compiled: Sequence[str]
    start: bytes


class LoopInstaller(Protocol):
    """One of the two ways in which a board comes to the loop."""

    def build_files(self, family: str, requests: str, store: Callable[[bytes], str]) -> LoopFiles:
        """Builds the loop for a family of boards.

        Args:
            family: of boards.
            requests: the name of the file with the answers to requests.
            store: adds a file to the package and returns its name.
        """
        ...

    def memory_bytes(self, program: ProgramFile, built: BoardPackage, file_bytes: int) -> tuple[int, int]:
        """Bytes of memory that a program needs at least, and those that KitRobot itself takes.

        `file_bytes`: of the file that the board executes.
        """
        ...

    def refuse_without_room(
        self, board: Receiver, wanted: Mapping[str, int], staying: Collection[str], modules: Collection[str]
    ) -> None:
        """Raises a FullError when an installation is sure to find no room on the board, before anything is sent.

        Args:
            board: in touch with the board.
            wanted: sizes of all files of the installation.
            staying: names of the files on the board that stay, beside those that are wanted.
            modules: interpreters of packages that stay.
        """
        ...

    def install(self, board: Receiver, modules: Collection[str], *, fresh: bool) -> Mapping[str, int]:
        """Puts onto the board what is no file, and returns the bytes that were sent by name.

        Args:
            board: in touch with the board, before and after.
            modules: interpreters of other packages that stay.
            fresh: whether what lies in the way is written anew.

        Raises:
            SilentError: the board does not answer.
            BoardError: its MicroPython is unknown, or its flash is full.
        """
        ...


@dataclass(frozen=True)
class BoardPackage:
    """A package for one kind of board.

    Args:
        family: of boards.
        files: by name, without `main`, which is `main.py`.
        module: what the whole is called.
        interpreter: the name of its module, or of what the installer puts beside the files.
        start: the name of the file that a program's begins with.
        loop: names of files that it compiles: the port and the loop; none when the installer has them.
        drivers: names of files by names of drivers.
        wants_range: of each driver, whether it reads the settings `min` and `max`, which every sensor has.
        tends: names of drivers that do something at each tick.
        bases: of a driver, the file that is executed in its space before it.
        installer: how the board comes to the loop.
        in_lines: of a user's own driver whose lines and names are those of its file, the name of that file.
        member: the name of the file with the code of a member of a team; "" where no program of a team is meant.
    """

    family: str
    files: Mapping[str, bytes]
    module: str
    interpreter: str
    start: str
    loop: Sequence[str]
    drivers: Mapping[str, str]
    wants_range: Mapping[str, bool]
    main: bytes
    installer: LoopInstaller
    member: str = ""
    tends: frozenset[str] = frozenset()
    bases: Mapping[str, str] = field(default_factory=dict)
    in_lines: Mapping[str, str] = field(default_factory=dict)
