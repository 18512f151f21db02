"""Several processes write on one standard error: each writes whole lines, in one piece."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.patience import PATIENCE_S

CHILD = """\
from kitrobot.cli.output import print_message, standard_streams
with standard_streams():
    for line in ("a" * 3000, "b", "c"):
        print_message(line)
"""


@pytest.mark.skipif(
    not hasattr(os, "O_DIRECT") or sys.platform != "linux", reason="needs a pipe that keeps writes apart"
)
@pytest.mark.parametrize("unbuffered", [False, True])
def test_a_line_is_written_in_one_piece(unbuffered: bool) -> None:
    out, into = os.pipe2(os.O_DIRECT)
    try:
        command = [sys.executable, *(["-u"] if unbuffered else []), "-c", CHILD]
        subprocess.run(command, stderr=into, check=True, timeout=PATIENCE_S)
        os.close(into)
        written = []
        while data := os.read(out, 65_536):
            written.append(data.decode())
    finally:
        os.close(out)
    assert written == ["a" * 3000 + "\n", "b\n", "c\n"]
