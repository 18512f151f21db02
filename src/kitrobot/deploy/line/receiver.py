"""File access on a board, over a line that may lose and garble bytes.

A small program that answers each frame is loaded over the raw REPL and is gone after the next reset
(`kitrobot_onboard.receiver`, with the frames of `kitrobot_onboard.link`). A request is repeated until its answer
arrives intact; the board executes it once. So when a method returns, its effect has taken place.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import cycle

from kitrobot.deploy.errors import BoardError, CrampedError, FullError, ResetError, SilentError
from kitrobot.deploy.line.line import LATE_READS, MOST, Line
from kitrobot.deploy.line.raw_paste import run_by_raw_paste
from kitrobot.deploy.line.receiver_text import laid_down, pieces_of, texts
from kitrobot.deploy.line.repl import LONGEST, GarbledError, RawRepl
from kitrobot.deploy.line.retry_timer import RetryTimer
from kitrobot.text.sentences import Sentence
from kitrobot_onboard import link

_DEFINITION_TRIES = 5
_FIRST_S = 0.3
"""How long the first answer is waited for; then twice as long, and so on."""

_SILENT_S = 20.0
_LONGEST_S = 120.0
_BYE_S = 1.0
_ANSWERS = {"x": "DE", "d": "KE", "q": "K"}
_PROMPTS = (b">>> ", b"raw REPL")
_VERSION = re.compile(r"\((\d{1,4}), (\d{1,4}), (\d{1,4})(?:, '([a-z]{0,12})')?\)")
_DIGITS = 12
_KEPT = 8192
"""Bytes of an answer that is not whole yet, at most: more is noise."""

_LONGEST_TEXT = 200
_ALL_LISTED = 16_000
_LISTED = 400
"""Characters of the names of files that are asked for at once."""

MICROBIT = "microbit"
"""What micro:bits call their platform: that of 2016 and the V2."""

_CHIP_OF_2016 = "nRF51"
"""What the micro:bit of 2016 names as its chip in `os.uname()`; a V2 names another one, `nRF52833`."""

_READ = 64
"""Bytes of a file that are asked for at once: a small board has no room for many."""

ByteCounter = Callable[[int], None]
"""Called with the number of bytes that came through since the last call."""


class Receiver:
    """The board's files. `count` is called with the bytes that came through; only the receiver is in memory."""

    def __init__(self, repl: RawRepl, count: ByteCounter = lambda count: None) -> None:
        self.repl = repl
        self.line: Line = repl.line
        self.count = count
        self.modern = self.disturbed = False
        self.family = ""
        """The platform that the board reports."""

        self.is_2016 = False
        """Whether it is the micro:bit of 2016, which alone runs the loop from its flash."""

        self.micropython = ""
        """The version of its MicroPython, as `1.29.0` or `1.30.0-preview`."""

        self.free = 0
        """Bytes of memory that were free on the board when nothing ran."""

        self._numbers = cycle(range(1, 256))
        self._heard = b""
        self._took = 0.0
        """What the last answer took, in seconds, or somewhat less than a slower one before."""

    def begin(self) -> None:
        """Has the board run the receiver.

        Raises:
            SilentError, BoardError: it cannot be brought to do so.
        """
        for attempt in range(_DEFINITION_TRIES):
            try:
                self.repl.enter()
                self._define()
                self._heard = b""
                self.line.write(b"receive()\x04")
                patience = RetryTimer(self.line.now, max(5.0, 10 * self.repl.pace_s))
                if self._frame(0, patience.first_s, patience, after_command=True) is not None:
                    return
            except SilentError:
                if not self.repl.answered or attempt + 1 == _DEFINITION_TRIES:
                    raise
            except GarbledError:
                continue
        raise too_much_lost(self.line.address)

    def end(self) -> None:
        """Back to the prompt of the raw REPL. That is no loss when it cannot be heard: a reset does the same."""
        try:
            self._ask("q", b"", silent_s=_BYE_S)
        except ResetError:
            return
        self.line.drain(0.1)

    def value(self, expression: str, timeout_s: float = 2.0) -> bytes:
        """The value of a Python expression on the board.

        Raises:
            BoardError: it raised an exception there; a CrampedError when that was a MemoryError.
        """
        data = expression.encode()
        assert len(data) < LONGEST - 6, expression
        kind, answer = self._asked("x", data, timeout_s)
        if kind == "E":
            raise _failure(answer)
        return answer

    def number(self, expression: str) -> int:
        """The value of an expression that is a whole number."""
        return _number(self.value(expression))

    def names(self) -> list[str]:
        """The names of all files."""
        found = ""
        while piece := self.value(f"'\\n'.join(os.listdir())[{len(found)}:{len(found) + _LISTED}]").decode(
            errors="replace"
        ):
            found += piece
            if len(piece) > _LISTED or len(found) > _ALL_LISTED:
                raise strange()
            if len(piece) < _LISTED:
                break
        return found.split("\n") if found else []

    def sum_of(self, name: str) -> tuple[int, int]:
        """The length and the Fletcher-16 of a file, worked out by the board."""
        size, _, check = self.value(f"z({name!r})", 20).partition(b" ")
        return _number(size), _number(check)

    def read(self, name: str) -> bytes:
        """The content of a file.

        Raises:
            BoardError: it is longer than any file that lies beside KitRobot, or does not end.
        """
        self.value(f"o({name!r},'rb')")
        content = bytearray()
        while piece := self.value(f"r({_READ})"):
            content += piece
            if len(piece) > _READ:
                raise strange()
            if len(content) > MOST:
                raise BoardError(
                    Sentence("the file `{name}` on the board is too large", name), Sentence("remove it from the board")
                )
            self.count(len(piece))
            if len(piece) < _READ:
                break
        self.value("c()")
        return bytes(content)

    def write(self, name: str, content: bytes) -> None:
        """Writes a file; it is whole when this comes back."""
        if self.family == MICROBIT:
            self.remove(name)  # which frees all of it, and opening it anew frees only its beginning
        self.value(f"o({name!r},'wb')")
        at = 0
        while at < len(content):
            piece = _fitting(content, at)
            kind, answer = self._asked("d", piece, 2)
            if kind == "E":
                raise _failure(answer)
            at += len(piece)
            self.count(len(piece))
        self.value("c()")

    def write_words(self, at: int, words: bytes) -> None:
        """Writes words into erased flash of a micro:bit of 2016, from an address on."""
        self.value(f"w({at})")
        done = 0
        while done < len(words):
            piece = _fitting(words, done)
            piece = piece[: len(piece) // 4 * 4]
            if self._asked("d", piece, 2)[0] == "E":
                raise strange()
            done += len(piece)
            self.count(len(piece))
        self.value("c()")

    def remove(self, name: str) -> None:
        """Removes a file; no matter if there is none."""
        self.value(f"e({name!r})")

    def _define(self) -> None:
        version = self.repl.run("import sys,gc;print(sys.implementation[1])").strip()
        self.repl.run("gc.collect()")
        free = self.repl.run("print(gc.mem_free())").strip()
        self.family = self.repl.run("print(sys.platform)").strip()
        self.is_2016 = self.family == MICROBIT and self._has_chip_of_2016()
        numbers = _VERSION.fullmatch(version)
        if numbers is None or not free.isdecimal() or len(free) > _DIGITS:
            raise GarbledError(version)
        # Where it went wrong once the line is bad, and small steps are the better ones.
        self.micropython = ".".join(str(int(one)) for one in numbers.groups()[:3]) + (
            f"-{numbers[4]}" if numbers[4] else ""
        )
        self.modern = (int(numbers[1]), int(numbers[2])) >= (1, 20) and not self.disturbed
        self.free = int(free)
        for text in texts(self.is_2016):
            self.modern = self.modern and self._lay_at_once(text)
            if not self.modern:
                self._lay_down(text)
            self.repl.run("gc.collect()")
            self.repl.run("exec(s)")
            self.repl.run("s=0;gc.collect()")
        # What was heard as done may have been done by half: all that a text defines is there when its last is.
        self.repl.run("unwrap,file,receive" + (",g,k,Flash,w" if self.is_2016 else ""))

    def _has_chip_of_2016(self) -> bool:
        self.repl.run("import os")
        chip = self.repl.run("print(os.uname()[4])").strip()  # as "micro:bit with nRF51822"
        if "nRF" not in chip:
            raise GarbledError(chip)
        return _CHIP_OF_2016 in chip

    def _lay_at_once(self, text: str) -> bool:
        """Brings a text into the board's `s` through mpremote; whether it is there as it was sent."""
        try:
            run_by_raw_paste(self.line, f"s={text!r}", self.repl.pace_s)
            return all(
                self.repl.run(f"print(repr(s[{at}:{at + 200}]))").strip() == repr(text[at : at + 200])
                for at in range(0, len(text) + 1, 200)
            )
        except GarbledError:
            self.disturbed = True
            self.repl.again()
            return False

    def _lay_down(self, text: str) -> None:
        """Brings a text into the board's `s` piece by piece, each no longer than a command, and compares them."""
        self.repl.run("import gc;t={}")
        pieces = pieces_of(text)
        missing = list(range(len(pieces)))
        for _ in range(_DEFINITION_TRIES):
            for count, number in enumerate(missing):
                self.repl.run(laid_down(number, pieces[number]))
                if count % 4 == 3:
                    self.repl.run("gc.collect()")  # or what the compiler needs is too scattered
            # A command that was garbled may have laid down something elsewhere: all is compared when all is there.
            missing = [
                number
                for number, piece in enumerate(pieces)
                if self.repl.run(f"print(repr(t.get({number})))").strip() != repr(piece)
            ]
            if not missing:
                break
        else:
            raise GarbledError("the receiver")
        self.repl.run("gc.collect()")
        self.repl.run(f"s=''.join(t[i]for i in range({len(pieces)}))")
        self.repl.run("t={};gc.collect()")
        if self.repl.run("print(len(s))").strip() != str(len(text)):
            raise GarbledError("the receiver")

    def _asked(self, kind: str, payload: bytes, timeout_s: float) -> tuple[str, bytes]:
        answer = self._ask(kind, payload, timeout_s)
        if answer is None:
            raise SilentError(
                Sentence("the board on `{address}` stopped answering", self.line.address),
                Sentence("run the command again"),
            )
        return answer

    def _ask(
        self, kind: str, payload: bytes, timeout_s: float = 1.0, silent_s: float = _SILENT_S
    ) -> tuple[str, bytes] | None:
        number = next(self._numbers)
        frame = link.wrap(kind, number, payload)
        assert len(frame) <= link.LONGEST
        first_s = max(_FIRST_S, min(2 * self._took, timeout_s))
        silent_s = max(silent_s, 4 * self._took, min(20 * self.repl.pace_s, _LONGEST_S))
        patience = RetryTimer(self.line.now, first_s, silent_s, _LONGEST_S, timeout_s)
        while wait := patience.wait():
            self.line.write(frame)
            answer = self._frame(number, wait, patience)
            if answer is None:
                continue
            self._took = max(self.line.now() - patience.began, self._took / 2)
            if answer[0] not in _ANSWERS[kind]:
                raise self._reset()  # what answers so is a robot that runs: `x` means stop to it
            return answer
        return None

    def _frame(
        self, number: int, timeout_s: float, patience: RetryTimer, *, after_command: bool = False
    ) -> tuple[str, bytes] | None:
        """The answer to that request; others are older ones that came late, and show that the board is there.

        `after_command`: a command was sent to the raw REPL right before, and its answer is no prompt.

        Raises:
            ResetError: the board stands at a prompt.
        """
        until = self.line.now() + timeout_s
        late = 0
        while True:
            *whole, self._heard = self._heard.split(b"~")
            for position, piece in enumerate(whole):
                found = link.unwrap(piece)
                if found is not None:
                    patience.heard()
                if found is not None and found[1] == number:
                    self._heard = b"~".join([*whole[position + 1 :], self._heard])
                    return found[0], found[2]
                if found is None and not after_command and any(prompt in piece for prompt in _PROMPTS):
                    raise self._reset()
            if not after_command and any(prompt in self._heard for prompt in _PROMPTS):
                raise self._reset()
            self._heard = self._heard[-_KEPT:]
            left = until - self.line.now()
            piece = self.line.read(max(left, 0.0))  # what is there is taken, however late we come
            self._heard += piece
            late += left <= 0
            if (left <= 0 and not piece) or late > LATE_READS:
                return None

    def _reset(self) -> ResetError:
        return ResetError(
            Sentence("the board on `{address}` restarted while it was being written to", self.line.address),
            Sentence("look at its cable and its battery, then run the command again"),
        )


def _failure(answer: bytes) -> BoardError:
    """The error that the board reports."""
    text = answer[:_LONGEST_TEXT].decode(errors="replace")
    if "OSError" in text and ("28" in text or "storage" in text):  # as boards of today and of 2016 say it
        return FullError(
            Sentence("the board's flash is full"), Sentence("remove files of yours from the board, or use --fresh")
        )
    return (CrampedError if text.startswith("MemoryError") else BoardError)(
        Sentence("the board failed: {reason}", text), Sentence("reset it and run the command again")
    )


def too_much_lost(address: str) -> SilentError:
    """The line is too bad."""
    return SilentError(
        Sentence("too much is lost on the way to `{address}`", address),
        Sentence("use another cable, or come nearer with the board"),
    )


def strange() -> BoardError:
    """The board's answer is impossible."""
    return BoardError(
        Sentence("the board sent an answer that cannot be right"), Sentence("reset it and run the command again")
    )


def _number(text: bytes) -> int:
    if not text.isdigit() or len(text) > _DIGITS:
        raise strange()
    return int(text)


def _fitting(content: bytes, at: int) -> bytes:
    """As much of the content as fits a frame to a robot; how much that is hangs on what must be escaped."""
    size = link.LONGEST - 6
    while len(link.wrap("d", 0, content[at : at + size])) > link.LONGEST - 3:
        size -= 1
    return content[at : at + size]
