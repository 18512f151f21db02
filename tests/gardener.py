"""The robot with devices of one's own that docs/xml.md shows, as files in a folder."""

from __future__ import annotations

import re
from pathlib import Path

from typer.testing import CliRunner

from kitrobot.cli.app import app

PAGE = Path(__file__).parents[1] / "docs" / "xml.md"


def gardener(folder: Path) -> Path:
    """Writes the robot, and the mission that its text becomes as the page says; gives the mission's file."""
    section = PAGE.read_text(encoding="utf-8").partition("### Parts that the simulator does not know")[2]
    robot, text = (re.search(rf"```{kind}\n(.*?)```", section, re.DOTALL) for kind in ("xml", "lll"))
    assert robot
    assert text
    (folder / "gardener.robot.xml").write_text(robot[1], encoding="utf-8")
    (folder / "gardener.lll").write_text(text[1], encoding="utf-8")
    files = [str(folder / name) for name in ("gardener.lll", "gardener.krt")]
    made = CliRunner().invoke(app, ["convert", *files, "--robot", str(folder / "gardener.robot.xml")])
    assert made.exit_code == 0, made.output
    return folder / "gardener.krt"
