"""One real robot in the studio's hand: its link in a thread of its own, what is asked of it, how it stands.

The thread goes round: STOP before anything else, then what was asked for in its order, then the robot's news. All that
waits for the robot waits here, so twelve robots never wait for one another. While a program runs *held*, the robot
hears something every quarter of a second; it stops by itself within a second when it hears nothing, so a studio that
dies, a cable that is pulled and a page that is closed all end in the same safe way. When the hand opens, what is held
is stopped; what runs free runs on.

How it stands is one value that is replaced as a whole (`standing`), and `changed` is called from this thread each time.
Left to others: the link itself (deploy), names for numbers (workspace), who may ask and who is told (board_room).
"""

from __future__ import annotations

import logging
import os
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, get_args

from kitrobot.deploy import Fault, ForeignError, FullError, LineError, News, SilentError
from kitrobot.diagnostics import KitRobotError
from kitrobot.server.board_links import Board, Links
from kitrobot.server.board_tape import Tape
from kitrobot.server.sentences import spoken
from kitrobot.server.shapes import (
    BoardFaultShape,
    BoardMessage,
    BoardPhase,
    BoardProgressShape,
    BoardState,
    BoardStep,
    BoardWay,
)

if TYPE_CHECKING:
    from kitrobot.workspace import BoardNames, BoardProgram

LISTEN_S = 0.05
"""How long the robot is listened to before what was asked for meanwhile is looked at."""
LOOK_S = 0.5
"""How often it is looked how it stands; it is asked only while it tells nothing of that itself."""
WATCH_MS = 100
"""The robot tells what changed at most so often."""
MOST_ORDERS = 64
STATES: tuple[BoardState, ...] = ("none", "ready", "running", "ended", "fault")
STEPS: tuple[BoardStep, ...] = get_args(BoardStep)
RUNNING = "running"
LONGEST_TEXT = 500
_KEPT = "the robot still has the program that it had"

Order = Callable[[], None]
_log = logging.getLogger("kitrobot.server")


class BusyError(KitRobotError):
    """The robot was asked for more than it can do."""


class NotNowError(KitRobotError):
    """Nobody talks with the robot, or it has another program."""


class _Cancelled(Exception):
    """The sending was broken off by the person."""


@dataclass(frozen=True)
class Standing:
    """How a robot stands; `version` grows with each change."""

    version: int = 0
    phase: BoardPhase = "closed"
    state: BoardState = "none"
    held: bool = False
    free: int = 0
    tick: int = 0
    generation: int = 0
    package: str = ""
    installed: str = ""
    known: BoardNames | None = None
    threads: dict[int, int] = field(default_factory=dict)
    cells: dict[int, int] = field(default_factory=dict)
    forced: dict[str, int] = field(default_factory=dict)
    progress: BoardProgressShape | None = None
    fault: BoardFaultShape | None = None
    message: str = ""
    help: str = ""
    way: BoardWay = ""
    recorded: bool = False


class Hand:
    """Holds the robot at one address for one page. `changed` is called from the thread of the hand."""

    def __init__(
        self,
        address: str,
        name: str,
        holder: str,
        links: Links,
        changed: Callable[[], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.address, self.name, self.holder = address, name, holder
        self._links = links
        self._changed = changed
        self._clock = clock
        self._board: Board | None = None
        self._orders: deque[Order] = deque()
        self._wake = threading.Condition()
        self._stopping = self._closing = self._cancelled = False
        self._looked = 0.0
        self.standing = Standing()
        self.tape = Tape(name)
        self._thread = threading.Thread(target=self._serve, name=f"board-{address}", daemon=True)
        self._thread.start()

    # -- what is asked for, from any thread

    def connect(self, program: BoardProgram | None) -> None:
        """Greets the robot; `program` gives names to what it does, if it has that."""
        self._order(lambda: self._connect(program))

    def send(self, program: BoardProgram, then: str, replace: bool = False, fresh: bool = False) -> None:
        """Puts a program on the robot and lets it run: "held", "free", or "ready" for not yet. `replace`: also in the
        place of what is not ours.
        """
        self._cancelled = False
        self._order(lambda: self._send(program, then, replace, fresh))

    def cancel(self) -> None:
        """Breaks off the sending."""
        self._cancelled = True

    def start(self, held: bool) -> None:
        """Begins the program that it has."""
        self._order(lambda: self._start(held))

    def stop(self) -> None:
        """Stops it before anything else, and forgets what was asked for and not done."""
        with self._wake:
            self._stopping = self._cancelled = True
            self._orders.clear()
            self._wake.notify()

    def identify(self) -> None:
        """Lets it show which one it is."""
        self._order(lambda: self._open().identify())

    def force(self, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures; None gives the sensor back."""
        self._order(lambda: self._force(sensor, value))

    def set_variable(self, variable: str, value: int) -> None:
        """Sets a variable."""
        self._order(lambda: self._set(variable, value))

    @property
    def closing(self) -> bool:
        """Whether it lets go, or has."""
        return self._closing

    def close(self) -> None:
        """Lets go of the robot: one that is held stops."""
        with self._wake:
            self._closing = self._cancelled = True
            self._wake.notify()

    def wait(self, within_s: float) -> None:
        """Waits until it has let go, but not for ever."""
        self._thread.join(within_s)

    def _order(self, order: Order) -> None:
        with self._wake:
            if len(self._orders) >= MOST_ORDERS:
                raise BusyError("the robot does not keep up with what it is asked for", "wait a moment")
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
            elif self._board is not None and not self._closing:
                self._attempt(self._listen)
        if self.standing.held and self.standing.state == RUNNING:
            self._attempt(self._stop)
        for sensor in self.standing.forced:
            self._attempt(lambda name=sensor: self._force(name, None))  # type: ignore[misc]
        self._hang_up()
        self.tape.close()
        self._say(phase="closed", held=False)

    def _next(self) -> Order | None:
        """What is to be done now; waits for it while there is no robot to listen to."""
        with self._wake:
            while not (self._orders or self._stopping or self._closing or self._board is not None):
                self._wake.wait()
            return self._orders.popleft() if self._orders and not self._stopping else None

    def _attempt(self, work: Order) -> None:
        """Does something with the robot; whatever goes wrong is said, and nothing is left half open."""
        try:
            work()
        except KitRobotError as error:
            if self._board is not None and self._links.is_lost(error):
                self._lose()
            else:
                self._say(message=error.message, help=_way_out(error))
        except Exception as error:
            # What a broken line or a strange robot brings about; the hand goes on.
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.warning("the link to a robot broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            self._lose()

    def _lose(self) -> None:
        was = self.standing
        self._hang_up()
        running = was.state == RUNNING
        if running and was.held:
            message = f"the link to `{self.name}` is lost: its motors stop within one second"
        elif running:
            message = f"the link to `{self.name}` is lost; it runs on by itself"
        else:
            message = f"the link to `{self.name}` is lost"
        self.tape.lost(message)
        self._say(
            phase="lost", threads={}, progress=None, message=message, help="look at its cable, then press Reconnect"
        )

    def _hang_up(self) -> None:
        board, self._board = self._board, None
        if board is not None:
            try:
                board.close()
            except (KitRobotError, OSError):
                # Whoever closes it cares no more for what it says.
                return

    def _open(self) -> Board:
        if self._board is None:
            raise NotNowError("nobody talks with this robot", "connect it first")
        return self._board

    # -- the orders

    def _connect(self, program: BoardProgram | None) -> None:
        self._hang_up()
        self._say(phase="connecting", message="", help="", way="", progress=None)
        try:
            self._greet(program)
        except (KitRobotError, OSError) as error:
            self._hang_up()
            said = error if isinstance(error, KitRobotError) else _no_answer(self.name)
            self._say(phase="closed", message=said.message, help=_way_out(said))

    def _greet(self, program: BoardProgram | None) -> None:
        self._board = board = self._links.connect(self.address)
        hello = board.greet()
        self._looked = self._clock()
        named = program if program is not None and program.is_called(hello.program) else None
        known = named.names if named is not None else None
        self.tape.greeted(named, hello.program, STATES[hello.state], hello.tick)
        self._say(
            phase="open",
            state=STATES[hello.state],
            held=False,
            free=hello.free,
            tick=hello.tick,
            generation=hello.generation,
            package=hello.package,
            installed=hello.program,
            known=known,
            threads={},
            cells={},
            forced={},
            fault=None,
        )
        if STATES[hello.state] == "fault":
            self._tell_fault(board.last_fault())
        if known is not None:
            board.watch(WATCH_MS)

    def _send(self, program: BoardProgram, then: str, replace: bool, fresh: bool) -> None:
        self._hang_up()
        self.tape.stopped()
        self._say(phase="sending", known=None, threads={}, message="", help="", way="", fault=None)
        try:
            self._links.deploy(self.address, program, self._progress, replace, fresh)
            self._say(progress=None)
            self._greet(program)
        except _Cancelled:
            self._say(phase="closed", progress=None, message="the sending was broken off", help=_KEPT)
            return
        except (KitRobotError, OSError) as error:
            self._hang_up()
            said = error if isinstance(error, KitRobotError) else _no_answer(self.name)
            way = self._links.way(said)
            self._say(phase="closed", progress=None, message=said.message, help=_way_out(said), way=way)
            return
        if then == "ready":
            self._stop()
        else:
            self._start(then == "held")
        if (warning := program.warning) is not None:
            self._say(message=warning.message, help=warning.help)

    def _progress(self, step: Any, done: int, total: int) -> None:
        if self._cancelled:
            raise _Cancelled
        if step in STEPS:
            self._say(progress=BoardProgressShape(step=step, done=done, total=total))

    def _start(self, held: bool) -> None:
        board = self._open()
        board.start(held=held)
        was = self.standing
        sensors = was.known.sensors.values() if was.known is not None else ()
        self.tape.started({cell: was.cells[cell] for cell in sensors if cell in was.cells}, was.forced)
        self._say(state=RUNNING, held=held, tick=0, threads={}, fault=None, message="", help="")

    def _stop(self) -> None:
        if self._board is None:
            return
        self._open().stop()
        self.tape.stopped()
        self._say(state="ready", held=False, threads={})

    def _force(self, sensor: str, value: int | None) -> None:
        known = self._known()
        self._open().force(known.input(sensor), value)
        self.tape.forced(sensor, value)
        forced = {name: held for name, held in self.standing.forced.items() if name != sensor}
        self._say(forced=forced if value is None else {**forced, sensor: value})

    def _set(self, variable: str, value: int) -> None:
        self._open().set(self._known().variable(variable), value)
        self.tape.variable_set(variable, value)

    def _known(self) -> BoardNames:
        if self.standing.known is None:
            raise NotNowError("the robot has another program than the one that is open here", "send this one first")
        return self.standing.known

    # -- what the robot says

    def _listen(self) -> None:
        board = self._board
        assert board is not None
        if self._clock() - self._looked >= LOOK_S:
            self._look(board)
        news = board.news(LISTEN_S)
        if isinstance(news, Fault):
            self._tell_fault(news)
            return
        self.tape.told(news)
        if isinstance(news, News):
            self._take_in(news)
        error = self.tape.error()
        if error is not None:
            self._say(message=error.message, help="what was recorded before can be saved")

    def _look(self, board: Board) -> None:
        """How it stands."""
        self._looked = self._clock()
        hello = board.look()
        state, was = STATES[hello.state], self.standing
        if state != was.state:
            self.tape.stands(state, hello.tick)
        if state == was.state == RUNNING and hello.tick < was.tick:
            self._began_anew(board)
            return
        ended = was.state == RUNNING and state != RUNNING
        if ended or (state, hello.free) != (was.state, was.free):
            self._say(state=state, free=hello.free, tick=hello.tick, threads={} if ended else was.threads)
        if state == "fault" and was.fault is None:
            self._tell_fault(board.last_fault())

    def _began_anew(self, board: Board) -> None:
        """It was without power for a moment, and runs by itself as it does when that comes back."""
        message = f"`{self.name}` began anew by itself"
        self.tape.began_anew()
        if self.standing.held:
            board.stop()
            self.tape.stopped()
            help = "it was stopped; it may have lost its power for a moment: look at its battery and cable"
            self._say(state="ready", held=False, threads={}, forced={}, message=message, help=help)
            return
        if self.standing.known is not None:
            board.watch(WATCH_MS)
        help = "it may have lost its power for a moment: look at its battery and cable"
        self._say(tick=0, threads={}, cells={}, forced={}, message=message, help=help)

    def _take_in(self, news: News) -> None:
        was = self.standing
        alive = {slot: at for slot, at in {**was.threads, **news.threads}.items() if at is not None}
        cells = {**was.cells, **news.cells}
        self._say(tick=news.tick, cells=cells, threads=alive if was.state == RUNNING else {})

    def _tell_fault(self, fault: Fault | None) -> None:
        if fault is None or not fault.number:
            return
        known, at = self.standing.known, fault.instruction
        found = BoardFaultShape(
            number=fault.number,
            sentence=spoken(fault.meaning),
            text=(known.fault_text(fault.text) if known is not None else fault.text)[:LONGEST_TEXT],
            program=known.program if known is not None else "",
            vertex=(known.vertex(at) or "") if known is not None else "",
            line=known.line(at) if known is not None else 0,
            tick=fault.tick,
        )
        self.tape.failed(fault)
        self._say(state="fault", held=False, threads={}, tick=fault.tick, fault=found)

    # -- telling

    def _say(self, **changes: Any) -> None:
        now = replace(self.standing, recorded=self.tape.is_there, **changes)
        if now == self.standing:
            return
        self.standing = replace(now, version=self.standing.version + 1)
        self._changed()

    def message(self) -> BoardMessage:
        """How it stands, as pages are told."""
        now, known = self.standing, self.standing.known
        values, inputs = known.named(now.cells) if known is not None else ({}, {})
        places = ((slot, known.vertex(at)) for slot, at in sorted(now.threads.items())) if known is not None else ()
        return BoardMessage(
            address=self.address,
            name=self.name,
            holder=self.holder,
            phase=now.phase,
            state=now.state,
            held=now.held,
            free=now.free,
            tick=now.tick,
            seconds=now.tick * known.tick_ms / 1000 if known is not None else 0.0,
            generation=now.generation,
            package=now.package,
            installed=now.installed,
            program=known.program if known is not None else "",
            robot=known.robot if known is not None else "",
            active=[(slot, vertex) for slot, vertex in places if vertex is not None],
            values=values,
            # A robot tells nothing of a sensor that its program does not use.
            inputs={**inputs, **now.forced},
            forced=sorted(now.forced),
            progress=now.progress,
            fault=now.fault,
            message=spoken(now.message),
            help=spoken(now.help),
            way=now.way,
            recorded=now.recorded,
        )


def _way_out(error: KitRobotError) -> str:
    """The help of an error, for somebody who has a panel with buttons and not a terminal."""
    if "`kitrobot " not in error.help and " --" not in error.help:
        return error.help
    if isinstance(error, ForeignError):
        return "save it first if you need it, then press Replace it"
    if isinstance(error, FullError):
        return "press Make room: what KitRobot put there goes first, and until the new program is whole there is none"
    if isinstance(error, SilentError):
        return "press its reset button; when it holds no KitRobot yet, press Send"
    return "look at its cable, then try again" if isinstance(error, LineError) else "send the program again"


def _no_answer(name: str) -> KitRobotError:
    return KitRobotError(f"`{name}` does not answer", "look at its cable, then try again")
