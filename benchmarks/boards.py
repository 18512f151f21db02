"""Boards under measurement: a program is deployed as users do it, and the board's own clock says when its ticks begin.

    python -m benchmarks.boards

The robot has a sensor that measures time (`peers/clock.driver.py`), an actuator that forgets what it is told, and the
counting loop of `subjects.interpreting`. The micro:bit is the real firmware in QEMU, where a processor's instruction
takes as long each time (`-icount shift=6`); the other a current MicroPython as WebAssembly, on this machine's clock.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from contextlib import AbstractContextManager
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.installation.deployment import DeployResult, deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.session import LOOK_S

FORGETS = """
class Forgets:
    def do(self, procedure, arguments):
        pass
    def stop(self):
        pass
def make(settings):
    return Forgets()
"""
ROBOT = """<robot name="measured" version="1" tick="{tick_ms}" wait-unit="{tick_ms}">
  <help>Counts.</help>
  <actuator name="Arm" device="switch"><board driver="forgets"/><help>Forgets.</help>
    <procedure name="Act"><help>Is told.</help>
      <parameter name="x" min="0" max="3000"><help>It.</help></parameter></procedure>
  </actuator>
  <sensor name="Clock" device="pin-in" min="0" max="32767"><board driver="clock" keep="{keep}"/><help>Ticks.</help>
    <operation name="LessThan" test="less"><help>So far.</help>
      <parameter name="value" min="0" max="32767"><help>It.</help></parameter></operation>
  </sensor>
  <variable name="Count" type="integer" min="0" max="1000" initial="0"><help>Counts.</help></variable>
  <variable name="Total" type="integer" min="0" max="3000" initial="0"><help>Counts.</help></variable>
</robot>
"""
_WRAP = 1 << 30
"""The board's clock of microseconds begins anew then."""

_STARTING = 5
"""Ticks that do not count: the board is still busy with its start."""

LOOP = """*[Clock.LessThan(32767)](
  Count.Set(0); Total.Set(0);
  *[!(Count.EqualTo(1000))]( Count.Add(1); Total.Add(3); Arm.Act(Total.Value()); );
);
"""


@dataclass(frozen=True)
class TickMeasurement:
    """How long after one another ticks began, in µs, in their order; what the deployment told."""

    intervals_us: list[int]
    deployed: DeployResult


def program(folder: Path, tick_ms: int, keep: int, text: str = LOOP) -> BoardProgram:
    """The program, with a tick of so many milliseconds, and a clock that keeps so many of them."""
    (folder / "measured.robot.xml").write_text(ROBOT.format(tick_ms=tick_ms, keep=keep), encoding="utf-8")
    (folder / "forgets.driver.py").write_text(FORGETS, encoding="utf-8")
    driver = Path(__file__).parent / "peers" / "clock.driver.py"
    (folder / "clock.driver.py").write_bytes(driver.read_bytes())
    path = folder / "loop.lll"
    path.write_text(text, encoding="utf-8")
    return load_board_program(path, robot=str(folder / "measured.robot.xml"))


def measure(
    address: str, *, tick_ms: int, ticks: int, watched_ms: int = 0, asked_s: float = 0.5, limit_s: float = 300
) -> TickMeasurement:
    """Runs the loop for so many ticks.

    Args:
        address: of the board.
        tick_ms: how long a tick is.
        ticks: how many.
        watched_ms: somebody watches, with news that often.
        asked_s: how often it is asked how far it is: a small board compiles its answer, and is late then.
        limit_s: how long it may take.

    Raises:
        TimeoutError: it takes longer than `limit_s`.
    """
    with tempfile.TemporaryDirectory() as folder:
        made = program(Path(folder), tick_ms, ticks)
        deployed = deploy(address, made.file.to_bytes(), made.package)
    until = time.monotonic() + limit_s
    last = deployed.hello.tick + ticks + 10
    with connect(address, 20) as board:
        if watched_ms:
            board.watch(watched_ms)
            looked = time.monotonic()
            while getattr(board.news(1), "tick", 0) < last:
                _hurry(until)
                if time.monotonic() - looked >= LOOK_S:  # as all do who watch
                    looked = time.monotonic()
                    board.look()
        else:
            while board.greet().tick < last:
                _hurry(until)
                time.sleep(asked_s)  # nobody speaks to it meanwhile
        board.quit()
    return TickMeasurement(read_log(address), deployed)


def _hurry(until: float) -> None:
    if time.monotonic() > until:
        raise TimeoutError("the board does not get on with its ticks")


def read_log(address: str) -> list[int]:
    """What the clock wrote down: the µs between the beginnings of ticks."""
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        times = [int(word) for word in receiver.read("times").split()]
        return [(later - earlier) % _WRAP for earlier, later in pairwise(times[_STARTING:])]
    finally:
        line.close()


def memory_taken(address: str, tick_ms: int = 20) -> int:
    """Bytes of a current MicroPython's heap that the package and the program take while they run."""
    before = allocated(address)
    with tempfile.TemporaryDirectory() as folder:
        made = program(Path(folder), tick_ms, 1)
        deploy(address, made.file.to_bytes(), made.package)
    with connect(address, 20) as board:
        board.quit()
    return allocated(address) - before


def allocated(address: str) -> int:
    """Bytes of memory that are taken on a current MicroPython at the prompt."""
    line = Line(address)
    try:
        line.write(b"\r\x03\x03\r\x01")
        line.read_until(b"exit\r\n>", 20)
        repl = RawRepl(line)
        repl.run("import gc;gc.collect()", 20)
        return int(repl.run("print(gc.mem_alloc())", 20))
    finally:
        line.close()


def shown(measured: TickMeasurement, tick_ms: int) -> str:
    """How far ticks were from where they should be: the middle, nineteen of twenty, the worst; in ms."""
    off = sorted(abs(interval - 1000 * tick_ms) / 1000 for interval in measured.intervals_us)
    return f"{off[len(off) // 2]:.1f} · {off[len(off) * 19 // 20]:.1f} · {off[-1]:.1f}"


def rate(measured: TickMeasurement) -> float:
    """Ticks a second."""
    return 1e6 * len(measured.intervals_us) / sum(measured.intervals_us)


def main() -> None:
    """Measures the boards that can run here and prints what docs/reference/boards.md holds."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.boards", description="Measure boards.")
    parser.add_argument("--board", choices=("modern", "microbit"), default="modern", help="the micro:bit: in QEMU")
    parser.add_argument("--ticks", type=int, help="how many (modern 500, micro:bit 300, as far as its flash goes)")
    given = parser.parse_args()
    ticks = given.ticks or (500 if given.board == "modern" else 300)

    def once(tick_ms: int, watched_ms: int) -> TickMeasurement:
        with _board(given.board) as board:
            asked_s = 0.5 if given.board == "modern" else 5
            return measure(board.address, tick_ms=tick_ms, ticks=ticks, watched_ms=watched_ms, asked_s=asked_s)

    print(f"board: {given.board}; {ticks} ticks; ms off the tick: median · 95 % · worst")
    print(f"a tick of 20 ms, nobody watches: {shown(once(20, 0), 20)}")
    print(f"a tick of 20 ms, watched every 50 ms: {shown(once(20, 50), 20)}")
    fastest = once(1, 0)
    print(f"the whole loop as fast as it goes: {rate(fastest):.0f} ticks/s; {fastest.deployed.free} bytes free")
    if given.board == "modern":
        with _board(given.board) as board:
            print(f"memory of package and program: {memory_taken(board.address)} bytes")


def _board(kind: str) -> AbstractContextManager[Any]:
    from tests.boards.modern import ModernBoard
    from tests.boards.qemu import running

    return ModernBoard() if kind == "modern" else running("-icount", "shift=6")


if __name__ == "__main__":
    main()
