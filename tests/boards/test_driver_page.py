"""The page about drivers of one's own is true: its files are written down, deployed, and do what it says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from tests.boards.modern import ModernBoard, greet_until
from tests.boards.test_modern_robot import pins_told
from tests.patience import PATIENCE_S

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "drivers.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", PAGE, re.DOTALL)
BUZZER, BATTERY = 15, 26


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The files of the page, in one folder."""
    names = {
        "buzzer.driver.py": ("python", 0),
        "battery.driver.py": ("python", 1),
        "try_buzzer.py": ("python", 2),
        "signaller.robot.xml": ("xml", 0),
        "low.lll": ("", 0),
    }
    for name, (kind, number) in names.items():
        assert name in PAGE
        text = [text for found, text in BLOCKS if found == kind][number]
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_the_example_is_deployed_and_beeps_twice_when_the_battery_is_low(kit: ModernBoard, folder: Path) -> None:
    program = load_board_program(folder / "low.lll", robot=str(folder / "signaller.robot.xml"))
    deploy(kit.address, program.file.to_bytes(), program.package)
    with connect(kit.address, PATIENCE_S) as line:
        # No volts at all: the battery is empty, so it beeps at once and ends.
        greet_until(line, lambda hello: hello.state == 3)
    told = [entry for entry in pins_told(kit) if entry[0] == BUZZER]
    sounds = [(what, value) for _, what, value in told if (what, value) != ("duty", 0)]
    loud = ("duty", 50 * 32767 // 100)
    assert sounds == [("freq", 440), ("freq", 880), loud, ("freq", 880), loud]
    assert told[-1] == (BUZZER, "duty", 0)


def test_it_can_be_tried_without_a_robot_as_the_page_shows(folder: Path) -> None:
    done = subprocess.run(
        [sys.executable, "try_buzzer.py"], cwd=folder, capture_output=True, text=True, timeout=PATIENCE_S, check=False
    )
    assert done.stderr == ""
    shown = next(text for _, text in BLOCKS if text.startswith("$ python try_buzzer.py"))
    assert done.stdout == shown.partition("\n")[2]


def test_the_page_names_what_a_driver_has() -> None:
    for face in ("make(settings)", "do(procedure, arguments)", "done()", "stop()", "read()"):
        assert f"| `{face}` |" in PAGE
