"""What fails in a driver of one's own is told with its line and the names that stand there."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.package import Package
from tests.boards.bench import ONE, bench_program
from tests.boards.modern import ModernBoard
from tests.boards.test_deploy import put
from tests.patience import PATIENCE_S

DRIVER = '''"""A wheel that fails where it says so."""

import sys
from kitrobot_onboard.drivers.any.shared.counting import (
    Marks,
)


class BrokenWheel:
    def __init__(self, settings):
        self.settings = settings  # ohne Umlaute: äöü

    def do(self, procedure, arguments):
        self.turn(arguments)

    def turn(self, arguments):
        self.speed_of_nobody.set(1)  # the line that fails

    def done(self):
        return True

    def stop(self):
        pass


def make(settings):
    return BrokenWheel(settings)
'''


def line_of(text: str, words: str) -> int:
    return next(number for number, line in enumerate(text.split("\n"), 1) if words in line)


def test_a_fault_names_the_line_and_the_class_of_a_driver_of_ones_own(board: ModernBoard, tmp_path: Path) -> None:
    program = bench_program(tmp_path, ONE)
    (tmp_path / "stores.driver.py").write_text(DRIVER, encoding="utf-8")
    put(board.address, program)
    with connect(board.address, PATIENCE_S) as robot:
        while (fault := robot.last_fault()) is None:
            pass
    said = program.names.fault_text(fault.text).partition(": ")[2]
    assert said.startswith(f"line {line_of(DRIVER, 'the line that fails')} AttributeError"), said
    assert "BrokenWheel" in said


def test_a_driver_that_does_not_start_names_its_line_too(board: ModernBoard, tmp_path: Path) -> None:
    program = bench_program(tmp_path, ONE)
    text = DRIVER.replace("self.settings = settings", "raise OSError('no such pin')")
    (tmp_path / "stores.driver.py").write_text(text, encoding="utf-8")
    with pytest.raises(BoardError) as error:
        put(board.address, program)
    assert f"line {line_of(text, 'no such pin')} OSError" in error.value.message


@pytest.mark.parametrize("first", ["import sys; import os", "x: int = 1", "from __future__ import annotations"])
def test_what_cannot_keep_its_lines_is_shortened_as_ours_are(tmp_path: Path, first: str) -> None:
    (tmp_path / "mine.driver.py").write_text(f"{first}\n\n\ndef make(settings):\n    return lambda: 0  # nothing\n")
    built = Package((tmp_path,)).build("machine", {"mine": None}, COMPILED_LOOP)
    assert built.in_lines == {}
    assert b"nothing" not in built.files[built.drivers["mine"]]
