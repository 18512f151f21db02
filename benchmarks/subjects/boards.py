"""A current MicroPython, as WebAssembly under Node: the one `tick` there, against the same loop written by hand.

The loop is that of `interpreting`, `i+=1; x+=3; act(x); until i=1000`; by hand it is a class with a method that is
called once a tick, as a program that shares its board with others must be. CPython and Numba stand beside it. How
regular ticks are on a board, its memory, and the micro:bit: `python -m benchmarks.boards`, docs/reference/boards.md.
"""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.subjects import interpreting
from tests.boards.modern import onboard_files, version
from tests.boards.modern import run as run_micropython

TITLE = "boards"
_SCRIPT = Path(__file__).resolve().parent.parent / "peers" / "by_hand.py"


@dataclass(frozen=True)
class Size:
    """`laps` of 1000 trips a round on MicroPython and on CPython."""

    laps: int
    rounds: int


FULL = Size(30, 7)
TINY = Size(1, 1)


class ByHand:
    """The loop in CPython, as in `peers/by_hand.py`."""

    def __init__(self, act: Callable[[int], None]) -> None:
        self.i = 0
        self.x = 0
        self.act = act

    def step(self) -> bool:
        self.i += 1
        self.x += 3
        self.act(self.x)
        return self.i < interpreting.UNTIL


def by_hand(laps: int) -> None:
    """Laps of it."""
    told: list[int] = []
    for _ in range(laps):
        told.clear()
        program = ByHand(told.append)
        while program.step():
            pass
    assert told[-1] == 3 * interpreting.UNTIL


def micropython(size: Size) -> dict[str, list[float]]:
    """Seconds of each round on MicroPython: of `tick`, and of the loop by `hand`."""
    given = {"image": interpreting.machine().image.to_bytes().hex(), "laps": size.laps, "rounds": size.rounds}
    files = {**onboard_files(), "given.json": json.dumps(given).encode(), "by_hand.py": _SCRIPT.read_bytes()}
    found: dict[str, list[float]] = json.loads(run_micropython(files, "by_hand.py", 600))
    return found


def run(size: Size, *, peers: bool) -> list[Row]:
    a_trip = interpreting.instructions_a_trip(interpreting.machine())
    amount = size.laps * interpreting.UNTIL
    theirs = micropython(size)
    ours = interpreting.machine()
    work: dict[str, Callable[[], object]] = {"plain": lambda: interpreting.plain(ours, size.laps)}
    if importlib.util.find_spec("numba") is not None:
        work["Numba"] = interpreting.compiled(ours, size.laps, 1)
    if peers:
        work["hand"] = lambda: by_hand(size.laps)
    seconds = in_turns(work, size.rounds)
    hand = {
        "MicroPython": Rate.of(amount, theirs["hand"]) if peers else None,
        "CPython": Rate.of(amount, seconds["hand"]) if peers else None,
    }
    rows = []
    for name, taken in (("MicroPython", theirs["tick"]), ("CPython", seconds["plain"])):
        shown = f"{name} {version()}, WebAssembly" if name == "MicroPython" else name
        peer = f"by hand, {name}" if peers else ""
        rows.append(Row(f"{shown}", "ticks/s", Rate.of(amount, taken), peer, hand[name]))
        rows.append(Row(f"{shown}, {a_trip} a tick", "instructions/s", Rate.of(a_trip * amount, taken)))
    if "Numba" in seconds:
        rows.append(Row("Numba", "ticks/s", Rate.of(amount, seconds["Numba"])))
        rows.append(Row(f"Numba, {a_trip} a tick", "instructions/s", Rate.of(a_trip * amount, seconds["Numba"])))
    return rows
