"""A robot whose parts are tried: the program for as many parts as fit and start, the start and end of steps, and
values.

Everything stops when a step ends, when the run is closed, and on the robot itself when it receives nothing from here
for 0.8 s, since it is held. Left to others: the program for the parts (bench_loader).

`BenchHand` works on a session that its caller owns (the studio's worker, or `BenchRun`, which has its own).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from types import TracebackType

from kitrobot.boards.bench import Bench, BenchStep, PartKey
from kitrobot.boards.bench_loader import WIRES, PartError, blamed_part, load_parts, reason_of
from kitrobot.boards.programs import send_program
from kitrobot.deploy.errors import DeployError, FirmwareError, ForeignError, LineError, SilentError
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.news import News
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.robot import Category
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.session import RobotSession
from kitrobot.text.sentences import Sentence

PERIOD_MS = 100
"""How often values are told, at most."""

_STEP_S = 0.05
_LINK_LOST = 6
"""The fault of a robot that was held and heard nothing (docs/reference/link.md)."""
_SETTLED_TICKS = 5
"""Until then the value of a sensor may be the one at which it was held."""
_CALLED_TICKS = 20
"""By then a step is called, though its number was not told: one that comes back within a period is not."""
_FEW_TICKS = 4
"""Of fewer late ticks nothing is said: a robot that has just begun is late now and then."""
_LEAST_TICKS = 6
"""So many ticks are watched at least, of a driver that makes them long."""

Progress = Callable[[str, int, int], None]
"""Is told what is done now, and how many bytes of how many."""

OF_THE_BOARD = (LineError, SilentError, ForeignError, FirmwareError)
"""What no other part would fare better with."""


class BenchHand:
    """Steps on a robot that holds the program of these parts, over a session that is open."""

    def __init__(self, session: RobotSession, bench: Bench, parts: frozenset[PartKey]) -> None:
        self.session, self.bench, self.parts = session, bench, parts
        self.step: BenchStep | None = None
        """What is done now."""

        self._begun = self._late_before = 0
        self._valid_from = self._called_by = 0
        """Ticks of the robot: the value of the step counts from the first, and the step is called in the second."""

    def restart(self) -> None:
        """Begins the program anew, held, with all its sensors held."""
        self.session.stop()
        for part in self.bench.robot.sensors:
            if (part.category, part.name) in self.parts:
                self.session.force(part.name, part.minimum)
        self.session.start(held=True)
        self.session.watch(PERIOD_MS)

    def begin(self, step: BenchStep) -> None:
        """Does a step until `end`; of a sensor, looks at it.

        Raises:
            KitRobotError: the robot does not answer, or says no.
        """
        self.end()
        # It is asked: what was heard last may be old, when a person thought for a while.
        hello = self.session.link.greet()
        if {hello.state_name, self.session.state.doing} != {"running"}:
            self.restart()
            hello = self.session.link.greet()
        self._late_before = hello.late
        self.step, now = step, self.session.state.tick
        self._begun = now
        self._valid_from, self._called_by = now + _SETTLED_TICKS, now + _CALLED_TICKS
        if step.part.category is not Category.SENSOR:
            self.session.set_variable(self.bench.variable, step.number)
            return
        try:
            self.session.force(step.part.name, None)
        except (LineError, SilentError):
            raise
        except DeployError:
            return  # it cannot be read: the robot says so as a fault, in its next tick

    def end(self) -> None:
        """Ends the step that is done."""
        step, self.step = self.step, None
        if step is None or self.session.state.doing != "running":
            return
        if step.part.category is Category.SENSOR:
            self.session.force(step.part.name, step.part.minimum)
        else:
            self.session.set_variable(self.bench.variable, 0)

    def check(self) -> None:
        """Looks whether the part of the step failed, after news.

        Raises:
            PartError: it did.
        """
        fault, known = self.session.state.fault, self.session.known
        self._notice_call()
        if fault is None or self.step is None:
            return
        step, self.step = self.step, None
        if fault.number == _LINK_LOST:
            return  # it heard nothing for a while, and stands; no part is to blame
        blamed = blamed_part(known.names, fault.text) if known is not None else None
        key = blamed or step.key
        reason = reason_of(fault.text, fault.meaning)
        raise PartError(Sentence("`{part}` failed: {reason}", key[1], reason), WIRES, part=key)

    def _notice_call(self) -> None:
        """What the robot tells after a tick is called in the next one."""
        known, news, step = self.session.known, self.session.news, self.step
        if known is None or step is None or not isinstance(news, News):
            return
        if news.cells.get(known.names.variables[self.bench.variable]) == step.number:
            self._called_by = min(self._called_by, news.tick + 1)

    @property
    def value(self) -> int | None:
        """What the sensor of the step measures; None for an actuator and before it is told."""
        step, known, state = self.step, self.session.known, self.session.state
        if step is None or known is None or step.part.name not in known.names.sensors or state.tick < self._valid_from:
            return None
        return state.cells.get(known.names.sensors[step.part.name]) if self.looks else None

    @property
    def late(self) -> int:
        """How many ticks began late since the step began."""
        return max(0, self.session.state.late - self._late_before)

    @property
    def is_slow(self) -> bool:
        """Whether the driver of the part takes longer than a tick: most ticks of the step began late."""
        return self.step is not None and self.late >= _FEW_TICKS and 2 * self.late > self.ticks

    @property
    def ticks(self) -> int:
        """How many ticks the robot has done since the step began."""
        return self.session.state.tick - self._begun

    @property
    def looks(self) -> bool:
        """Whether the step is to look at a sensor."""
        return self.step is not None and self.step.part.category is Category.SENSOR

    @property
    def is_on(self) -> bool:
        """Whether the robot has had a tick with what the step calls, or the step has none to wait for."""
        if self.step is None or self.looks or self.step.lasts is not None:
            return True
        return self.session.state.tick >= self._called_by

    @property
    def is_over(self) -> bool:
        """Whether a step that ends by itself has ended."""
        known = self.session.known
        return known is None or self.session.state.cells.get(known.names.variables[self.bench.variable]) == 0


class BenchRun:
    """The steps of a bench on the robot at an address; `broken` says of parts what is wrong with them."""

    def __init__(
        self,
        address: str,
        bench: Bench,
        progress: Progress = lambda stage, done, total: None,
        *,
        replace: bool = False,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.address = address
        self.bench = bench
        self.broken: dict[PartKey, KitRobotError] = {}
        self._progress = progress
        self._replace = replace
        self._clock = clock
        self._hand = BenchHand(RobotSession(clock), bench, frozenset())

    def __enter__(self) -> BenchRun:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Stops the robot and lets go of it."""
        session = self._hand.session
        if session.is_open:
            # One that does not answer is held, and stops by itself.
            session.link.hurry()
            with suppress(KitRobotError):
                session.stop()
            session.close()

    def begin(self, step: BenchStep) -> None:
        """Does a step until `end`; of a sensor, looks at it.

        Raises:
            PartError: the part is broken, or the board cannot take the program that tries it.
            KitRobotError: the robot does not answer, or holds somebody else's program.
        """
        if step.key in self.broken:
            raise self.broken[step.key]
        if step.key not in self._hand.parts or not self._hand.session.is_open:
            try:
                self._load(step)
            except (PartError, *OF_THE_BOARD):
                raise
            except KitRobotError as error:
                why = Sentence("`{part}` cannot be tried: {reason}", step.key[1], error.message)
                self.broken[step.key] = PartError(why, error.help, error.diagnostics, part=step.key)
                raise self.broken[step.key] from error
        self._hand.begin(step)

    def end(self) -> None:
        """Ends the step that is done."""
        self._hand.end()

    def poll(self, timeout_s: float) -> None:
        """Waits for news at most so long, and lets the robot know that we are here.

        Raises:
            PartError: the part of the step failed.
            KitRobotError: the link is lost.
        """
        if not self._hand.session.is_open:
            time.sleep(timeout_s)
            return
        self._hand.session.poll(timeout_s)
        self._hand.check()

    def keep_alive(self) -> None:
        """Lets the robot know that we are here, without waiting, while a person is asked.

        Raises:
            KitRobotError: the link is lost.
        """
        if self._hand.session.is_open:
            self.poll(0.0)

    def watch(self, seconds: float) -> list[int]:
        """Waits so long; the values that the part of the step had meanwhile, for a sensor.

        Raises:
            KitRobotError: as `poll`.
        """
        seen: list[int] = []
        until = self._clock() + seconds
        hand = self._hand
        while self._clock() < until or not hand.is_on or (hand.looks and not seen) or 0 <= hand.ticks < _LEAST_TICKS:
            self.poll(_STEP_S)
            if (value := self.value) is not None and (not seen or seen[-1] != value):
                seen.append(value)
        return seen

    def finish(self, longest_s: float) -> None:
        """Waits until a step that ends by itself has ended.

        Raises:
            PartError: it takes longer than that, or its part failed.
            KitRobotError: the link is lost.
        """
        step = self._hand.step
        assert step is not None
        until = self._clock() + longest_s
        while not self._hand.is_over:
            self.poll(_STEP_S)
            if self._clock() > until:
                self._hand.session.stop()
                self._hand.step = None
                raise PartError(Sentence("`{part}` did not say that it is done", step.part.name), WIRES)
        self._hand.step = None

    @property
    def value(self) -> int | None:
        """What the sensor of the step measures; None for an actuator and before it is told."""
        return self._hand.value

    @property
    def is_on(self) -> bool:
        """Whether the robot does what the step says."""
        return self._hand.is_on

    @property
    def late(self) -> int:
        """How many ticks began late since the step began."""
        return self._hand.late

    @property
    def is_slow(self) -> bool:
        """Whether the driver of the step's part takes longer than a tick."""
        return self._hand.is_slow

    def _load(self, step: BenchStep) -> None:
        self.close()
        parts, program = load_parts(self.bench, step.key, self.broken, self._send)
        board = connect(self.address)
        self._hand.session.open(board, board.hello, program.known)
        self._hand = BenchHand(self._hand.session, self.bench, parts)
        self._hand.restart()

    def _send(self, program: BoardProgram, fresh: bool) -> None:
        def report_progress(address: str, stage: str, done: int, total: int) -> None:
            self._progress(stage, done, total)

        (sent,) = send_program(program, [self.address], report_progress, replace=self._replace, fresh=fresh)
        if sent.error is not None:
            raise sent.error
