"""The command line, called as a person calls it but without starting a process: what it says and how it ends."""

from __future__ import annotations

import io
import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from kitrobot.cli import output
from kitrobot.cli.app import main
from kitrobot.files.examples import examples_folder
from tests.boards.host import host_board, write_pulse

_EXAMPLES = examples_folder()
assert _EXAMPLES is not None
EXAMPLE = _EXAMPLES / "transport" / "transport.krt"
LLL = """# drive and count
*[Run.IsTrue()](
  Wheel.Advance(50);
  [Captor.LessThan(10)](Motor.AbsoluteTurn(25, 50); )!(Count.Add(1); );
);
"""
MISTAKEN = "Wheel.Advance(50;\nWait(1;\nBREAK BREAK;\n)\n"


@dataclass(frozen=True)
class Said:
    """What a command gave, what it said, and its status."""

    status: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        """The output as one JSON value."""
        return json.loads(self.out)

    @property
    def lines(self) -> list[Any]:
        """The output as a JSON value a line."""
        return [json.loads(line) for line in self.out.splitlines()]


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, and the command line in it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "no-config"))
    monkeypatch.delenv("KITROBOT_DEBUG", raising=False)
    monkeypatch.setenv("COLUMNS", "100")
    return tmp_path


@pytest.fixture
def kitrobot(here: Path, monkeypatch: pytest.MonkeyPatch):
    """Runs a command."""

    def call(*arguments: object, studio: Any = None, stdin: bytes = b"") -> Said:
        out, err = io.TextIOWrapper(io.BytesIO(), "ascii"), io.TextIOWrapper(io.BytesIO(), "ascii")
        monkeypatch.setattr(sys, "stdout", out)
        monkeypatch.setattr(sys, "stderr", err)
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin), "utf-8"))
        with pytest.raises(SystemExit) as end:
            main([str(argument) for argument in arguments], studio=studio)
        texts = []
        for stream in (out, err):
            stream.flush()
            texts.append(stream.buffer.getvalue().decode())
        assert isinstance(end.value.code, int)
        said = Said(end.value.code, *texts)
        assert "Traceback" not in said.err + said.out
        return said

    return call


@pytest.fixture
def program(here: Path) -> Path:
    """An LLL program for the mini-robot."""
    path = here / "drive.lll"
    path.write_text(LLL, encoding="utf-8")
    return path


@pytest.fixture
def no_boards(monkeypatch, tmp_path):
    """Nothing is known of boards."""
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.delenv("KITROBOT_BOARDS", raising=False)


@pytest.fixture
def pulse(here):
    """The mission of a program that counts."""
    return write_pulse(here)


@pytest.fixture
def robot(pulse):
    """A robot that has it, and runs it."""
    with host_board(pulse, "pulse") as board:
        yield board


@pytest.fixture
def broken(here):
    """A robot whose display fails."""
    with host_board(write_pulse(here, broken=True), "pulse") as board:
        yield board


@pytest.fixture
def watch(kitrobot, monkeypatch):
    """Watches until that holds of what was given up to then, and presses Ctrl-C."""

    def call(*arguments, until):
        given = []

        def print_data(text):
            output.print_data(text)
            given.append(text)
            if until("".join(given)):
                raise KeyboardInterrupt

        with monkeypatch.context() as patched:
            patched.setattr("kitrobot.cli.watch.print_data", print_data)
            return kitrobot("watch", *arguments)

    return call
