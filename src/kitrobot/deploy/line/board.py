"""The host's end of the link to a board that runs KitRobot's loop: requests with answers, and news in between.

One lock guards the line, so that one thread may wait for news while another sends a stop. Messages that arrive
unrequested while an answer is awaited are queued for `news`. A request is repeated until it is answered; the board
recognises repetitions by their number and executes a request once. Left to others: how long an answer is waited for
(retry_timer), the first greeting (handshake), names for numbers (kitrobot.robots), installing (deploy.installation).
"""

from __future__ import annotations

import math
import random
import struct
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, replace
from threading import RLock
from types import TracebackType

from kitrobot.deploy.errors import DeployError, NoMemoryError
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.news import Fault, News, Text, printable, read_fault, read_news
from kitrobot.deploy.line.refusals import another_version, not_understood, refusal, silent
from kitrobot.deploy.line.retry_timer import ANSWER_S, LONGEST_S, MOST_SILENT_S, PAUSE_S, SILENT_S, RetryTimer
from kitrobot.text.sentences import Sentence
from kitrobot_onboard import link

_HOLD_S = 0.25
"""In a held run the board hears from us at least so often; it gives up after 0.8 seconds."""

_FAREWELL_S = 1.0
_SLICE_S = 0.05
_FRESH_S = 1.0
"""A robot that is watched and runs reports its state; a report older than that, or than two periods, is refreshed."""

_LONGEST_TEXT = 4000
_STEP_CELLS = 8
"""Inputs that are forced by one message: more do not surely fit a frame when all of it is escaped."""

_MEMBER_CELLS = 4
"""The same beside the byte that asks for a tick."""

_FEW_LATE = 4
"""A robot that has just begun is late now and then."""

STATES = ("no program", "ready", "running", "ended", "fault")


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


def is_slow(state: str, late: int, tick: int) -> bool:
    """Whether most ticks of a program that runs took longer than a tick may; False for the first few."""
    return state == "running" and late >= _FEW_LATE and 2 * late > tick


@dataclass(frozen=True)
class Step:
    """The result of one tick: commands as (number, arguments)."""

    tick: int
    fault_flag: bool
    ended: bool
    commands: tuple[tuple[int, tuple[int, ...]], ...]


class Board:
    """A board on an open line; closes it at the end.

    `arguments` tells how many arguments each command has, for `step`; without it no step can be read. `silent_s`, where
    it is not 0: without a word for so long it is gone.
    """

    hello: Hello
    """How it introduced itself last; without a state, memory and program before it is greeted."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.hello = Hello(link.PROTOCOL, 0, 0, 0, 0, 0, 0, "-", "-")
        self.arguments: list[int] = []
        self.silent_s = 0.0
        self.longest_s = LONGEST_S
        self._lock = RLock()
        self._number = random.randrange(1, 256)
        self._heard = b""
        self._waiting: deque[News | Fault | Text] = deque(maxlen=10_000)
        self._held = False
        self._spoke = 0.0
        self._reported_at = -math.inf
        self._since: News | None = None
        self._before_answer = 0
        self._fresh_s = _FRESH_S
        self._signs = 0
        self._took = 0.0

    def __enter__(self) -> Board:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Lets go of the line; the program on the board goes on, unless it is held."""
        self.line.close()

    def hurry(self) -> None:
        """From now on an answer is waited for no longer than a second: what follows is a farewell."""
        self.silent_s = self.longest_s = _FAREWELL_S

    def greet(self) -> Hello:
        """Asks a robot that runs how it is; keeps the answer as `hello`.

        Raises:
            SilentError: nobody answers.
            BoardError: the board speaks another version of the protocol.
        """
        return self.greeted(self._request("h", bytes((link.PROTOCOL,))))

    def greeted(self, payload: bytes) -> Hello:
        """Handles a robot's answer to a greeting.

        Raises:
            BoardError: it speaks another version of the protocol.
        """
        if payload[:1] != bytes((link.PROTOCOL,)):
            raise another_version(payload[0] if payload else 0)
        try:
            protocol, state, fault, free, tick, late, generation = struct.unpack("<BBBIIHH", payload[:15])
        except struct.error:
            raise another_version(payload[0]) from None
        if state >= len(STATES):
            raise not_understood()
        package, _, program = payload[15:].decode("ascii", errors="replace").partition(" ")
        self.hello = Hello(protocol, state, fault, free, tick, late, generation, package, program or "-")
        if self._since is not None:
            self._reported(self._since)  # read together with the answer, and said after it
        return self.hello

    def look(self) -> Hello:
        """The state of the board: its latest report while it runs, for a request makes a tick late; else it is queried.

        Memory and generation are those of the last greeting.

        Raises:
            SilentError: nobody answers.
            BoardError: the board speaks another version of the protocol.
        """
        with self._lock:
            lately = self.line.now() - self._reported_at <= self._fresh_s
            return self.hello if lately and self.hello.state_name == "running" else self.greet()

    def start(self, held: bool = False) -> None:
        """Begins the program. Held: it stops when it does not hear from us; `news` sees to that."""
        with self._lock:
            self._held = held  # before it is answered it may have begun, and wants to hear from us
            try:
                self._request("s", bytes((held,)), first_s=1.0)
            except DeployError:
                self._held = False
                raise
            self._reported_at = -math.inf
            # What was reported before the answer is of another run; a robot that was started reports everything anew.
            before, waiting = self._before_answer, list(self._waiting)
            texts = [one for one in waiting[:before] if isinstance(one, Text)]
            self._waiting = deque([*texts, *waiting[before:]], self._waiting.maxlen)

    def stop(self) -> None:
        """Stops every device and the program."""
        self._held = False
        self._request("x")
        self._reported_at = -math.inf

    def step(self, inputs: Mapping[int, int]) -> Step:
        """Forces inputs and does one tick."""
        cells = list(inputs.items())
        while len(cells) > _STEP_CELLS:
            self.force(*cells.pop(0))
        data = b"".join(struct.pack("<Bi", cell, value) for cell, value in cells)
        payload = self._request("n", data, first_s=2.0)
        commands = []
        at = 5
        try:
            tick, flags = struct.unpack("<IB", payload[:5])
            while at < len(payload):
                number = payload[at]
                count = self.arguments[number]
                commands.append((number, struct.unpack_from(f"<{count}i", payload, at + 1)))
                at += 1 + 4 * count
        except (struct.error, IndexError):
            raise not_understood() from None
        return Step(tick, bool(flags & 1), bool(flags & 2), tuple(commands))

    def begin_member(self) -> None:
        """Begins the program of a member of a team, which then does a tick at each `member_tick`."""
        self._request("s", b"\2", first_s=1.0)

    def member_tick(self, inputs: Mapping[int, int]) -> list[tuple[int, int]]:
        """Forces inputs and does one tick of a member; the numbers that it changed, as (place, value).

        Places: fault flag, inputs and variables, then two for each thread, then those of `out` (see the interpreter)
        for each actuator that the program uses. All are 0 before the first tick. When it is not asked for a while, the
        robot stops.
        """
        cells = list(inputs.items())
        while len(cells) > _MEMBER_CELLS:
            self.force(*cells.pop(0))
        data = b"".join(struct.pack("<Bi", cell, value) for cell, value in cells)
        changes = self._request("m", b"\1" + data, first_s=1.0)
        if len(changes) % 6:
            raise not_understood()
        return list(struct.iter_unpack("<Hi", changes))

    def stand_still(self) -> None:
        """Stops all devices of a member; its program stands where it is until the next tick."""
        self._request("m")

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
                Sentence("this robot has too little memory to tell what its program does"),
                Sentence("the program runs all the same; to watch it, take a board with more memory"),
            ) from None

    def ping(self) -> None:
        """Lets the board know that we are here."""
        self._request("p")

    def identify(self) -> None:
        """Has the board show itself for two seconds."""
        self._request("i")

    def keep(self) -> None:
        """Ends the trial of what was installed last: from now on the board starts it whenever the power comes on."""
        self._request("k")

    def last_fault(self) -> Fault | None:
        """Why it stopped last; None when nothing went wrong."""
        fault = read_fault(self._request("l"))
        return fault if fault.number else None

    def quit(self) -> None:
        """Has the board stop everything and leave to its Python prompt."""
        self._request("q")

    def news(self, timeout: float) -> News | Fault | Text | None:
        """Returns unrequested messages, in their order; None when nothing comes in that many seconds.

        Raises:
            LineError: the line broke.
            SilentError: a board that is held does not answer.
        """
        until = self.line.now() + timeout
        while True:
            with self._lock:
                if self._held and self.line.now() - self._spoke > _HOLD_S:
                    self.ping()
                if not self._waiting:
                    self._take(self._listen(min(_SLICE_S, max(0.0, until - self.line.now()))))
                if self._waiting:
                    return self._waiting.popleft()
            if self.line.now() >= until:
                return None

    def _request(self, kind: str, payload: bytes = b"", *, first_s: float = ANSWER_S) -> bytes:
        with self._lock:
            self.number_anew()
            wanted = {"h": "H", "n": "C", "l": "F", "m": "M" if payload else "K"}.get(kind, "K")
            # Who answered late is asked again later; one that is held must hear from us.
            first_s, most_s = (
                (ANSWER_S, ANSWER_S) if self._held else (max(first_s, min(2 * self._took, PAUSE_S)), PAUSE_S)
            )
            silent_s = self.silent_s or max(SILENT_S, min(4 * self._took, MOST_SILENT_S))
            patience = RetryTimer(self.line.now, first_s, silent_s, self.longest_s, most_s)
            while wait := patience.wait():
                self.ask(kind, payload)
                answer = self.answer(wait, patience)
                if answer is not None:
                    self._took = max(self.line.now() - patience.began, self._took / 2)
                    if answer[0] != wanted:
                        raise refusal(answer)
                    return answer[1]
        raise silent(self.line.address)

    def number_anew(self) -> None:
        """Gives the next request a new number."""
        self._number = self._number % 255 + 1

    def ask(self, kind: str, payload: bytes = b"") -> None:
        """Says a request once."""
        frame = link.wrap(kind, self._number, payload)
        assert len(frame) <= link.LONGEST
        self.line.write(frame)
        self._spoke = self.line.now()

    def answer(self, timeout_s: float, patience: RetryTimer) -> tuple[str, bytes] | None:
        """The answer to the last request, as kind and payload; None when none comes in that time."""
        until = self.line.now() + timeout_s
        while True:
            left = until - self.line.now()
            answer = self.take(self.line.read(max(left, 0.0)), patience)  # what is there is taken, however late we come
            if answer is not None or left <= 0:
                return answer

    def take(self, data: bytes, patience: RetryTimer) -> tuple[str, bytes] | None:
        """Handles bytes from the line; returns the answer to the last request when it is in them."""
        signs = self._signs
        answer = self._take(self._pieces(data))
        if self._signs != signs:
            patience.heard()
        return answer

    def forget_texts(self) -> None:
        """Drops the text that was printed up to now."""
        self._waiting = deque((one for one in self._waiting if not isinstance(one, Text)), self._waiting.maxlen)

    def _listen(self, timeout_s: float) -> list[bytes]:
        return self._pieces(self.line.read(timeout_s))

    def _pieces(self, data: bytes) -> list[bytes]:
        """The pieces between two "~" that are whole; text that does not go on is a piece as well."""
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
            self._signs += found is not None and "A" <= found[0] <= "Z"
            if found is None:
                text = printable(piece)
                if text:
                    self._waiting.append(Text(text))
            elif not "A" <= found[0] <= "Z":
                continue  # our own, from a line that gives back what is said
            elif found[1] == self._number:
                answer = found[0], found[2]
                self._since = None
                self._before_answer = len(self._waiting)
            elif found[1] == 0 and found[0] == "F":
                self._waiting.append(read_fault(found[2]))
                self._reported_at = -math.inf  # the state that it reported before holds no more
            elif found[1] == 0 and found[0] == "T":
                news = read_news(found[2])
                self._waiting.append(news)
                if news.state is not None:
                    self._since = news
                    self._reported(news)
                    self._reported_at = self.line.now()
        return answer

    def _reported(self, news: News) -> None:
        if news.state is not None and news.late is not None:
            self.hello = replace(self.hello, state=news.state, tick=news.tick, late=news.late)
