"""Several real robots at once: which are there, sending a program to them, doing something with each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TypeVar

from kitrobot.deploy import Board, Deployed, DeployError, Hello, Port, connect, deploy, list_ports
from kitrobot.diagnostics import KitRobotError
from kitrobot.robots.program import BoardProgram
from kitrobot.text import COMMA, Sentence, Series

_MOST_AT_ONCE = 32

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
    """The same with a program for each address."""

    def send(address: str) -> Sent:
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
                ),
                None,
            )
        except KitRobotError as error:
            return Sent(address, None, error)

    return _at_once(send, list(programs))


def look_at_boards(
    addresses: Sequence[str], waits: Waits, name_of: Callable[[str], str] = lambda installed: ""
) -> list[Seen]:
    """Which robots are there: those of the addresses, or of every port where one may be; all are asked at once.

    `waits` is told of an address whose answer is waited for; `name_of` gives a program's name by what a robot calls it.
    """
    ports = [Port(address, "", "") for address in addresses] if addresses else list_ports()

    def look(port: Port) -> Seen:
        try:
            with connect(port.address, waits=lambda: waits(port.address)) as board:
                return Seen(port, board.hello, name_of(board.hello.program), None)
        except DeployError as error:
            return Seen(port, None, "", error)

    return _at_once(look, ports)


def at_boards(
    addresses: Sequence[str], act: Callable[[Board], object], waits: Waits = _ignored
) -> list[tuple[str, KitRobotError | None]]:
    """Does something with each robot, all at once; what went wrong with which. `waits` as for `look_at_boards`."""

    def one(address: str) -> tuple[str, KitRobotError | None]:
        try:
            with connect(address, waits=lambda: waits(address)) as board:
                act(board)
        except DeployError as error:
            return address, error
        return address, None

    return _at_once(one, addresses)


def _at_once(make: Callable[[Given], Made], given: Sequence[Given]) -> list[Made]:
    if not given:
        return []
    with ThreadPoolExecutor(min(len(given), _MOST_AT_ONCE)) as threads:
        return list(threads.map(make, given))
