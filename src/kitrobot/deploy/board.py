"""A board that runs KitRobot's loop, as a host talks to it: requests with answers, and the news in between.

One lock guards the line, so that one thread may wait for news while another says stop. What comes unasked while an
answer is awaited is kept for `news`. Every request is said again until it is answered; the robot does nothing twice.
Left to others: what the numbers are called (workspace), putting something onto a board (installing).
"""

from __future__ import annotations

import math
import random
import struct
import time
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, replace
from threading import RLock
from types import TracebackType

from kitrobot.deploy.errors import BoardError, DeployError, NoMemoryError, SilentError
from kitrobot.deploy.line import Line
from kitrobot.deploy.news import Fault, News, Text, printable, read_fault, read_news
from kitrobot_onboard import link

_ANSWER_S = 0.4
_TRIES = 8
_HOLD_S = 0.25
"""In a held run the board hears from us at least so often; it gives up after 0.8 seconds."""

_SLICE_S = 0.05
_FRESH_S = 1.0
"""A robot that is watched and runs tells how it goes; what is older than that, or than two periods, is asked for."""

_LONGEST_TEXT = 4000
_STEP_CELLS = 8
"""Inputs that are forced by one message: more do not surely fit a frame when all of it is escaped."""

STATES = ("no program", "ready", "running", "ended", "fault")
_MEMORY = 6
_REFUSALS = {
    1: ("the board holds no program that can run", "send one with `kitrobot deploy`"),
    2: ("the program on the board has no such variable or input", "send the program again with `kitrobot deploy`"),
    3: ("the board did not understand the message", "update it with `kitrobot deploy`"),
    4: ("the board did not understand the message", "update it with `kitrobot deploy`"),
    5: ("the board cannot do that now", "stop the program first"),
    6: ("the program needs more memory than the board has", "make the program smaller"),
}


@dataclass(frozen=True)
class Hello:
    """How a board introduces itself: memory in bytes; `package` and `program` by eight digits, "-" for none."""

    protocol: int
    state: int
    fault: int
    free: int
    tick: int
    late: int
    generation: int
    package: str
    program: str

    @property
    def state_name(self) -> str:
        """The state in a word or two."""
        return STATES[self.state] if self.state < len(STATES) else str(self.state)


@dataclass(frozen=True)
class Step:
    """What one tick gave: commands as (number, arguments)."""

    tick: int
    fault_flag: bool
    ended: bool
    commands: tuple[tuple[int, tuple[int, ...]], ...]


class Board:
    """A board on an open line; closes it at the end.

    `arguments` tells how many arguments each command has, for `step`; without it no step can be read.
    """

    def __init__(self, line: Line, tries: int = 5) -> None:
        self.line = line
        self.arguments: list[int] = []
        self._lock = RLock()
        self._number = random.randrange(1, 256)
        self._heard = b""
        self._waiting: deque[News | Fault | Text] = deque(maxlen=10_000)
        self._held = False
        self._spoke = 0.0
        self._told = -math.inf
        self._fresh_s = _FRESH_S
        self.hello = self.greet(tries)

    def __enter__(self) -> Board:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Lets go of the line; the program on the board goes on, unless it is held."""
        self.line.close()

    def greet(self, tries: int = 5) -> Hello:
        """Asks the board how it is; keeps the answer as `hello`.

        Raises:
            SilentError: nobody answers.
            BoardError: the board speaks another version of the protocol.
        """
        kind, payload = self._request("h", bytes((link.PROTOCOL,)), tries=tries)
        if kind != "H":
            # A deploy broke off, and what takes files still listens: this ends it.
            self.line.write(b"\r\x03\x03")
            self.line.drain(0.2)
            raise self._silent()
        if payload[:1] != bytes((link.PROTOCOL,)):
            raise _another_version(payload[0] if payload else 0)
        try:
            protocol, state, fault, free, tick, late, generation = struct.unpack("<BBBIIHH", payload[:15])
        except struct.error:
            raise _another_version(payload[0]) from None
        package, _, program = payload[15:].decode("ascii", errors="replace").partition(" ")
        self.hello = Hello(protocol, state, fault, free, tick, late, generation, package, program or "-")
        return self.hello

    def look(self) -> Hello:
        """How the board is: as it told lately while it runs, for a question makes a tick late; else it is asked.

        Memory and generation are those of the last greeting.

        Raises:
            SilentError: nobody answers.
            BoardError: the board speaks another version of the protocol.
        """
        with self._lock:
            lately = time.monotonic() - self._told <= self._fresh_s
            return self.hello if lately and self.hello.state_name == "running" else self.greet()

    def start(self, held: bool = False) -> None:
        """Begins the program. Held: it stops when it does not hear from us; `news` sees to that."""
        self._request("s", bytes((held,)), timeout_s=1.0)
        self._held = held
        self._told = -math.inf
        # What was told before still says what changed; its tick is of another run.
        for at, one in enumerate(self._waiting):
            if isinstance(one, News):
                self._waiting[at] = replace(one, tick=0)

    def stop(self) -> None:
        """Stops every device and the program."""
        self._held = False
        self._request("x")
        self._told = -math.inf

    def step(self, inputs: Mapping[int, int]) -> Step:
        """Forces inputs and does one tick."""
        cells = list(inputs.items())
        while len(cells) > _STEP_CELLS:
            self.force(*cells.pop(0))
        data = b"".join(struct.pack("<Bi", cell, value) for cell, value in cells)
        _, payload = self._request("n", data, timeout_s=2.0)
        tick, flags = struct.unpack("<IB", payload[:5])
        commands = []
        at = 5
        while at < len(payload):
            number = payload[at]
            if number >= len(self.arguments):
                raise BoardError(*_REFUSALS[3])
            count = self.arguments[number]
            commands.append((number, struct.unpack_from(f"<{count}i", payload, at + 1)))
            at += 1 + 4 * count
        return Step(tick, bool(flags & 1), bool(flags & 2), tuple(commands))

    def force(self, cell: int, value: int | None) -> None:
        """Holds an input at a value; None lets it go."""
        self._request("f", struct.pack("<BBi", cell, value is not None, value or 0))

    def set(self, cell: int, value: int) -> None:
        """Sets a variable."""
        self._request("v", struct.pack("<Bi", cell, value))

    def watch(self, period_ms: int) -> None:
        """Has the board send what changed, at most so often; 0 ends it."""
        try:
            self._request("w", struct.pack("<H", period_ms))
            self._fresh_s = max(_FRESH_S, 2 * period_ms / 1000)
        except NoMemoryError:
            raise NoMemoryError(
                "this robot has too little memory to tell what its program does",
                "the program runs all the same; to watch it, take a board with more memory",
            ) from None

    def ping(self) -> None:
        """Lets the board know that we are here."""
        self._request("p")

    def identify(self) -> None:
        """Has the board show itself for two seconds."""
        self._request("i")

    def last_fault(self) -> Fault | None:
        """Why it stopped last; None when nothing went wrong."""
        _, payload = self._request("l")
        fault = read_fault(payload)
        return fault if fault.number else None

    def quit(self) -> None:
        """Has the board stop everything and leave to its Python prompt."""
        self._request("q")

    def news(self, timeout: float) -> News | Fault | Text | None:
        """What came unasked, in its order; None when nothing comes in that many seconds.

        Raises:
            LineError: the line broke.
            SilentError: a board that is held does not answer.
        """
        until = time.monotonic() + timeout
        while True:
            with self._lock:
                if self._held and time.monotonic() - self._spoke > _HOLD_S:
                    self.ping()
                if not self._waiting:
                    self._take(self._listen(min(_SLICE_S, max(0.0, until - time.monotonic()))))
                if self._waiting:
                    return self._waiting.popleft()
            if time.monotonic() >= until:
                return None

    def _request(
        self, kind: str, payload: bytes = b"", *, timeout_s: float = _ANSWER_S, tries: int = _TRIES
    ) -> tuple[str, bytes]:
        with self._lock:
            self._number = self._number % 255 + 1
            frame = link.wrap(kind, self._number, payload)
            assert len(frame) <= link.LONGEST
            for _ in range(tries):
                self.line.write(frame)
                self._spoke = time.monotonic()
                until = self._spoke + timeout_s
                while (left := until - time.monotonic()) > 0:
                    answer = self._take(self._listen(left))
                    if answer is None:
                        continue
                    if answer[0] == "N":
                        why = answer[1][0] if answer[1] else 0
                        raise (NoMemoryError if why == _MEMORY else BoardError)(*_REFUSALS.get(why, _REFUSALS[3]))
                    return answer
        raise self._silent()

    def _silent(self) -> SilentError:
        return SilentError(
            f"the board on `{self.line.address}` does not answer",
            "press its reset button; when it holds no KitRobot yet, send it a program with `kitrobot deploy`",
        )

    def _listen(self, timeout_s: float) -> list[bytes]:
        """The pieces between two "~" that are whole; text that does not go on is a piece as well."""
        data = self.line.read(timeout_s)
        self._heard += data
        *whole, self._heard = self._heard.split(b"~")
        if (not data and self._heard.endswith(b"\n")) or len(self._heard) > _LONGEST_TEXT:
            whole.append(self._heard)
            self._heard = b""
        return whole

    def _take(self, pieces: list[bytes]) -> tuple[str, bytes] | None:
        """Sorts what came; returns the answer to the last request when it is there."""
        answer = None
        for piece in pieces:
            found = link.unwrap(piece)
            if found is None:
                text = printable(piece)
                if text:
                    self._waiting.append(Text(text))
            elif found[1] == self._number:
                answer = found[0], found[2]
            elif found[1] == 0 and found[0] == "F":
                self._waiting.append(read_fault(found[2]))
            elif found[1] == 0 and found[0] == "T":
                news = read_news(found[2])
                self._waiting.append(news)
                if news.state is not None and news.late is not None:
                    self.hello = replace(self.hello, state=news.state, tick=news.tick, late=news.late)
                    self._told = time.monotonic()
        return answer


def connect(address: str, timeout: float = 4.0) -> Board:
    """Connects to a board that runs KitRobot; one that stands at its Python prompt is started first.

    Raises:
        LineError: the line cannot be opened.
        SilentError: nobody answers that we understand.
        BoardError: the board speaks another version.
    """
    line = Line(address)
    try:
        try:
            return Board(line, 2)
        except SilentError:
            line.write(b"\r\x02")
            if not line.read_until(b">>> ", max(1.0, timeout / 3)).endswith(b">>> "):
                raise
        line.write(b"\x04")  # at the prompt, this starts what is installed
        printed = line.read_until(b">>> ", 0.5)
        try:
            return Board(line, max(2, int(timeout / _ANSWER_S)))
        except SilentError as error:
            error.printed = printable(printed)
            raise
    except BaseException:
        line.close()
        raise


def _another_version(theirs: int) -> DeployError:
    if theirs < link.PROTOCOL:
        return BoardError(
            f"the board speaks version {theirs} of the link, this computer version {link.PROTOCOL}",
            "update the board: `kitrobot deploy`",
        )
    return BoardError(
        f"the board speaks version {theirs} of the link, this computer only version {link.PROTOCOL}",
        "update KitRobot on this computer, or put its version onto the board with `kitrobot deploy`",
    )
