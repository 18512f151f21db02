"""Operations on several real robots at once: a scan, sending programs, an action on each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Event, Thread
from time import monotonic
from typing import TypeVar

from kitrobot.deploy.errors import DeployError
from kitrobot.deploy.firmware.ports import Port, list_ports
from kitrobot.deploy.installation.deployment import DeployResult, deploy
from kitrobot.deploy.installation.installation import RobotContext
from kitrobot.deploy.line.board import Board, Hello
from kitrobot.deploy.line.handshake import connect
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import COMMA, Sentence, Series

_MOST_AT_ONCE = 32
_FAREWELL_S = 2.0
"""How long boards are waited for, when they are to be left as they were, after Ctrl-C."""
_LOOK_S = 0.1
"""How often Ctrl-C is looked for where nothing interrupts a wait (Windows)."""

Item = TypeVar("Item")
Result = TypeVar("Result")

Progress = Callable[[str, str, int, int], None]
"""Called with an address: what is done now, and how many bytes of how many."""


WaitListener = Callable[[str], None]
"""Called with an address where nobody has answered yet."""


def _ignored(address: str) -> None:
    """Does nothing."""


class NoBoardError(KitRobotError):
    """No robot is there, or several where one must be chosen."""


@dataclass(frozen=True)
class SendResult:
    """The result of sending to one robot: `deployed`, or the `error` that prevented it."""

    address: str
    deployed: DeployResult | None
    error: KitRobotError | None


@dataclass(frozen=True)
class BoardContents:
    """A port and the board that answers there; without an answer, `hello` is None and `error` the reason.

    `micropython`: the version on the board, as far as it is known.
    """

    port: Port
    hello: Hello | None
    program: str
    error: KitRobotError | None
    micropython: str = ""


def choose_boards(addresses: Sequence[str]) -> list[str]:
    """The addresses that were given, each once; without one, that of the only robot that may be there.

    Raises:
        NoBoardError: none is there, or several.
    """
    if addresses:
        return list(dict.fromkeys(addresses))
    ports = list_ports()
    if len(ports) == 1:
        return [ports[0].address]
    if not ports:
        raise NoBoardError(
            Sentence("no robot is plugged in"),
            Sentence("plug one in with a USB cable that carries data, or name its address with --to"),
        )
    names = Series(COMMA, (f"`{port.address}` ({port.name})" for port in ports))
    raise NoBoardError(
        Sentence.counted(
            "{count} robot may be meant: {names}", "{count} robots may be meant: {names}", len(ports), names
        ),
        Sentence("choose with --to"),
    )


def send_program(
    program: BoardProgram,
    addresses: Sequence[str],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
) -> list[SendResult]:
    """Sends a program to several robots at once; what goes wrong with one does not hold up the others."""
    return send_programs(dict.fromkeys(addresses, program), progress, replace=replace, fresh=fresh)


def send_programs(
    programs: Mapping[str, BoardProgram],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
) -> list[SendResult]:
    """The same with a program for each address.

    Raises:
        KeyboardInterrupt: Ctrl-C; the boards that were not done are left with what they had.
    """

    def send(address: str, over: Event) -> SendResult:
        program = programs[address]

        def report(stage: str, done: int, total: int) -> None:
            progress(address, stage, done, total)

        try:
            return SendResult(
                address,
                deploy(
                    address,
                    program.file.to_bytes(),
                    program.package,
                    report,
                    replace=replace,
                    fresh=fresh,
                    robot=RobotContext(program.needs, program.names.fault_text),
                    over=over,
                ),
                None,
            )
        except KitRobotError as error:
            return SendResult(address, None, error)

    try:
        return _in_parallel(send, list(programs))
    except KeyboardInterrupt:
        raise KeyboardInterrupt(Sentence("broken off: a board that was not done keeps what it had")) from None


def scan_boards(
    addresses: Sequence[str], waits: WaitListener, name_of: Callable[[str], str] = lambda installed: ""
) -> list[BoardContents]:
    """Lists the robots at the addresses, or at every port where one may be; all are queried at once.

    `waits` is called with an address that has not answered yet; `name_of` maps a robot's name of a program to its name.
    """
    ports = [Port(address, "", "") for address in addresses] if addresses else list_ports()

    def look(port: Port, over: Event) -> BoardContents:
        try:
            with connect(port.address, waits=lambda: waits(port.address), over=over) as board:
                return BoardContents(port, board.hello, name_of(board.hello.program), None)
        except DeployError as error:
            return BoardContents(port, None, "", error)

    return _in_parallel(look, ports)


def run_on_boards(
    addresses: Sequence[str], act: Callable[[Board], object], waits: WaitListener = _ignored
) -> list[tuple[str, KitRobotError | None]]:
    """Does something with each robot, all at once; what went wrong with which. `waits` as for `scan_boards`."""

    def one(address: str, over: Event) -> tuple[str, KitRobotError | None]:
        try:
            with connect(address, waits=lambda: waits(address), over=over) as board:
                act(board)
        except DeployError as error:
            return address, error
        return address, None

    return _in_parallel(one, addresses)


def _in_parallel(make: Callable[[Item, Event], Result], given: Sequence[Item]) -> list[Result]:
    """What is made of each, in threads; the event that is handed on is set when nobody waits for it any more."""
    made: dict[int, Result] = {}
    failed: list[BaseException] = []
    over = Event()
    left: SimpleQueue[int] = SimpleQueue()
    for number in range(len(given)):
        left.put(number)
    ended: SimpleQueue[None] = SimpleQueue()

    def work() -> None:
        try:
            while not over.is_set():
                number = left.get_nowait()
                made[number] = make(given[number], over)
        except Empty:
            pass
        except BaseException as error:
            failed.append(error)
        finally:
            ended.put(None)

    count = min(len(given), _MOST_AT_ONCE)
    for _ in range(count):
        # A daemon: one that opens an address far away hears of Ctrl-C late, and the command does not wait for it.
        Thread(target=work, daemon=True).start()
    try:
        # Not by joining: a join that Ctrl-C interrupts takes the thread for ended.
        while count:
            count -= _has_ended(ended, _LOOK_S)
    except BaseException:
        over.set()
        until = monotonic() + _FAREWELL_S
        while count and (wait := until - monotonic()) > 0:
            count -= _has_ended(ended, wait)
        raise
    if failed:
        raise failed[0]
    return [made[number] for number in range(len(given))]


def _has_ended(queue: SimpleQueue[None], timeout_s: float) -> bool:
    try:
        queue.get(timeout=timeout_s)
    except Empty:
        return False
    return True
