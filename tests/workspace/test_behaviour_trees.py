"""Behaviour trees from Python: read as programs of missions, written from them, and refused with a sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

import kitrobot

TEXT = "Wheel.Advance(50); WAIT(10); Wheel.Stop();"


def test_a_program_goes_through_a_tree_and_runs_the_same(tmp_path: Path) -> None:
    program = kitrobot.read_program(TEXT, "mini-robot", "go")
    path = tmp_path / "go.xml"
    kitrobot.save_behaviour_tree(program, path, kitrobot.robot("mini-robot"))
    again = kitrobot.read_behaviour_tree(path, "mini-robot")
    assert again.name == "go"
    listings = [kitrobot.compile_program(one, "mini-robot").image for one in (program, again)]
    assert listings[0] is not None
    assert listings[1] is not None
    assert listings[0].code == listings[1].code
    before = path.read_bytes()
    kitrobot.save_behaviour_tree(again, path, "mini-robot")
    assert path.read_bytes() == before
    assert kitrobot.read_behaviour_tree(str(path), "mini-robot", "other").name == "other"


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "has errors"),
        (b"<kitrobot/>", "has errors"),
        (b'<root BTCPP_format="4"><BehaviorTree ID="a"><Nowhere/></BehaviorTree></root>', "has errors"),
        (b'<root BTCPP_format="4"><Behavior', "has errors"),
        (bytes(range(256)), "has errors"),
    ],
)
def test_a_file_that_is_no_such_tree_is_a_sentence(tmp_path: Path, data: bytes, why: str) -> None:
    path = tmp_path / "tree.xml"
    path.write_bytes(data)
    with pytest.raises(kitrobot.ProblemsError, match=why) as found:
        kitrobot.read_behaviour_tree(path, "mini-robot")
    assert found.value.diagnostics


def test_what_cannot_be_read_or_written_is_a_sentence(tmp_path: Path) -> None:
    program = kitrobot.read_program(TEXT, "mini-robot")
    with pytest.raises(kitrobot.KitRobotError, match="there is no file"):
        kitrobot.read_behaviour_tree(tmp_path / "none.xml", "mini-robot")
    with pytest.raises(kitrobot.KitRobotError, match="there is no folder"):
        kitrobot.save_behaviour_tree(program, tmp_path / "none" / "a.xml", "mini-robot")
    with pytest.raises(kitrobot.ProblemsError, match="has no behaviour tree") as found:
        kitrobot.save_behaviour_tree(program, tmp_path / "a.xml", "store-manager")
    assert found.value.diagnostics
    assert not (tmp_path / "a.xml").exists()
