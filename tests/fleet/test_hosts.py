"""One mission, all hosts: a shipped one with roles and work is the same in the simulator and as real processes.

One of the robots has a board.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from kitrobot.trace.reader import TraceReader
from tests.boards.bench import STORES, ZERO
from tests.boards.modern import ModernBoard
from tests.fleet.test_processes import started

SEARCH = Path("examples/shared-search/shared-search.krt")
UNITS = 2
BEGUN = """<variable robot="mini-robot" name="Begun" min="0" max="100" initial="3" shared="yes"/>
  <program name="shared-search" level="social">"""

WRITES = """<vertex id="w" element="Begun.Set"><set name="value">42</set></vertex>
    <vertex id="v4" element="ParOfSeq">"""


@pytest.fixture
def mission(tmp_path: Path) -> Path:
    """The search of fewer rooms; the robot of one role writes a variable that all share."""
    for beside in SEARCH.parent.iterdir():
        shutil.copy(beside, tmp_path)
    file = tmp_path / SEARCH.name
    text = file.read_text(encoding="utf-8")
    for old, new in (
        ('units="7"', f'units="{UNITS}"'),
        ('<program name="shared-search" level="social">', BEGUN),
        ('<vertex id="v4" element="ParOfSeq">', WRITES),
        ('<arc from="v3" to="v1" at="return"/>', '<arc from="v3" to="w"/><arc from="w" to="v1" at="return"/>'),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    file.write_text(text, encoding="utf-8")
    return file


def at_the_end(trace: Path) -> dict[str, float]:
    """Variables of all agents, roles, seats and groups at the end of a recorded run."""
    with TraceReader(trace) as recorded:
        last = recorded.seek(recorded.last_tick).values(recorded.header)
    return {
        f"{owner} {name}": value
        for owner, values in last.items()
        for name, value in values.items()
        if name.startswith(("variable", "role", "seat", "group", "missed"))
    }


def test_the_simulator_and_processes_with_a_board_come_to_one_outcome_and_the_same_shared_variables(
    mission: Path, tmp_path: Path, kitrobot: Any
) -> None:
    """One robot's body is simulated; the other is a WebAssembly build of MicroPython at the end of its line."""
    for drivers, source in ((("turn", "drive", "lamp"), STORES.format(mark=0)), (("range",), ZERO)):
        for driver in drivers:
            (tmp_path / f"{driver}.driver.py").write_text(source, encoding="utf-8")
    one, other = tmp_path / "simulator.krtrace", tmp_path / "fleet.krtrace"
    simulated = kitrobot("run", mission, "--trace", one, "--json")
    with ModernBoard() as board:
        on_board = ("--board", f"robot-2={board.address}")
        sent = kitrobot("deploy", mission, "--team", *on_board)
        assert sent.status == 0, sent.err
        words = ("team", str(mission), *on_board, "--pace", "0", "--lease", "2000", "--trace", str(other), "--json")
        with started(*words) as team:
            status, out, said = team.end()
    fleet = json.loads(out)
    assert (simulated.status, status) == (0, 0), said
    assert json.loads(simulated.out)["outcome"] == fleet["outcome"] == "done"
    assert fleet["units"] == {"Rooms": UNITS}
    assert "robot-2: Begun = 42" in said
    assert at_the_end(other) == at_the_end(one)
    assert {at_the_end(other)[f"{name} variable Begun"] for name in ("robot-1", "robot-2")} == {42}
