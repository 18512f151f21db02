"""The first greeting on a line: to a robot that runs, or to a board at its prompt, whose program is started then.

Everything sent here is harmless to a device that is no KitRobot: a greeting and Ctrl-B are noise to another program,
and Ctrl-C is sent only to a board that has answered in raw paste mode, where an interrupted line leaves it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from threading import Event

from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.line.board import Board, Hello
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.refusals import refusal, silent
from kitrobot.deploy.line.retry_timer import ANSWER_S, SILENT_S, STARTING_S, RetryTimer
from kitrobot_onboard import link

HELLO = b""
LEAVE = b"\r\x02"
"""Gives the prompt, from the raw REPL too."""

_FILL = b" " * 512
"""A board in raw paste mode requests more after so much, with 0x01."""

_MORE = b"\x01"
_OUT_OF_PASTE = b"\x03" + LEAVE
_STOP_RECEIVING = b"\r\x03\x03"
_START = b"\x04"
_PROMPT = b">>> "
_MOST = 4000
_AFTER_S = 2.0
"""After so long without an answer, a person notices the wait."""

_SEQUENCE = (HELLO, HELLO, LEAVE, HELLO, _FILL, HELLO)
STARTS = (LEAVE, HELLO, HELLO)
"""What is sent again and again to a board that is to start its program."""

WaitListener = Callable[[], None]
"""Called once when no answer came at once."""


def _nothing() -> None:
    """Does nothing."""


def connect(
    address: str, silent_s: float = SILENT_S, waits: WaitListener = _nothing, over: Event | None = None
) -> Board:
    """Connects to a board that runs KitRobot; one that stands at its Python prompt is started first.

    Args:
        address: a port or URL.
        silent_s: seconds without a word after which nobody is there.
        waits: called when it takes a while.
        over: once it is set, nothing is waited for any more, also later on this board.

    Raises:
        BrokenOffError: `over` was set.
        LineError: the line cannot be opened.
        SilentError: nobody answers that we understand.
        BoardError: the board speaks another version.
    """
    line = Line(address, over)
    try:
        board = Board(line)
        greet(board, silent_s, waits)
        return board
    except BaseException:
        line.close()
        raise


def greet(
    board: Board,
    silent_s: float = SILENT_S,
    waits: WaitListener = _nothing,
    *,
    sequence: Sequence[bytes] = _SEQUENCE,
    starting_s: float = STARTING_S,
) -> Hello:
    """Greets until the board answers; its `hello` is there then.

    Args:
        board: on an open line, not greeted yet.
        silent_s: seconds without a word after which nobody is there.
        waits: called when it takes a while.
        sequence: what is sent in turn, HELLO or bytes.
        starting_s: the same as `silent_s`, for a program that is started here.

    Raises:
        SilentError: nobody answers; `printed` is what a program said that was started in vain.
        BoardError: the board says no, or speaks another version.
    """
    return _Handshake(board, RetryTimer(board.line.now, silent_s=silent_s), waits, starting_s).run(sequence)


class _Handshake:
    def __init__(self, board: Board, patience: RetryTimer, waits: WaitListener, starting_s: float) -> None:
        self.board = board
        self.patience = patience
        self.waits = waits
        self.starting_s = starting_s
        self.last = HELLO
        """What was sent last."""

        self.until = 0.0
        """When something is sent again."""

        self.heard = b""
        """The end of what came since the board was to start its program, or since the beginning."""

        self.begun = self.filled = self.received = False
        """Whether its program was started here, raw paste mode was looked for, it answered as a receiver of files."""

    def run(self, sequence: Sequence[bytes]) -> Hello:
        board, now, began, turn = self.board, self.board.line.now, self.board.line.now(), 0
        board.number_anew()
        while wait := self.patience.wait():
            if now() - began > _AFTER_S:
                self.waits()
                self.waits = _nothing
            turns = STARTS if self.begun else sequence
            self._send(turns[turn % len(turns)], wait)
            turn += 1
            while True:
                left = self.until - now()
                data = board.line.read(max(left, 0.0))  # what is there is taken, however late we come
                answer = board.take(data, self.patience)
                self.heard = (self.heard + data)[-_MOST:]
                if answer is None:
                    if data:
                        self._read_text()
                elif answer[0] == "H":
                    if self.begun:
                        board.forget_texts()
                    return board.greeted(answer[1])
                elif answer[0] == "N":
                    raise refusal(answer)
                else:
                    self._stop_receiving()
                if left <= 0 or self.patience.left() <= 0:
                    break  # who talks for ever is listened to no longer
        raise self._silent_error()

    def _send(self, data: bytes, wait_s: float = ANSWER_S) -> None:
        self.last = data
        self.filled |= data == _FILL
        self.until = self.patience.now() + wait_s
        if data == HELLO:
            self.board.ask("h", bytes((link.PROTOCOL,)))
        else:
            self.board.line.write(data)

    def _stop_receiving(self) -> None:
        """A deploy broke off, and what takes files still listens; or an answer was on its way since long before."""
        self.board.number_anew()
        if self.received:
            self.board.line.write(_STOP_RECEIVING)
            self.board.line.drain(0.2)
            self._send(LEAVE)
        else:
            self._send(HELLO)
        self.received = not self.received

    def _read_text(self) -> None:
        """Looks whether a board at its prompt has spoken, or one that takes text."""
        text = self.heard
        if self.filled and text and not text.strip(_MORE):
            self.heard = b""
            self._send(_OUT_OF_PASTE)
        elif text.endswith(_PROMPT):
            if self.begun and b"reboot" in text:
                raise self._silent_error()  # what it starts has come to an end, so it is not ours
            if self.last in (LEAVE, _OUT_OF_PASTE):
                if not self.begun:
                    self.patience = RetryTimer(self.patience.now, silent_s=self.starting_s)
                self.begun = True
                self.heard = b""
                self._send(_START)
            elif self.last != _START:
                self.heard = b""
                self._send(LEAVE)

    def _silent_error(self) -> SilentError:
        error = silent(self.board.line.address)
        if self.begun:
            error.printed = self.heard.decode(errors="replace").replace("\r\n", "\n")
        return error
