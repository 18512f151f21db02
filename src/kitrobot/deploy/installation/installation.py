"""Installs a program, and the package that it needs, on a board.

The order of the steps makes an interruption safe at any point: unreferenced files are removed; missing files are sent
and read back; last of all a boot record is written beside the valid one. Until that record is complete the board
starts what it started before. When the board then does not greet with the new program, the record is removed again.
The files of the previous installation stay until the next one.

What is new is on trial: a file says so (`krt`), which the board itself removes when it is asked after its first ticks.
A board that never comes so far, because a driver does not return, starts what it had before when its power comes on.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from threading import Event

from kitrobot.deploy.errors import (
    BoardError,
    CrampedError,
    DeployError,
    ForeignError,
    FullError,
    LineError,
    NoMemoryError,
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
from kitrobot.deploy.line.board import Board, Hello
from kitrobot.deploy.line.handshake import STARTS, greet
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import MICROBIT, Receiver, too_much_lost
from kitrobot.deploy.line.repl import GarbledError, RawRepl
from kitrobot.deploy.line.retry_timer import STARTING_S
from kitrobot.deploy.microbit_2016.flash_code import FlashBlock, sign_of
from kitrobot.deploy.microbit_2016.flash_install import freeze
from kitrobot.deploy.microbit_2016.flash_room import refuse_what_has_no_room
from kitrobot.deploy.package.driver_fit import refuse_misfits
from kitrobot.deploy.package.memory import WORKING, refuse_what_does_not_fit
from kitrobot.deploy.package.package import MODULE, PROGRAM, BoardPackage, Package
from kitrobot.deploy.package.program_file import ProgramFile, program_name, read_program_file
from kitrobot.deploy.package.script import board_file
from kitrobot.text.sentences import Sentence, Series
from kitrobot_onboard.link import checksum

Progress = Callable[[str, int, int], None]
"""Called with what is going on (`connect`, `compare`, `send`, `start`; `reset`: the board is mute, and a person has to
press its reset button), and of how many bytes how many are done."""

_TRIES = 3
_WRITES = 3
_PACES = 20
"""A board starts its program within so many times what a reset takes it."""

_LONGEST_S = 300.0
_MEMORY, _DAMAGED, _NO_DRIVER = 3, 4, 5
_TRIAL_TICKS = 3
"""After so many ticks a program is confirmed."""
_TRIAL_STEP_S = 0.05
_TRIAL_S = 5.0
"""Or after so long, when it answers meanwhile: its ticks are long then."""


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


@dataclass(frozen=True)
class RobotContext:
    """What is known of the robot that a program is for: the firmware without which nothing is sent, and a fault's text
    with the name of the part in the place of its number.
    """

    needs: FirmwareRequirements | None = None
    fault_text: Callable[[str], str] = str


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
        job = _Installation(line, meant, package, progress, replace, fresh, robot or RobotContext())
        job.insist(job.install)
        hello = job.started()
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


@dataclass
class _Installation:
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
        family = MICROBIT if board.family == MICROBIT else "machine"
        self.built: BoardPackage = self.package.build(family, self.program.drivers, in_flash=board.is_2016)
        refuse_misfits(self.program, self.package, family)
        content = board_file(self.program, self.built)
        self.name = program_name(content)
        refuse_what_does_not_fit(self.program, self.built, len(content), board.free)
        self.wanted = {**self.built.files, self.name: content}
        names = board.names()
        lines = self._lines(names)
        self._guard_main(names, lines)
        if self.built.block is not None and self.new is None:
            self._refuse_without_room(self.built.block, names, lines)
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
        self._freeze()
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

    def started(self) -> Hello:
        """Restarts the board; how it greets.

        Raises:
            BoardError: it does not run what was sent. What it had before is what it starts again.
        """
        self.progress("start", self.total, self.total)
        try:
            hello = self._greeting()
        except SilentError as error:
            said = self._said
            try:
                self._undo()
            except (SilentError, LineError):
                raise self._hanging() from error
            raise BoardError(
                Sentence("the board did not start what was sent: {reason}", said)
                if said
                else Sentence("the board did not start what was sent"),
                Sentence("send it once more; if that does not help, reset the board")
                if self.old is None
                else Sentence("it starts again what it had before; send the program once more, or reset the board"),
            ) from error
        said = self._said
        if hello is not None and hello.free < WORKING:
            hello = None
        if hello is not None and hello.state != 0 and hello.fault not in (_MEMORY, _DAMAGED, _NO_DRIVER):
            return hello
        self._undo()
        if hello is None or hello.fault == _MEMORY:
            raise NoMemoryError(
                Sentence("the program needs more memory than the board has"),
                Sentence("make the program smaller, use fewer devices in it, or take a board with more memory"),
            )
        refused = BoardError(
            Sentence("the board cannot run the program: {reason}", said),
            Sentence("look at the settings in the robot's XML"),
        )
        refused.said = self._fault
        raise refused

    def _hanging(self) -> SilentError:
        return SilentError(
            Sentence("the board answers no more since it started what was sent: a driver may never return"),
            Sentence("take its power away for a moment, or press its reset button: it starts what it had before then")
            if self.old is not None
            else Sentence("take its power away for a moment, or press its reset button: its prompt is free then"),
        )

    def _greeting(self) -> Hello | None:
        """How it greets; None when it has no memory for that."""
        assert self.new is not None
        board = Board(self.line)
        self._said = self._fault = ""
        try:
            hello = greet(board, self._patience_s, sequence=STARTS, starting_s=self._patience_s)
        except NoMemoryError:
            return None
        except SilentError as error:
            self._said = _last_line(error.printed)  # Python has said why, and gave up
            if self._said.startswith("MemoryError"):
                return None
            raise
        if hello.generation != self.new.generation or hello.program != self.name[2:]:
            raise SilentError(Sentence("the board starts something else"))
        fault = board.last_fault() if hello.free >= WORKING else None
        self._fault = fault.text.strip() if fault is not None else ""
        self._said = (
            ""
            if fault is None
            else Series(Sentence(": "), filter(None, (fault.meaning, self.robot.fault_text(self._fault))))
        )
        if self.on_trial and hello.free >= WORKING:
            self._confirm(board, hello)
        return hello

    @property
    def _patience_s(self) -> float:
        return max(STARTING_S, min(_PACES * self.board.repl.pace_s, _LONGEST_S))

    def _undo(self) -> None:
        """Takes the new line away, so that what was there before starts."""
        if self.new is None or self.new == self.old:
            return
        self.insist(self._take_away)
        self.board.repl.leave()
        self.line.drain(0.2, 1)

    def _take_away(self) -> None:
        self.board.remove(self.slot)
        self.board.remove(TRIAL)
        self.board.end()

    def _confirm(self, board: Board, hello: Hello) -> None:
        """Waits for the first ticks of what is on trial, and has the board start it from now on."""
        until = self.line.now() + _TRIAL_S
        while hello.state_name == "running" and hello.tick < _TRIAL_TICKS and self.line.now() < until:
            board.news(_TRIAL_STEP_S)
            hello = board.greet()
        try:
            board.keep()
        except BoardError:  # it has no memory for that while its program runs
            self.insist(self._end_trial)
            self.board.repl.leave()
            greet(Board(self.line), self._patience_s, sequence=STARTS, starting_s=self._patience_s)

    def _end_trial(self) -> None:
        self.board.remove(TRIAL)
        self.board.end()

    def _lines(self, names: list[str]) -> dict[str, StartLine]:
        """The lines that may start, by their slots: not one that was tried and never confirmed."""
        found = {slot: read_line(self.board.read(slot)) for slot in SLOTS if slot in names}
        tried = tried_generation(self.board.read(TRIAL)) if TRIAL in names else None
        return {slot: line for slot, line in found.items() if line is not None and line.generation != tried}

    def _refuse_without_room(self, one: FlashBlock, names: list[str], lines: dict[str, StartLine]) -> None:
        """Before anything is removed: what stays is other people's files, and what starts now, unless all is new."""
        wanted = {name: len(data) for name, data in {**self.wanted, MAIN: self.built.main, TRIAL: UNTRIED}.items()}
        staying = {name for name in names if not is_ours(name) and name not in SLOTS}
        blocks = set()
        if not self.fresh and (counts := newest(lines)) is not None:
            staying |= needed(counts[1].files, self._content(names)) & set(names)
            blocks |= {sign_of(counts[1].module)} if is_ours(f"{counts[1].module}.py") else set()
        refuse_what_has_no_room(self.board, one, wanted, sorted(staying - set(wanted)), blocks)

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

    def _freeze(self) -> None:
        """Puts into flash what runs from there; what the line that counts needs of that stays."""
        if (one := self.built.block) is not None:
            kept = {sign_of(self.old.module)} if self.old is not None and is_ours(f"{self.old.module}.py") else set()
            if sent := freeze(self.board, one, kept):
                self.sent[one.name] = sent

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


def _last_line(text: str) -> str:
    """The error, when Python reported one: the last line of a traceback."""
    if "Traceback" not in text:
        return ""
    lines = text[text.index("Traceback") :].splitlines()
    return next((line.strip() for line in lines[1:] if line and not line.startswith(" ")), "")[:120]
