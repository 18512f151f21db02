"""`kitrobot deploy` as a person types it: to several boards at once, with bars, and names that are known afterwards."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.boards.bench import ONE, OTHER, bench_program
from tests.boards.modern import ModernBoard
from tests.boards.watching import KITROBOT, LONG_S, called, counts, watched


@pytest.fixture(scope="module")
def two() -> Iterator[tuple[ModernBoard, ModernBoard]]:
    with ModernBoard() as one, ModernBoard() as other:
        yield one, other


@pytest.fixture
def files(tmp_path: Path) -> list[str]:
    """What a person names: the program and its robot."""
    bench_program(tmp_path, ONE)
    return [str(tmp_path / "program.lll"), "--robot", str(tmp_path / "bench.robot.xml")]


def hang_up(listener: socket.socket) -> None:
    """Ends each connection at its first byte."""
    with contextlib.suppress(OSError):
        while True:
            wire, _ = listener.accept()
            with wire:
                wire.recv(1)


def test_one_that_fails_does_not_hold_up_the_others(two: Any, files: list[str]) -> None:
    one, other = two
    with socket.create_server(("127.0.0.1", 0)) as listener:
        nobody = f"socket://127.0.0.1:{listener.getsockname()[1]}"
        threading.Thread(target=hang_up, args=(listener,), daemon=True).start()
        said = called("deploy", *files, "--to", one.address, "--to", nobody, "--to", other.address, "--json")
    assert said.returncode == 1
    found = json.loads(said.stdout)
    assert [each["ok"] for each in found] == [True, False, True]
    assert found[0]["program"] == found[2]["program"]
    assert f"{nobody}:" in said.stderr
    listed = json.loads(called("boards", "--to", one.address, "--to", other.address, "--json").stdout)
    assert len(listed) == 2
    for seen in listed:
        assert seen["state"] == "running"
        # It was sent from here, so its name is known.
        assert seen["name_of_program"] == "program"
    assert watched("--to", one.address, enough=counts)
    assert "nothing to send" in called("deploy", *files, "--to", one.address).stdout


@pytest.mark.skipif(sys.platform == "win32", reason="no terminals of our own there")
def test_each_board_has_a_bar_while_a_person_watches(two: Any, tmp_path: Path, files: list[str]) -> None:
    import pty

    bench_program(tmp_path, OTHER)  # which they do not have yet
    ours, theirs = pty.openpty()
    command = [*KITROBOT, "deploy", *files, "--to", two[0].address, "--to", two[1].address]
    with open(ours, "rb", buffering=0) as terminal:
        environment = {**os.environ, "COLUMNS": "120", "TERM": "xterm"}
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=theirs, env=environment)
        os.close(theirs)
        drawn = b""
        with contextlib.suppress(OSError):  # how the end of a terminal is told
            while piece := terminal.read(4096):
                drawn += piece
        assert process.stdout is not None
        given = process.stdout.read()
        assert process.wait(LONG_S) == 0
    for board in two:
        assert board.address.encode() in drawn
    assert b"sending" in drawn
    assert given.count(b"bytes of memory are left") == given.count(b"generation ") == 2
