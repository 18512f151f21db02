"""Installs a program, and the package that it needs, on a board.

The order of the steps makes an interruption safe at any point: unreferenced files are removed; missing files are sent
and read back; last of all a boot record is written beside the valid one. Until that record is complete the board
starts what it started before. When the board then does not greet with the new program, the record is removed again.
The files of the previous installation stay until the next one.

What is new is on trial: a file says so (`krt`), which the board itself removes when it is asked after its first ticks.
A board that never comes so far, because a driver does not return, starts what it had before when its power comes on.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from kitrobot.deploy.errors import (
    BoardError,
    CrampedError,
    ForeignError,
    FullError,
    SilentError,
)
from kitrobot.deploy.firmware.requirements import FirmwareRequirements
from kitrobot.deploy.installation.boot_records import (
    LAST_GENERATION,
    MAIN,
    SLOTS,
    TRIAL,
    UNTRIED,
    StartLine,
    is_ours,
    needed,
    newest,
    read_line,
    tried_generation,
)
from kitrobot.deploy.installation.loop_installers import loop_installer
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import MICROBIT, Receiver, too_much_lost
from kitrobot.deploy.line.repl import GarbledError, RawRepl
from kitrobot.deploy.microbit_2016.board_fit import refuse_on_2016
from kitrobot.deploy.package.board_package import BoardPackage
from kitrobot.deploy.package.driver_fit import refuse_misfits
from kitrobot.deploy.package.memory import refuse_what_does_not_fit
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import ProgramFile, program_name
from kitrobot.deploy.package.script import board_file
from kitrobot.text.sentences import Sentence
from kitrobot_onboard.link import checksum

Progress = Callable[[str, int, int], None]
"""Called with what is going on (`connect`, `compare`, `send`, `start`; `reset`: the board is mute, and a person has to
press its reset button), and of how many bytes how many are done."""

_TRIES = 3
_WRITES = 3


@dataclass(frozen=True)
class RobotContext:
    """What is known of the robot that a program is for: the firmware without which nothing is sent, and a fault's text
    with the name of the part in the place of its number.
    """

    needs: FirmwareRequirements | None = None
    fault_text: Callable[[str], str] = str


@dataclass
class Installation:
    """The way of a program onto a board: what differs is sent, last of all the line that names what starts."""

    line: Line
    program: ProgramFile
    package: Package
    progress: Progress
    replace: bool
    fresh: bool
    robot: RobotContext
    sent: dict[str, int] = field(default_factory=dict)
    """Sizes of the files that were sent."""

    wanted: Mapping[str, bytes] = field(default_factory=dict)
    name: str = ""
    slot: str = ""
    old: StartLine | None = None
    new: StartLine | None = None
    on_trial: bool = False
    """Whether what starts next has to be confirmed."""

    done: int = 0
    total: int = 0

    def insist(self, work: Callable[[], None]) -> None:
        """Does something with the board's files once more when it was broken off: all that was done stands."""
        for tries_left in reversed(range(_TRIES)):
            self.board = Receiver(RawRepl(self.line, lambda: self.progress("reset", self.done, self.total)))
            try:
                self.board.begin()
                return work()
            except SilentError:
                if not self.board.repl.answered or not tries_left:
                    raise
            except CrampedError:
                if not tries_left:
                    raise
            except GarbledError:
                if not tries_left:
                    raise too_much_lost(self.line.address) from None

    def install(self) -> None:
        """Everything up to the line that names what starts."""
        board = self.board
        self.progress("compare", 0, 0)
        if self.robot.needs is not None:
            self.robot.needs.refuse_other_board(board.family)
            self.robot.needs.refuse_older(board.micropython)
        if board.is_2016:
            refuse_on_2016(self.program, self.package, self.robot.needs)
        family = MICROBIT if board.family == MICROBIT else "machine"
        self.built: BoardPackage = self.package.build(family, self.program.drivers, loop_installer(board))
        refuse_misfits(self.program, self.package, family)
        content = board_file(self.program, self.built)
        self.name = program_name(content)
        refuse_what_does_not_fit(self.program, self.built, len(content), board.free)
        self.wanted = {**self.built.files, self.name: content}
        names = board.names()
        lines = self._lines(names)
        self._guard_main(names, lines)
        if self.new is None:
            self._refuse_without_room(names, lines)
        if self.fresh and self.new is None:
            # main.py too, which is ours: in the middle of a small flash it leaves no room in one piece.
            removed = [name for name in names if name in (*SLOTS, MAIN, TRIAL) or is_ours(name)]
            for name in [*SLOTS, *(name for name in removed if name not in SLOTS)]:
                board.remove(name)
            names, lines = [name for name in names if name not in removed], {}
        counts = newest(lines)
        if self.new is not None and counts is not None and counts[1] == self.new:
            return board.end()  # an attempt before this one had come to its end
        self.slot = SLOTS[0] if counts is None or counts[0] == SLOTS[1] else SLOTS[1]
        self.old = counts[1] if counts is not None else None
        missing = {name: data for name, data in self.wanted.items() if not self._holds(names, name, data)}
        self._clear(names, lines)
        main = not self._holds(names, MAIN, self.built.main)
        self.done = 0
        self.total = 2 * sum(map(len, [*missing.values(), *([self.built.main] if main else [])]))
        board.count = self._count
        self.progress("send", 0, self.total)
        self._install_loop()
        for name, data in missing.items():
            self._send(name, data)
        if main:
            self._send(MAIN, self.built.main)
        if missing:
            self._look_again()
        first, name = self.built.interpreter, self.name
        self.on_trial = TRIAL in names
        if self.old is not None and (self.old.module, self.old.program) == (first, name):
            self.new = self.old
        else:
            self.on_trial = True
            self._send(TRIAL, UNTRIED, count=False)
            generation = (self.old.generation if self.old is not None else 0) % LAST_GENERATION + 1
            self.new = StartLine(generation, first, name, checksum(content))
            self._send(self.slot, self.new.to_bytes(), count=False)
            if generation == 1 and counts is not None:
                board.remove(counts[0])  # the count begins anew: now, not earlier, this line counts
        board.count = lambda count: None
        board.end()

    def _lines(self, names: list[str]) -> dict[str, StartLine]:
        """The lines that may start, by their slots: not one that was tried and never confirmed."""
        found = {slot: read_line(self.board.read(slot)) for slot in SLOTS if slot in names}
        tried = tried_generation(self.board.read(TRIAL)) if TRIAL in names else None
        return {slot: line for slot, line in found.items() if line is not None and line.generation != tried}

    def _refuse_without_room(self, names: list[str], lines: dict[str, StartLine]) -> None:
        """Before anything is removed: what stays is other people's files, and what starts now, unless all is new."""
        wanted = {name: len(data) for name, data in {**self.wanted, MAIN: self.built.main, TRIAL: UNTRIED}.items()}
        staying = {name for name in names if not is_ours(name) and name not in SLOTS}
        modules = []
        if not self.fresh and (counts := newest(lines)) is not None:
            staying |= needed(counts[1].files, self._content(names)) & set(names)
            modules = self._modules(counts[1])
        self.built.installer.refuse_without_room(self.board, wanted, sorted(staying - set(wanted)), modules)

    def _guard_main(self, names: list[str], lines: Mapping[str, StartLine]) -> None:
        if self.replace or MAIN not in names or self._holds(names, MAIN, self.built.main):
            return
        theirs = self.board.read(MAIN)
        if b"krboot" not in theirs and not self.built.main.startswith(theirs):
            self.board.end()
            raise ForeignError(
                Sentence("the board holds a `main.py` that is not KitRobot's"),
                Sentence("save it if you need it (`mpremote cp :main.py .`), then deploy with --replace"),
            )

    def _holds(self, names: list[str], name: str, data: bytes) -> bool:
        return name in names and self.board.sum_of(name) == (len(data), checksum(data))

    def _clear(self, names: list[str], lines: Mapping[str, StartLine]) -> None:
        """Removes what neither the line that counts nor the new one needs: the older line first."""
        if self.slot in names:
            self.board.remove(self.slot)
        left = [name for name in names if is_ours(name) and name not in self.wanted]
        if left:
            kept = needed(self.old.files, self._content(names)) if self.old is not None else set()
            for name in left:
                if name not in kept:
                    self.board.remove(name)

    def _content(self, names: list[str]) -> Callable[[str], bytes | None]:
        def content(name: str) -> bytes | None:
            if name in self.wanted:
                return self.wanted[name]
            return self.board.read(name) if name in names else None

        return content

    def _send(self, name: str, data: bytes, *, count: bool = True) -> None:
        """Writes a file and reads it back."""
        for _ in range(_WRITES):
            self.board.write(name, data)
            if self.board.read(name) == data:
                if count:
                    self.sent[name] = len(data)
                return
        raise BoardError(
            Sentence("what was written into `{name}` cannot be read back", name),
            Sentence("the board's flash may be worn out"),
        )

    def _install_loop(self) -> None:
        """Puts the loop where it is no file; what the line that counts needs of that stays."""
        modules = self._modules(self.old) if self.old is not None else []
        self.sent |= self.built.installer.install(self.board, modules, fresh=self.fresh)

    def _modules(self, line: StartLine) -> list[str]:
        return [line.module] if is_ours(f"{line.module}.py") else []

    def _look_again(self) -> None:
        """A small board tidies its flash up when that is nearly full, and may spoil what it held."""
        names = self.board.names()
        for name, data in {**self.wanted, MAIN: self.built.main}.items():
            if not self._holds(names, name, data):
                raise FullError(
                    Sentence("the board's flash is nearly full and lost what stood in `{name}`", name),
                    Sentence("run the command again with --fresh, which empties it of KitRobot's files first"),
                )

    def _count(self, count: int) -> None:
        self.done = min(self.done + count, self.total)
        self.progress("send", self.done, self.total)
