"""Several real robots at once: which are there, sending a program to them, doing something with each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Event, Thread
from time import monotonic
from typing import TypeVar

from kitrobot.deploy import Board, Deployed, DeployError, Hello, Port, connect, deploy, list_ports
from kitrobot.diagnostics import KitRobotError
from kitrobot.robots.program import BoardProgram
from kitrobot.text import COMMA, Sentence, Series

_MOST_AT_ONCE = 32
_FAREWELL_S = 2.0
"""How long boards are waited for, when they are to be left as they were, after Ctrl-C."""
_LOOK_S = 0.1
"""How often Ctrl-C is looked for where nothing interrupts a wait (Windows)."""

Given = TypeVar("Given")
Made = TypeVar("Made")

Progress = Callable[[str, str, int, int], None]
"""Is told of an address: what is done now, and how many bytes of how many."""


Waits = Callable[[str], None]
"""Is told of an address where nobody has answered yet."""


def _ignored(address: str) -> None:
    """Nobody wants to know."""


class NoBoardError(KitRobotError):
    """No robot is there, or several where one must be chosen."""


@dataclass(frozen=True)
class Sent:
    """What became of one robot: `deployed`, or the `error` that kept it from it."""

    address: str
    deployed: Deployed | None
    error: KitRobotError | None


@dataclass(frozen=True)
class Seen:
    """A port, and who answers there: `hello` None when nobody does, and `error` says why. `micropython`: the version on
    the board, as far as it is known.
    """

    port: Port
    hello: Hello | None
    program: str
    error: KitRobotError | None
    micropython: str = ""


def chosen_boards(addresses: Sequence[str]) -> list[str]:
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
) -> list[Sent]:
    """Sends a program to several robots at once; what goes wrong with one does not hold up the others."""
    return send_programs(dict.fromkeys(addresses, program), progress, replace=replace, fresh=fresh)


def send_programs(
    programs: Mapping[str, BoardProgram],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
) -> list[Sent]:
    """The same with a program for each address.

    Raises:
        KeyboardInterrupt: Ctrl-C; the boards that were not done are left with what they had.
    """

    def send(address: str, over: Event) -> Sent:
        program = programs[address]

        def told(stage: str, done: int, total: int) -> None:
            progress(address, stage, done, total)

        try:
            return Sent(
                address,
                deploy(
                    address,
                    program.file.to_bytes(),
                    program.package,
                    told,
                    replace=replace,
                    fresh=fresh,
                    needs=program.needs,
                    named=program.names.fault_text,
                    over=over,
                ),
                None,
            )
        except KitRobotError as error:
            return Sent(address, None, error)

    try:
        return _at_once(send, list(programs))
    except KeyboardInterrupt:
        raise KeyboardInterrupt(Sentence("broken off: a board that was not done keeps what it had")) from None


def look_at_boards(
    addresses: Sequence[str], waits: Waits, name_of: Callable[[str], str] = lambda installed: ""
) -> list[Seen]:
    """Which robots are there: those of the addresses, or of every port where one may be; all are asked at once.

    `waits` is told of an address whose answer is waited for; `name_of` gives a program's name by what a robot calls it.
    """
    ports = [Port(address, "", "") for address in addresses] if addresses else list_ports()

    def look(port: Port, over: Event) -> Seen:
        try:
            with connect(port.address, waits=lambda: waits(port.address), over=over) as board:
                return Seen(port, board.hello, name_of(board.hello.program), None)
        except DeployError as error:
            return Seen(port, None, "", error)

    return _at_once(look, ports)


def at_boards(
    addresses: Sequence[str], act: Callable[[Board], object], waits: Waits = _ignored
) -> list[tuple[str, KitRobotError | None]]:
    """Does something with each robot, all at once; what went wrong with which. `waits` as for `look_at_boards`."""

    def one(address: str, over: Event) -> tuple[str, KitRobotError | None]:
        try:
            with connect(address, waits=lambda: waits(address), over=over) as board:
                act(board)
        except DeployError as error:
            return address, error
        return address, None

    return _at_once(one, addresses)


def _at_once(make: Callable[[Given, Event], Made], given: Sequence[Given]) -> list[Made]:
    """What is made of each, in threads; the event that is handed on is set when nobody waits for it any more."""
    made: dict[int, Made] = {}
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
            count -= _has_come(ended, _LOOK_S)
    except BaseException:
        over.set()
        until = monotonic() + _FAREWELL_S
        while count and (wait := until - monotonic()) > 0:
            count -= _has_come(ended, wait)
        raise
    if failed:
        raise failed[0]
    return [made[number] for number in range(len(given))]


def _has_come(queue: SimpleQueue[None], timeout_s: float) -> bool:
    try:
        queue.get(timeout=timeout_s)
    except Empty:
        return False
    return True
