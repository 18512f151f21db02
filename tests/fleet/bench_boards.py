"""Boards on the bench as bodies of agents: the very loop of a robot and the very link, without a clock or a socket."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kitrobot.deploy.line.board import Board
from kitrobot.deploy.package.program_file import make_program_file
from kitrobot.fleet.board_body import Order
from kitrobot.fleet.board_line import OrderExecutor
from kitrobot.sim.simulation import Simulation
from tests.onboard.bench import Bench


class BenchLine:
    """The line to a board on the bench: its answers are there as soon as it was asked."""

    address = "bench"

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.asked = 0

    def write(self, data: bytes) -> None:
        self.asked += 1
        self.bench.wire.orders.put(data)
        self.bench.rests()

    def read(self, timeout_s: float) -> bytes:
        data, self.bench.wire.sent = self.bench.wire.sent, b""
        return data

    def now(self) -> float:
        return self.asked / 1000

    def close(self) -> None:
        """Nothing to close."""


@dataclass
class BenchBoard:
    """A board with the program of an agent. `takes`: how many ms of the network's clock a tick takes."""

    bench: Bench
    board: Board
    actuators: list[int]
    takes: int = 0
    free_at: int = 0
    done: list[tuple[Order, tuple[tuple[int, int], ...]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.executor = OrderExecutor(self.board)


@contextmanager
def bench_boards(run: Simulation, numbers: Mapping[int, int], folder: Path) -> Iterator[dict[int, BenchBoard]]:
    """A board for each of these agents of a run, with the ms that a tick takes."""
    found = {}
    with ExitStack() as stack:
        for i, takes in numbers.items():
            member = run.members[i]
            file = make_program_file(member.machine.image, member.robot, member=True)
            place = folder / f"board-{i}"
            place.mkdir(exist_ok=True)
            bench = stack.enter_context(Bench(place, file.to_bytes()))
            line: Any = BenchLine(bench)
            found[i] = BenchBoard(bench, Board(line), file.used_actuators, takes)
        yield found
