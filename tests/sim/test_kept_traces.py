"""Shipped missions, none of which has a radio, do what they did before there was one: hashes of their runs are kept.

How they are written anew when a mission changes: `tests.sim.kept_traces`.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.sim.kept_traces import EXAMPLES, KEPT, anew, missions, trace_of

ALL = {mission.relative_to(EXAMPLES).as_posix(): mission for mission in missions()}


def test_each_shipped_mission_has_a_kept_trace() -> None:
    assert sorted(json.loads(KEPT.read_text(encoding="utf-8"))) == sorted(ALL)


@pytest.mark.parametrize("name", ALL)
def test_a_mission_without_a_radio_gives_the_trace_that_it_gave(name: str) -> None:
    assert "<radio" not in ALL[name].read_text(encoding="utf-8")
    assert trace_of(ALL[name]) == json.loads(KEPT.read_text(encoding="utf-8"))[name]


def test_a_radio_changes_the_trace_of_a_mission_that_shares_variables(tmp_path: Path) -> None:
    """Else the hashes would hold whatever the radio did."""
    shared = ALL["shared-search/shared-search.krt"]
    for beside in shared.parent.iterdir():
        (tmp_path / beside.name).write_bytes(beside.read_bytes())
    file = tmp_path / shared.name
    text = file.read_text(encoding="utf-8").replace("</kitrobot>", '<radio delay="200"/></kitrobot>')
    file.write_text(text, encoding="utf-8")
    assert anew(shared).state.radio.numbers == []
    assert anew(file).state.radio.numbers != []
    assert trace_of(file) != trace_of(shared)
