"""What a robot makes of a host that does not read, and of tools that want its prompt."""

from __future__ import annotations

import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.news import read_news
from kitrobot.image.machine import Layout
from kitrobot_onboard.link import unwrap, wrap
from tests.boards.bench import bench_program, bench_robot
from tests.boards.modern import ModernBoard
from tests.patience import PATIENCE_S

STANDS = "WAIT(30000);"


def until(board: Board, holds: Callable[[], bool]) -> None:
    """Listens until something holds."""
    for _ in range(20 * PATIENCE_S):
        if holds():
            return
        board.news(0.05)
    raise AssertionError("that never came about")


def test_a_host_that_does_not_read_holds_nothing_up_and_is_told_later(tmp_path: Path) -> None:
    program = bench_program(tmp_path, STANDS)
    cell = Layout(bench_robot(tmp_path)).variables["Count"]
    with ModernBoard() as robot:
        deploy(robot.address, program.file.to_bytes(), program.package)
        with connect(robot.address, PATIENCE_S) as board:
            board.watch(20)
            until(board, lambda: board.look().tick > 0)
            robot.deaf(True)
            until(board, lambda: robot.said()[0] > 0)
            # It goes on, does what it hears, and keeps the answer.
            board.line.write(wrap("v", 254, struct.pack("<Bi", cell, 77)) + wrap("n", 255, b""))
            refused = robot.said()[0]
            until(board, lambda: robot.said()[0] > refused + 20)
            robot.deaf(False)
            heard = b""
            while not (told(heard, cell) == 77 and {("K", 254), ("C", 255)} <= answers(heard)):
                piece = board.line.read(PATIENCE_S)
                assert piece, heard
                heard += piece
            assert robot.said()[1] == 0, "how often it was held up"


def answers(heard: bytes) -> set[tuple[str, int]]:
    """Types and numbers of the whole frames."""
    return {found[:2] for part in heard.split(b"~") if (found := unwrap(part)) is not None}


def told(heard: bytes, cell: int) -> int | None:
    """The value of a cell that news told last."""
    value = None
    for part in heard.split(b"~"):
        found = unwrap(part)
        if found is not None and found[0] == "T":
            value = read_news(found[2]).cells.get(cell, value)
    return value


def mpremote(address: str, *words: str) -> str:
    """What the real mpremote says."""
    command = [sys.executable, "-m", "mpremote", "connect", address, *words]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_mpremote_enters_a_robot_that_runs(tmp_path: Path) -> None:
    program = bench_program(tmp_path)
    with ModernBoard() as robot:
        deploy(robot.address, program.file.to_bytes(), program.package)
        assert mpremote(robot.address, "resume", "exec", "print(6*7)").strip() == "42"
        line = Line(robot.address)
        try:
            line.write(b"\r\x03\r\x01print(6*7)\x04")
            assert line.read_until(b"42", PATIENCE_S).endswith(b"42"), "what follows a break reaches the prompt"
        finally:
            line.close()
