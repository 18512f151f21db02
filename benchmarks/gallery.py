"""The largest program of the gallery that a kit can run, on its board in an emulator: ticks, jitter, memory left.

    python -m benchmarks.gallery

Its drivers are those of the kit, with pins that only remember. A sensor of time is added (`peers/clock.driver.py`),
which tells when ticks begin, on the board's own clock. A kit of a board with the module `machine` runs on a current
MicroPython as WebAssembly, with a heap of so many kilobytes; one of the micro:bit on the firmware of 2016 in QEMU.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from benchmarks.boards import ROBOT, Measured, read_log, shown
from kitrobot.compiler import compile_text, robot_of
from kitrobot.deploy import BoardError, Package, connect, deploy, fitted
from kitrobot.diagnostics import KitRobotError
from kitrobot.primitives import Kit, Robot, config_folder, read_robot
from kitrobot.robots import BoardProgram
from kitrobot.workspace import board_program, open_mission
from kitrobot.workspace.kit_files import kit_named
from kitrobot.workspace.robot_programs import ready_program

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
HEAP_KB = 128
"""Less than what a Raspberry Pi Pico has free under MicroPython, and about what an ESP32 has."""


@dataclass(frozen=True)
class Candidate:
    """A program of the gallery that can be sent to a kit."""

    name: str
    text: str
    robot: Robot
    image_bytes: int


def candidates(kit: Kit) -> list[Candidate]:
    """The programs of the gallery that can be sent to a kit, the largest first."""
    found = []
    for path in sorted(EXAMPLES.glob("*/*.krt")):
        opened = open_mission(path)
        for program in opened.mission.programs:
            try:
                ready = board_program(opened, program.name, path.parent, kit)
            except KitRobotError:
                continue
            compiled = opened.compiled[program.name]
            robot = robot_of(program, opened.catalogue)
            found.append(Candidate(f"{path.stem}/{program.name}", compiled.source.text, robot, len(ready.file.image)))
    return sorted(found, key=lambda one: -one.image_bytes)


def with_clock(one: Candidate, kit: Kit, folder: Path, ticks: int) -> BoardProgram:
    """That program on that kit, with a sensor that writes down when ticks begin."""
    driver = Path(__file__).parent / "peers" / "clock.driver.py"
    (folder / "clock.driver.py").write_bytes(driver.read_bytes())
    measured, _ = read_robot(ROBOT.format(tick_ms=one.robot.tick_ms, keep=ticks).encode(), "measured.robot.xml")
    assert measured is not None
    (clock,) = measured.sensors
    wired = fitted(one.robot, kit, Package((config_folder(),)))
    robot = replace(wired, sensors=(*wired.sensors, clock))
    text = f"//(\n{one.text},\n*[Clock.LessThan(32767)]( WAIT(1); )\n);"
    return ready_program(one.name, robot, compile_text(text, robot), (), (), folder)


def measure(address: str, made: BoardProgram, ticks: int, asked_s: float, limit_s: float = 300) -> Measured:
    """Runs a program for so many ticks."""
    deployed = deploy(address, made.file.to_bytes(), made.package)
    until = time.monotonic() + limit_s
    with connect(address, 20) as board:
        while board.greet().tick < deployed.hello.tick + ticks + 10:
            if time.monotonic() > until:
                raise TimeoutError("the board does not get on with its ticks")
            fault = board.last_fault() if board.hello.state_name == "fault" else None
            if fault is not None:
                raise RuntimeError(fault.text)
            time.sleep(asked_s)
        board.quit()
    return Measured(read_log(address), deployed)


def measured_on(kit: Kit, ticks: int) -> tuple[Candidate, Measured]:
    """The largest program that the board of a kit takes, and how it runs there."""
    asked_s = 0.5 if kit.family == "machine" else 5
    for one in candidates(kit):
        with tempfile.TemporaryDirectory() as folder, _board(kit) as board:
            try:
                made = with_clock(one, kit, Path(folder), ticks)
                return one, measure(board.address, made, ticks, asked_s)
            except BoardError:
                continue  # too large for this board
    raise RuntimeError(f"no program of the gallery runs on {kit.name}")


def _board(kit: Kit) -> AbstractContextManager[Any]:
    from tests.boards.modern import ModernBoard, onboard_files
    from tests.boards.qemu import running

    if kit.family != "machine":
        return running("-icount", "shift=6")
    return ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}, heap_kb=HEAP_KB)


def main() -> None:
    """Prints the table of docs/benchmarks.md."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.gallery", description="The gallery on boards.")
    parser.add_argument("--board", action="append", metavar="NAME", help="a kit (pico, esp32, microbit)")
    parser.add_argument("--ticks", type=int, default=300)
    given = parser.parse_args()
    print("kit · program, bytes of its image · ms off the tick: median · 95 % · worst · bytes of memory left")
    for name in given.board or ["pico", "esp32", "microbit"]:
        one, found = measured_on(kit_named(name), given.ticks)
        off = shown(found, one.robot.tick_ms)
        print(f"{name} · {one.name}, {one.image_bytes} · {off} · {found.deployed.free}")


if __name__ == "__main__":
    main()
