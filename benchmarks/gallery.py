"""The largest program of the gallery that runs on a kit, on its board in an emulator (`subjects.gallery`).

Its drivers are those of the kit, with pins wired to nothing. A sensor of time is added (`peers/clock.driver.py`), which
tells when ticks begin, on the board's own clock. The boards are those with the module `machine`, as a current
MicroPython as WebAssembly: as fast as this machine, and its memory grows as it needs more, so what is told of it is
what is taken. Kits of a micro:bit are measured by `benchmarks.microbit_ticks`.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from benchmarks.boards import ROBOT, allocated, read_log
from kitrobot.boards.programs import board_program, ready_program
from kitrobot.compiler.compilation import compile_text
from kitrobot.compiler.target import robot_of
from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.kits.kits import fit_to_kit
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.package.package import Package
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.robots.program import BoardProgram
from kitrobot.user_folders import config_folder
from kitrobot.workspace.example_list import shipped_examples
from kitrobot.workspace.mission_loader import open_mission

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
KITS = ("pico", "cardboard", "esp32", "xrp", "xrp-beta", "pololu-3pi", "alvik")
ANSWERS = b"""
PINS = 48
registers[0x29] = {}
registers[107] = {0x0F: b"\\x6c"}
class Forgets(list):
    def append(self, entry):
        pass
log = Forgets()
levels[13] = 1
class Stm32:
    turned = False
def stm32(data):
    if data:
        Stm32.turned = data[2] == 82
        return b""
    return TURNED if Stm32.turned else NOTHING
partners[1] = stm32
"""
"""More of the module `machine` of the tests: all pins, that a colour sensor and a gyroscope are on the bus, and an
Alvik that is switched on, sees nothing, and has turned as soon as it is told. What it is told it forgets, for that
would be counted as memory of the program.
"""


_ASKED_S = 0.2


class FaultError(Exception):
    """A part failed while the program ran."""


@dataclass(frozen=True)
class Candidate:
    """A program of the gallery that can be sent to a kit."""

    name: str
    text: str
    robot: Robot
    image_bytes: int


@dataclass(frozen=True)
class Figures:
    """What was measured of a kit; `left_out` are larger programs that do not run on its board here, and why.

    `intervals_us`: between the beginnings of two ticks; `busy_us`: the same where a tick is asked for each millisecond,
    so that the next one begins when it is done. `memory`: bytes that are taken.
    """

    program: Candidate
    intervals_us: list[int]
    busy_us: list[int]
    memory: int
    left_out: tuple[str, ...]


def candidates(kit: Kit) -> list[Candidate]:
    """The programs of the gallery that can be sent to a kit, the largest first."""
    found = []
    for mission in shipped_examples().examples:
        path = EXAMPLES / mission
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


def with_clock(one: Candidate, kit: Kit, folder: Path, ticks: int, tick_ms: int) -> BoardProgram:
    """That program on that kit, with a sensor that writes down when ticks begin."""
    driver = Path(__file__).parent / "peers" / "clock.driver.py"
    (folder / "clock.driver.py").write_bytes(driver.read_bytes())
    measured, _ = read_robot(ROBOT.format(tick_ms=tick_ms, keep=ticks).encode(), "measured.robot.xml")
    assert measured is not None
    (clock,) = measured.sensors
    wired = fit_to_kit(one.robot, kit, Package((config_folder(),)))
    robot = replace(wired, sensors=(*wired.sensors, clock), tick_ms=tick_ms)
    text = f"//(\n{one.text},\n*[Clock.LessThan(32767)]( WAIT(1); )\n);"
    return ready_program(one.name, robot, compile_text(text, robot), (), (), folder)


def ran(address: str, made: BoardProgram, ticks: int, limit_s: float = 300) -> None:
    """Runs a program for so many ticks; its clock wrote down when they began.

    Raises:
        FaultError: a part failed meanwhile.
        TimeoutError: it takes longer than `limit_s`.
    """
    deployed = deploy(address, made.file.to_bytes(), made.package, fresh=True)
    until = time.monotonic() + limit_s
    with connect(address, 20) as board:
        while board.greet().tick < deployed.hello.tick + ticks + 10:
            if time.monotonic() > until:
                raise TimeoutError("the board does not get on with its ticks")
            fault = board.last_fault() if board.hello.state_name == "fault" else None
            if fault is not None:
                raise FaultError(made.names.fault_text(fault.text))
            time.sleep(_ASKED_S)
        board.quit()


def figures_of(kit: Kit, ticks: int) -> Figures:
    """The largest program that runs on the board of a kit, and how.

    Raises:
        RuntimeError: none does.
    """
    left_out: list[str] = []
    for one in candidates(kit):
        try:
            return _figures(one, kit, ticks, left_out)
        except (BoardError, FaultError) as error:
            left_out.append(f"{one.name}: {error}")
    raise RuntimeError(f"no program of the gallery runs on {kit.name}: {'; '.join(left_out)}")


def _figures(one: Candidate, kit: Kit, ticks: int, left_out: Sequence[str]) -> Figures:
    with tempfile.TemporaryDirectory() as folder, _board() as board:
        before = allocated(board.address)
        made = with_clock(one, kit, Path(folder), ticks, one.robot.tick_ms)
        ran(board.address, made, ticks)
        memory = allocated(board.address) - before
        intervals = read_log(board.address)
        made = with_clock(one, kit, Path(folder), ticks, 1)
        ran(board.address, made, ticks)
        return Figures(one, intervals, read_log(board.address), memory, tuple(left_out))


def _board() -> AbstractContextManager[Any]:
    from tests.boards.alvik import NOTHING, TURNED
    from tests.boards.modern import ModernBoard, onboard_files

    alvik = f"\nNOTHING, TURNED = {NOTHING!r}, {TURNED!r}\n".encode()
    return ModernBoard({"lib/machine.py": onboard_files()["machine.py"] + alvik + ANSWERS})
