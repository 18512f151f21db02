"""Owns the session of one robot on a worker thread, and executes the requests of its page.

The thread loops: STOP before anything else, then requests in their order, then the robot's news. Everything that waits
for the robot waits here, so twelve robots never wait for one another. While a program runs *held*, the robot
receives something every quarter of a second; it stops by itself within a second otherwise, so a studio that
dies, a cable that is pulled and a page that is closed all end in the same safe way. When the worker ends,
what is held is stopped; what runs free runs on.

Where there are no threads it is a call that sleeps while it waits (`run_in_background`).

`changed` is called from this thread each time that `status` is replaced. Not here: the robot's state
(kitrobot.robots), its status for pages (robot_status), holders and subscribers (robot_registry).
"""

from __future__ import annotations

import logging
import os
import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import Any, get_args

from kitrobot.boards.bench import Bench, PartKey
from kitrobot.boards.sent_firmware import load_firmware_version
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import BackgroundTask, WakeCondition
from kitrobot.live.last_run_recorder import LastRunRecorder
from kitrobot.live.robot_bench import RobotBench
from kitrobot.live.robot_gateway import RobotGateway
from kitrobot.live.robot_status import RobotStatus, no_answer_error, recovery_hint
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.session import RobotSession
from kitrobot.robots.state import Change, ChangeKind
from kitrobot.text.sentences import Recorded, Sentence
from kitrobot.wire.board import BoardMessage, BoardProgressShape, BoardStep

LISTEN_S = 0.05
"""How long the worker listens to the robot before it handles requests again."""
WATCH_MS = 100
"""The shortest interval at which the robot reports changes."""
MOST_ORDERS = 64
STEPS: tuple[BoardStep, ...] = get_args(BoardStep)
_KEPT = Sentence("the robot still has the program that it had")

Order = Callable[[], None]
_log = logging.getLogger("kitrobot.server")


class BusyError(KitRobotError):
    """The robot was sent more requests than it can handle."""


class _CancelledError(Exception):
    """The sending was broken off by the person."""


class RobotWorker:
    """Holds the robot at one address for one page. `changed` is called from the worker's thread."""

    def __init__(
        self,
        address: str,
        name: str,
        holder: str,
        links: RobotGateway,
        changed: Callable[[], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.address, self.name, self.holder = address, name, holder
        self._links = links
        self._changed = changed
        self._orders: deque[Order] = deque()
        self._wake = WakeCondition()
        self._stopping = self._closing = self._cancelled = False
        self.status = RobotStatus()
        self.session = RobotSession(clock)
        self.recorder = LastRunRecorder(name, self.session)
        self._bench: RobotBench | None = None
        self.session.subscribe(self._robot_changed)
        self._task = BackgroundTask(self._serve, f"board-{address}")

    # -- requests, from any thread

    def connect(self, program: BoardProgram | None) -> None:
        """Greets the robot; `program` gives names to what it does, if it has that."""
        self._order(lambda: self._connect(program))

    def send(self, program: BoardProgram, then: str, replace: bool = False, fresh: bool = False) -> None:
        """Puts a program on the robot and lets it run: "held", "free", or "ready" for not yet. `replace`: also in the
        place of what is not ours.
        """
        self._cancelled = False
        self._order(lambda: self._send(program, then, replace, fresh))

    def bench(self, bench: Bench, replace: bool = False) -> None:
        """Puts the program that tries its parts on the robot, which then waits for steps."""
        self._cancelled = False
        self._order(lambda: self._begin_bench(RobotBench(self.session, bench), None, replace))

    def try_step(self, at: int | None) -> None:
        """Does that step of the bench until the next one; None ends it."""
        self._order(lambda: self._try(at))

    def cancel(self) -> None:
        """Cancels sending."""
        self._cancelled = True

    def start(self, held: bool) -> None:
        """Begins the program that it has."""
        self._order(lambda: self._start(held))

    def stop(self) -> None:
        """Stops it before anything else, and drops pending requests."""
        with self._wake:
            self._stopping = self._cancelled = True
            self._orders.clear()
            self._wake.notify()

    def identify(self) -> None:
        """Has the robot show which one it is."""
        self._order(lambda: self.session.link.identify())

    def force(self, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures; None gives the sensor back."""
        self._order(lambda: self.session.force(sensor, value))

    def set_variable(self, variable: str, value: int) -> None:
        """Sets a variable."""
        self._order(lambda: self.session.set_variable(variable, value))

    @property
    def closing(self) -> bool:
        """Whether it is closing, or closed."""
        return self._closing

    def close(self) -> None:
        """Releases the robot: one that is held stops."""
        with self._wake:
            self._closing = self._cancelled = True
            self._wake.notify()

    def wait(self, within_s: float) -> None:
        """Waits until it has ended, at most `within_s` seconds."""
        self._task.wait(within_s)

    def _order(self, order: Order) -> None:
        with self._wake:
            if len(self._orders) >= MOST_ORDERS:
                raise BusyError(
                    Sentence("the robot does not keep up with what it is asked for"), Sentence("wait a moment")
                )
            self._orders.append(order)
            self._wake.notify()

    # -- the thread

    def _serve(self) -> None:
        while not self._closing:
            order = self._next()
            if self._stopping:
                self._stopping = False
                self._attempt(self._stop)
            elif order is not None:
                self._attempt(order)
            elif self.session.is_open and not self._closing:
                self._attempt(self._listen)
        state = self.session.state
        if state.held and state.doing == "running":
            self._attempt(self._stop)
        for sensor in state.forced:
            self._attempt(lambda name=sensor: self.session.force(name, None))  # type: ignore[misc]
        self.session.close()
        self.recorder.close()
        self._update_status(phase="closed")

    def _next(self) -> Order | None:
        """What is to be done now; waits for it while there is no robot to listen to."""
        with self._wake:
            while not (self._orders or self._stopping or self._closing or self.session.is_open):
                self._wake.wait()
            return self._orders.popleft() if self._orders and not self._stopping else None

    def _attempt(self, work: Order) -> None:
        """Does something with the robot; every error is reported, and nothing is left half open."""
        try:
            work()
        except KitRobotError as error:
            if self.session.is_open and self._links.is_lost(error):
                self._lose()
            else:
                self._update_status(message=error.message, help=recovery_hint(error))
        except Exception as error:
            # What a broken line or a strange robot brings about; the session goes on.
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.warning("the link to a robot broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            self._lose()

    def _lose(self) -> None:
        state = self.session.state
        if state.doing != "running":
            message = Recorded("the link to `{robot}` is lost", self.name)
        elif state.held:
            message = Recorded("the link to `{robot}` is lost: its motors stop within one second", self.name)
        else:
            message = Recorded("the link to `{robot}` is lost; it runs on by itself", self.name)
        self.session.lose(message)
        self._update_status(
            phase="lost", progress=None, message=message, help=Sentence("look at its cable, then press Reconnect")
        )

    # -- the orders

    def _connect(self, program: BoardProgram | None) -> None:
        self.session.close()
        self._update_status(phase="connecting", message="", help="", way="", progress=None)
        try:
            self._greet(program)
        except (KitRobotError, OSError) as error:
            self.session.close()
            said = error if isinstance(error, KitRobotError) else no_answer_error(self.name)
            self._update_status(phase="closed", message=said.message, help=recovery_hint(said))
        else:
            self._follow()

    def _greet(self, program: BoardProgram | None) -> None:
        link = self._links.connect(self.address)
        try:
            hello = link.greet()
        except BaseException:
            link.close()
            raise
        known = program.known if program is not None and program.is_called(hello.program) else None
        self.session.open(link, hello, known)
        self._update_status(phase="open", micropython=load_firmware_version(self.address, hello))

    def _follow(self) -> None:
        """Subscribes to the changes of a robot whose program is known. One that does not answer any more is lost."""
        if self.session.known is not None:
            self.session.watch(WATCH_MS)

    def _send(self, program: BoardProgram, then: str, replace: bool, fresh: bool) -> None:
        def put() -> BoardProgram:
            self._links.deploy(self.address, program, self._progress, replace, fresh)
            return program

        if not self._put(put):
            return
        if then == "ready":
            self._stop()
        else:
            self._start(then == "held")
        if (warning := program.warning) is not None:
            self._update_status(message=warning.message, help=warning.help)

    def _put(self, put: Callable[[], BoardProgram]) -> bool:
        """Puts a program on the robot and greets it; returns whether that succeeded, else the error is reported."""
        self._bench = None
        self.session.close()
        self.session.replaced()
        self._update_status(phase="sending", message="", help="", way="")
        try:
            program = put()
            self._update_status(progress=None)
            self._greet(program)
        except _CancelledError:
            self._update_status(
                phase="closed", progress=None, message=Sentence("the sending was broken off"), help=_KEPT
            )
            return False
        except (KitRobotError, OSError) as error:
            self.session.close()
            said = error if isinstance(error, KitRobotError) else no_answer_error(self.name)
            way = self._links.way(said)
            self._update_status(phase="closed", progress=None, message=said.message, help=recovery_hint(said), way=way)
            return False
        self._follow()
        return True

    def _begin_bench(self, bench_run: RobotBench, needed: PartKey | None, replace: bool) -> None:
        def deploy(program: BoardProgram, fresh: bool) -> None:
            self._links.deploy(self.address, program, self._progress, replace, fresh)

        if self._put(lambda: bench_run.load(needed, deploy)):
            self._bench = bench_run
            bench_run.hand.restart()
            self._update_status()

    def _try(self, at: int | None) -> None:
        bench_run = self._bench
        if bench_run is None or not self.session.is_open:
            return
        needed = bench_run.needs(at)
        if needed is not None:
            self._begin_bench(bench_run, needed, False)
        if self._bench is not None:
            bench_run.do(at)
            self._update_status()

    def _progress(self, step: Any, done: int, total: int) -> None:
        if self._cancelled:
            raise _CancelledError
        if step in STEPS:
            self._update_status(progress=BoardProgressShape(step=step, done=done, total=total))

    def _start(self, held: bool) -> None:
        self.session.start(held)
        self._update_status(message="", help="")

    def _stop(self) -> None:
        if self._bench is not None:
            self._bench.hand.step = None
        if self.session.is_open:
            self.session.stop()

    # -- messages of the robot

    def _listen(self) -> None:
        self.session.poll(LISTEN_S)
        if self._bench is not None:
            self._bench.check()
            self._update_status()
        error = self.recorder.error()
        if error is not None:
            self._update_status(message=error.message, help=Sentence("what was recorded before can be saved"))

    def _robot_changed(self, change: Change) -> None:
        if change.kind is not ChangeKind.REBOOTED:
            self._update_status()
            return
        help = Sentence("it may have lost its power for a moment: look at its battery and cable")
        if change.state.doing != "running":
            help = Sentence("it was stopped; it may have lost its power for a moment: look at its battery and cable")
        self._update_status(message=Sentence("`{robot}` began anew by itself", self.name), help=help)

    # -- status

    def _update_status(self, **changes: Any) -> None:
        session, recorded = self.session, self.recorder.is_there
        names = session.known.names if session.known is not None else None
        # The state of its program changes all the time, and is sent as a run.
        state = replace(session.state, tick=0, late=0, threads={}, cells={}, forced={})
        bench = self._bench.shape() if self._bench is not None else None
        now = replace(self.status, robot=state, names=names, recorded=recorded, bench=bench, **changes)
        if now == self.status:
            return
        self.status = replace(now, version=self.status.version + 1)
        self._changed()

    def message(self) -> BoardMessage:
        """The status as a message to pages."""
        return self.status.to_message(self.address, self.name, self.holder)
