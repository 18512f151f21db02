"""Constructors of programs of teams: their level, and what their code may say."""

from __future__ import annotations

import pytest

from kitrobot.lll.tree import Members, Move, ProgramCall, SeqOfPar
from kitrobot.primitives.constructors import Constructor, Role
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.levels import Level
from kitrobot.primitives.match_template import unfill
from kitrobot.primitives.own_xml import read_own, write_constructor


def read(attributes: str, slots: str, code: str) -> tuple[Constructor | None, list[str]]:
    one = f'<constructor name="X" {attributes}>{slots}<code>{code}</code></constructor>'
    text = f'<constructors version="1"><group name="G" colour="team">{one}</group></constructors>'
    groups, found = read_constructors(text.encode(), "x.xml")
    made = [constructor for group in groups for constructor in group.constructors]
    return (made[0] if made else None), [item.message for item in found]


BLOCK = '<text name="who" default="{a, b}"/><flow name="body"/>', "SeqOfPar {who} ({body})"


def test_the_level_of_a_constructor_is_read_and_written() -> None:
    for level in Level:
        made, found = read(f'level="{level}"', '<flow name="body"/>', "*({body})")
        assert found == []
        assert made is not None
        assert made.level is level
        again, found_again = read_own(write_constructor(made), "own.xml")
        assert found_again == []
        assert isinstance(again, Constructor)
        assert again.level is level
    assert read('level="crowd"', '<flow name="body"/>', "*({body})")[1] == [
        "expected agent, group or social in level, found “crowd”"
    ]


def test_code_that_speaks_of_several_robots_needs_a_level() -> None:
    made, found = read("", *BLOCK)
    assert made is None
    assert found == ["its code speaks of several robots, so it stands in programs of a team"]
    made, found = read('level="group"', *BLOCK)
    assert found == []
    assert made is not None
    assert (made.role, made.slots[0].default) == (Role.INSTRUCTION, "{a, b}")


def test_a_joint_condition_is_a_constructor_for_conditions() -> None:
    made, found = read('level="group"', '<condition name="c"/>', "most {a, b} ({c})")
    assert found == []
    assert made is not None
    assert made.role is Role.CONDITION


@pytest.mark.parametrize(
    ("slots", "code"),
    [
        ('<number name="who"/><flow name="body"/>', "SeqOfPar {who} ({body})"),
        ('<flow name="name"/>', "PROGRAM {name}"),
        ('<text name="n"/>', "MOVE {n} a -&gt; b"),
    ],
)
def test_a_hole_for_a_name_or_a_set_is_a_text(slots: str, code: str) -> None:
    made, [told] = read('level="social"', slots, code)
    assert made is None
    assert told.startswith("expected a slot <")


def test_what_stands_in_the_holes_of_a_form_is_found_again() -> None:
    slots = '<number name="n" max="3"/><text name="from"/><text name="to"/>'
    move, _ = read('level="social"', slots, "MOVE {n} {from} -&gt; {to}")
    assert move is not None
    assert move.template is not None
    assert unfill(move, move.template, Move(2, "a", "b c")) == {"n": 2, "from": "a", "to": "b c"}
    assert unfill(move, move.template, Move(4, "a", "b")) is None
    assert unfill(move, move.template, ProgramCall("a")) is None
    block, _ = read('level="group"', *BLOCK)
    assert block is not None
    assert block.template is not None
    made = SeqOfPar(Members(["a"], braced=False), block.template.body)  # type: ignore[union-attr]
    bound = unfill(block, block.template, SeqOfPar(made.members, type(made.body)()))
    assert bound is not None
    assert bound["who"] == Members(["a"], braced=False)
