"""`BoardLine`: the line to the board of an agent, in a thread of its own, so that a slow board holds up nobody."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Thread

from kitrobot.deploy.errors import LineError, SilentError
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.fleet.board_body import Order
from kitrobot.fleet.charter import FleetError
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import Sentence

LEAST_SILENT_S = 1.5
"""A board answers within less, also a small one, and what got lost on the line was repeated meanwhile."""
END_S = 5.0


@dataclass(frozen=True, slots=True)
class OrderResult:
    """The result of an order: the numbers that a tick changed, or why it could not be done."""

    order: Order
    changes: tuple[tuple[int, int], ...] = ()
    error: KitRobotError | None = None


class OrderExecutor:
    """Executes orders on a board; sends only the inputs that have changed."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._held: dict[int, int] = {}

    def do(self, order: Order) -> tuple[tuple[int, int], ...]:
        """Executes an order; returns the numbers that a tick has changed.

        Raises:
            DeployError: the board does not answer, or cannot do it.
        """
        board = self._board
        if order.what == "stop":
            board.stop()
        elif order.what == "still":
            board.stand_still()
        else:
            if order.anew:
                board.begin_member()
            for cell, value in order.variables.items():
                board.set(cell, value)
            new = {cell: value for cell, value in order.inputs.items() if self._held.get(cell) != value}
            self._held |= new
            return tuple(board.member_tick(new))
        return ()


class BoardLine:
    """A board that has the program of its agent.

    Args:
        board: a line to it, on which it was greeted.

    Attributes:
        wake: called in another thread when something came of an order.
    """

    def __init__(self, board: Board) -> None:
        self.wake: Callable[[], None] = lambda: None
        self._board = board
        board.silent_s = LEAST_SILENT_S
        self._executor = OrderExecutor(board)
        self._orders: SimpleQueue[Order | None] = SimpleQueue()
        self._results: SimpleQueue[OrderResult] = SimpleQueue()
        self._thread = Thread(target=self._work, name="board", daemon=True)
        self._thread.start()

    def set_lease(self, lease_ms: int) -> None:
        """The line is given up when nothing comes for a lease, or for `LEAST_SILENT_S` where that is longer.

        For the team its agent is silent after a lease, whichever is longer; it is back with the next word of the board.
        """
        self._board.silent_s = max(LEAST_SILENT_S, lease_ms / 1000)

    def order(self, order: Order) -> None:
        """Queues an order; a stop goes ahead of every order that was not begun."""
        if order.what == "stop":
            with suppress(Empty):
                while True:
                    self._orders.get_nowait()
        self._orders.put(order)

    def take_results(self) -> list[OrderResult]:
        """Returns the results of orders since the last call."""
        found = []
        while not self._results.empty():
            found.append(self._results.get())
        return found

    def close(self) -> None:
        """Stops the board, as far as it can be reached, and lets go of the line."""
        self.order(Order("stop"))
        self._orders.put(None)
        self._thread.join(END_S)
        self._board.close()

    def _work(self) -> None:
        while (order := self._orders.get()) is not None:
            try:
                self._results.put(OrderResult(order, self._executor.do(order)))
            except KitRobotError as error:
                self._results.put(OrderResult(order, (), self._cause(error)))
                self.wake()
                return
            self.wake()

    def _cause(self, error: KitRobotError) -> KitRobotError:
        """Why an order could not be executed: the fault that the board reports, if it reports one."""
        if isinstance(error, LineError | SilentError):
            return error  # nobody is there to be asked
        try:
            fault = self._board.last_fault()
        except KitRobotError:
            return error
        if fault is None:
            return error
        return FleetError(
            Sentence("the board stopped by itself: {fault}", fault.meaning),
            Sentence("`kitrobot log` tells more of it; then start the agent again"),
        )


def open_board(port: str, program: BoardProgram, name: str, mission: str) -> BoardLine:
    """The board of an agent, which must have its program, of this KitRobot.

    Raises:
        FleetError: it has another one.
        DeployError: there is none, or it does not answer.
    """
    board = connect(port)
    try:
        if not program.is_called(board.hello.program):
            raise FleetError(
                Sentence("the board on `{port}` does not have the program of `{agent}` as it is now", port, name),
                Sentence("send it: {command}", f"`kitrobot deploy {mission} --team --board {name}={port}`"),
            )
        board.stop()
        return BoardLine(board)
    except BaseException:
        board.close()
        raise
