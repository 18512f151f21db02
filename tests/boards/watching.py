"""Commands of a user: most in this process; `kitrobot watch` in one of its own, until somebody presses Ctrl-C."""

from __future__ import annotations

import io
import json
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from typing import IO, Any

import pytest

from kitrobot.cli.app import main

KITROBOT = [sys.executable, "-m", "kitrobot"]
LONG_S = 240


@dataclass(frozen=True)
class Called:
    """How a command ended, and what it said."""

    returncode: int
    stdout: str
    stderr: str


def called(*arguments: str) -> Called:
    """A command as a user types it, without a process of its own: starting one takes longer than most commands."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), pytest.raises(SystemExit) as end:
        main(list(arguments))
    return Called(int(end.value.code or 0), out.getvalue(), err.getvalue())


def watched(*arguments: str, enough: Callable[[list[dict[str, Any]]], object]) -> list[dict[str, Any]]:
    """All that it told, as objects."""
    command = [*KITROBOT, "watch", *arguments, "--json"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    heard: list[dict[str, Any]] = []
    for line in process.stdout:
        heard.append(json.loads(line))
        if enough(heard):
            process.send_signal(signal.SIGINT)
            break
    rest, said = process.communicate(timeout=LONG_S)
    assert process.returncode == 0, said
    return heard + [json.loads(line) for line in rest.splitlines()]


def counts(heard: list[dict[str, Any]]) -> list[int]:
    """The values of the variable Count that were told."""
    return [line["variables"]["Count"] for line in heard if "Count" in line.get("variables", {})]


def line_with(word: str, stream: IO[str]) -> str:
    """The next line in which that word stands."""
    for line in stream:
        if word in line:
            return line
    raise AssertionError(f"no {word!r} was said")
