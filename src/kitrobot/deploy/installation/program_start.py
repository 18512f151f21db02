"""Starts what was installed on a board, confirms it, or takes it away again.

What is new is on trial until its first ticks were done; a board that does not greet with it gets back what it had.
"""

from __future__ import annotations

from kitrobot.deploy.errors import (
    BoardError,
    LineError,
    NoMemoryError,
    SilentError,
)
from kitrobot.deploy.installation.boot_records import (
    TRIAL,
)
from kitrobot.deploy.installation.installation import Installation
from kitrobot.deploy.line.board import Board, Hello
from kitrobot.deploy.line.handshake import STARTS, greet
from kitrobot.deploy.line.retry_timer import STARTING_S
from kitrobot.deploy.package.memory import WORKING
from kitrobot.text.sentences import Sentence, Series

_PACES = 20
"""A board starts its program within so many times what a reset takes it."""

_LONGEST_S = 300.0
_MEMORY, _DAMAGED, _NO_DRIVER = 3, 4, 5
_TRIAL_TICKS = 3
"""After so many ticks a program is confirmed."""
_TRIAL_STEP_S = 0.05
_TRIAL_S = 5.0
"""Or after so long, when it answers meanwhile: its ticks are long then."""


class ProgramStart:
    """The first start of what an installation has put onto its board."""

    def __init__(self, job: Installation) -> None:
        self._job = job
        self._said: str = ""
        self._fault: str = ""

    def run(self) -> Hello:
        """Restarts the board; how it greets.

        Raises:
            BoardError: it does not run what was sent. What it had before is what it starts again.
        """
        self._job.progress("start", self._job.total, self._job.total)
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
                if self._job.old is None
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
            if self._job.old is not None
            else Sentence("take its power away for a moment, or press its reset button: its prompt is free then"),
        )

    def _greeting(self) -> Hello | None:
        """How it greets; None when it has no memory for that."""
        assert self._job.new is not None
        board = Board(self._job.line)
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
        if hello.generation != self._job.new.generation or hello.program != self._job.name[2:]:
            raise SilentError(Sentence("the board starts something else"))
        fault = board.last_fault() if hello.free >= WORKING else None
        self._fault = fault.text.strip() if fault is not None else ""
        self._said = (
            ""
            if fault is None
            else Series(Sentence(": "), filter(None, (fault.meaning, self._job.robot.fault_text(self._fault))))
        )
        if self._job.on_trial and hello.free >= WORKING:
            self._confirm(board, hello)
        return hello

    @property
    def _patience_s(self) -> float:
        return max(STARTING_S, min(_PACES * self._job.board.repl.pace_s, _LONGEST_S))

    def _undo(self) -> None:
        """Takes the new line away, so that what was there before starts."""
        if self._job.new is None or self._job.new == self._job.old:
            return
        self._job.insist(self._take_away)
        self._job.board.repl.leave()
        self._job.line.drain(0.2, 1)

    def _take_away(self) -> None:
        self._job.board.remove(self._job.slot)
        self._job.board.remove(TRIAL)
        self._job.board.end()

    def _confirm(self, board: Board, hello: Hello) -> None:
        """Waits for the first ticks of what is on trial, and has the board start it from now on."""
        until = self._job.line.now() + _TRIAL_S
        while hello.state_name == "running" and hello.tick < _TRIAL_TICKS and self._job.line.now() < until:
            board.news(_TRIAL_STEP_S)
            hello = board.greet()
        try:
            board.keep()
        except BoardError:  # it has no memory for that while its program runs
            self._job.insist(self._end_trial)
            self._job.board.repl.leave()
            greet(Board(self._job.line), self._patience_s, sequence=STARTS, starting_s=self._patience_s)

    def _end_trial(self) -> None:
        self._job.board.remove(TRIAL)
        self._job.board.end()


def _last_line(text: str) -> str:
    """The error, when Python reported one: the last line of a traceback."""
    if "Traceback" not in text:
        return ""
    lines = text[text.index("Traceback") :].splitlines()
    return next((line.strip() for line in lines[1:] if line and not line.startswith(" ")), "")[:120]
