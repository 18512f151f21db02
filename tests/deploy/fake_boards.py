"""A line to boards that are made up, on a clock of its own: it goes on while somebody waits, and by what is sent.

A board is told what was said and gives what it answers, each with the seconds that pass before it comes. So what takes
a minute takes no time, and the machine that the tests run on decides nothing.
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Callable, Iterable

from kitrobot.deploy.line.line import Line
from kitrobot_onboard.link import unwrap, wrap

Answers = Iterable[tuple[float, bytes]]
HELLO = bytes((1, 2, 0)) + (5000).to_bytes(4, "little") + bytes(8) + b"c0ffee00 12345678"
BYTE_S = 87e-6


class FakeLine(Line):
    """The host's end. `board`: what comes back for what was said."""

    def __init__(self, board: Callable[[bytes], Answers]) -> None:
        self.address = "pretended"
        self.board = board
        self.time = 0.0
        self.said = b""
        self.read_bytes = 0
        self._due: list[tuple[float, int, bytes]] = []
        self._order = itertools.count()

    def now(self) -> float:
        return self.time

    def write(self, data: bytes) -> None:
        self.said += data
        self.time += BYTE_S * len(data)
        for delay, answer in self.board(data):
            heapq.heappush(self._due, (self.time + delay, next(self._order), answer))

    def read(self, timeout_s: float) -> bytes:
        if self._due and self._due[0][0] <= self.time + timeout_s:
            due, _, data = heapq.heappop(self._due)
            self.time = max(self.time, due) + BYTE_S * len(data)
            self.read_bytes += len(data)
            return data
        self.time += max(timeout_s, 1e-3)
        return b""

    def waiting(self) -> int:
        return len(self._due[0][2]) if self._due and self._due[0][0] <= self.time else 0

    def close(self) -> None:
        """There is nothing to close."""


class FakeRobot:
    """One that runs, as docs/reference/link.md wants it. `done`: the requests that it did, in their order.

    Args:
        takes_s: until an answer is there.
        answers: what it says to requests other than those that are done.
    """

    def __init__(self, takes_s: float = 0.01, answers: dict[str, tuple[str, bytes]] | None = None) -> None:
        self.takes_s = takes_s
        self.answers = {"h": ("H", HELLO), "l": ("F", bytes(7)), **(answers or {})}
        self.done: list[str] = []
        self._heard = b""
        self._last: tuple[str, int] | None = None

    def __call__(self, data: bytes) -> Answers:
        *whole, self._heard = (self._heard + data).split(b"~")
        for piece in whole:
            found = unwrap(piece)
            if found is None or not found[1]:
                continue
            if found[:2] != self._last or found[0] in "hlp":
                self.done.append(found[0])
            self._last = found[:2]
            kind, payload = self.answers.get(found[0], ("K", b""))
            yield self.takes_s, wrap(kind, found[1], payload)


class FakePrompt:
    """A board at MicroPython's prompt, or in raw paste mode, that starts `program` `starts_s` after a reset.

    As on a real one, Ctrl-B and Ctrl-D count on an empty line only.
    """

    def __init__(
        self, program: Callable[[bytes], Answers] | None = None, starts_s: float = 1.0, pasting: bool = False
    ) -> None:
        self.program = program
        self.starts_s = starts_s
        self.pasting = pasting
        self.runs = False
        self.pasted = 0
        self.line = b""

    def __call__(self, data: bytes) -> Answers:
        if self.runs and self.program is not None:
            yield from ((self.starts_s + delay, answer) for delay, answer in self.program(data))
            return
        for at in range(len(data)):
            sign = data[at : at + 1]
            if self.pasting:
                self.pasted += 1
                if sign == b"\x03":
                    self.pasting = False
                    yield 0.01, b"\x04Traceback\r\nKeyboardInterrupt: \r\n\x04>"
                elif self.pasted % 128 == 0:
                    yield 0.01, b"\x01"
            elif sign == b"\r":
                self.line = b""
                yield 0.01, b"\r\n>>> "
            elif sign == b"\x02" and not self.line:
                yield 0.01, b"\r\nMicroPython v1.22; made up\r\n>>> "
            elif sign == b"\x04" and not self.line:
                yield 0.01, b"\r\nMPY: soft reboot\r\n"
                self.runs = self.program is not None
                if not self.runs:
                    yield 0.02, b"MicroPython v1.22; made up\r\n>>> "
                return
            elif sign >= b" ":
                self.line += sign
                yield 0.01, sign
