"""Ctrl-C ends a command at any moment, with status 130 and one line; a board is left as after a reset."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Event, Thread

import pytest

from tests.effort import cases
from tests.patience import PATIENCE_S

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no such signal")

IMPORTING = """
import builtins, os, signal

real = builtins.__import__

def imported(name, *rest):
    if name == {module!r}:
        os.kill(os.getpid(), signal.SIGINT)
    return real(name, *rest)

signal.signal(signal.SIGINT, signal.default_int_handler)
builtins.__import__ = imported
from kitrobot.__main__ import run
run()
"""


@pytest.mark.parametrize(
    "module", ["kitrobot.cli.app", "typer", "kitrobot.robots.program", "kitrobot.workspace.mission_loader"]
)
def test_ctrl_c_while_modules_are_imported_ends_with_one_line(tmp_path: Path, module: str) -> None:
    script = tmp_path / "probe.py"
    script.write_text(IMPORTING.format(module=module))
    command = [sys.executable, str(script), "deploy", "nothing.krt", "--to", "socket://127.0.0.1:1"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=False, cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "broken off\n")


class StrangeBoard:
    """What a command finds on a line: nobody, or one that talks for ever. `heard`: what was said to it."""

    def __init__(self, says: bytes) -> None:
        self.heard = b""
        self.called = Event()
        self.says = says
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"socket://127.0.0.1:{self.listener.getsockname()[1]}"
        self.hears = Thread(target=self._listen, daemon=True)
        self.hears.start()

    def _listen(self) -> None:
        with suppress(OSError):
            wire, _ = self.listener.accept()
            if self.says:
                Thread(target=self._talk, args=(wire,), daemon=True).start()
            while data := wire.recv(4096):
                self.heard += data
                self.called.set()

    def _talk(self, wire: socket.socket) -> None:
        with suppress(OSError):
            while True:
                wire.sendall(self.says)

    def close(self) -> None:
        self.listener.close()


@contextmanager
def strange(says: bytes) -> Iterator[StrangeBoard]:
    board = StrangeBoard(says)
    try:
        yield board
    finally:
        board.close()


COMMANDS = {
    "deploy": ("drive.lll", "--robot", "mini-robot", "--board", "pico", "--to"),
    "bench": ("--board", "pico", "--all", "--to"),
    "calibrate": ("--board", "pico", "--to"),
    "boards": ("--to",),
    "start": ("--to",),
    "watch": ("--to",),
    "log": ("--to",),
}
SAYS = {"nothing": b"", "for ever": b"x\r\n>>> " * 100}


def interrupted(folder: Path, board: StrangeBoard, name: str) -> tuple[int, str]:
    """Status and words of a command that is interrupted once it has called a board."""
    (folder / "drive.lll").write_text("Wheel.Advance(40); WAIT(5); Wheel.Stop();")
    command = [sys.executable, "-m", "kitrobot", name, *COMMANDS[name], board.address]
    with subprocess.Popen(
        command,
        cwd=folder,
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "KITROBOT_STATE": str(folder / "state"), "KITROBOT_CONFIG": str(folder / "none")},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    ) as process:
        assert process.stdin is not None
        process.stdin.write("\n")
        process.stdin.flush()
        while not board.called.wait(1):
            assert process.poll() is None, process.stderr.read() if process.stderr is not None else ""
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=PATIENCE_S)
    return process.returncode, said


ALL_CALLS = [(name, says) for name in COMMANDS for says in SAYS]
CALLS = [(name, list(SAYS)[(number + 1) % 2]) for number, name in enumerate(COMMANDS)]
"""Each command with one of the boards; test_a_board_is_left_as_after_a_reset deploys to the other."""
TRIED = cases(CALLS, [call for call in ALL_CALLS if call not in CALLS])


@pytest.mark.parametrize(("name", "says"), TRIED)
def test_ctrl_c_ends_what_waits_for_a_board(tmp_path: Path, name: str, says: str) -> None:
    with strange(SAYS[says]) as board:
        status, said = interrupted(tmp_path, board, name)
        assert status == 130, said
        assert "Traceback" not in said
        assert [line for line in said.splitlines() if "broken off" in line] == said.splitlines()[-1:]


def test_a_board_is_left_as_after_a_reset(tmp_path: Path) -> None:
    with strange(b"") as board:
        status, said = interrupted(tmp_path, board, "deploy")
        assert (status, said) == (130, "broken off: a board that was not done keeps what it had\n")
        board.hears.join()  # until the command has let go of the line
        assert board.heard.endswith(b"\r\x03\x03\r\x02\x04")
