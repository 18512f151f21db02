"""The convoy with one follower: as few processes and ticks as a team needs in which a spare robot takes over."""

from __future__ import annotations

import shutil
from pathlib import Path

from tests.fleet.test_processes import CONVOY

NAMES = ["robot-1", "robot-2", "robot-4"]
"""The leader, the follower and the spare robot."""


def write_short_convoy(folder: Path) -> Path:
    """Writes its file into a folder, with drivers of its parts beside it; nobody fails by schedule."""
    text = Path(CONVOY).read_text(encoding="utf-8")
    for beside in Path(CONVOY).parent.iterdir():
        shutil.copy(beside, folder)
    for driver in ("turn", "drive", "lamp"):
        (folder / f"{driver}.driver.py").write_text("def make(settings):\n    raise OSError\n", encoding="utf-8")
    for old, new in (
        ('<failure agent="robot-2" at="3" kind="fail"/>', ""),
        ('<agent name="robot-3" program="convoy" robot="mini-robot"/>', ""),
        (' least="2"', ""),
        ('<set name="count">2</set>', '<set name="count">1</set>'),
        ('<set name="duration">40</set>', '<set name="duration">10</set>'),
    ):
        assert old in text
        text = text.replace(old, new)
    file = folder / "convoy.krt"
    file.write_text(text, encoding="utf-8")
    return file
