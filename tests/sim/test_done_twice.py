"""What a substitute does twice in a run is what the compiler tells beforehand."""

from __future__ import annotations

import random

import pytest

from kitrobot.compiler.team.effects import report_effects_done_twice
from kitrobot.diagnostics.model import Rule
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.tree import Node
from kitrobot.mission.trial import Failure
from kitrobot.sim.setup.settings import moves_boxes
from kitrobot.text.sentences import Help, Sentence
from tests.sim.team_building import RunningTeam
from tests.team_programs.making import TeamMaker

TEXT = "role scout: ant; group scouts = scout on failure {failure}; {block}"

BLOCKS = [
    ("ParOfSeq scouts ( Sum.Add(1); WAIT(100); );", 2),
    ("ParOfSeq scouts ( Sum.Set(1); WAIT(100); );", 1),
    ("SeqOfPar scouts ( WAIT(1); Sum.Add(1); WAIT(100); );", 2),
    ("ParOfSeq scouts ( [Said.IsFalse()]( Sum.Add(1); Said.Set(1); ); WAIT(100); );", 1),
    (
        "ParOfSeq scouts ( <Said.IsFalse()>(); Sum.Add(1); Said.Set(1); WAIT(100); [Said.IsTrue()]( Said.Set(0); ); );",
        1,
    ),
    ("SeqOfPar scouts ( [Said.IsFalse()]( Sum.Add(1); Said.Set(1); ); WAIT(100); );", 2),
    ("ParOfSeq scouts ( *[Sum.LessThan(3)]( Sum.Add(1); WAIT(40); ); );", 3),
    ("ParOfSeq scouts ( 3*( Sum.Add(1); WAIT(40); ); );", 4),
]


def sum_after(text: str, failures: list[Failure]) -> tuple[int, list[str]]:
    """The sum at the end of a run, when scout `a` may fail and `c` is spare; and what is told of the program."""
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    maker = TeamMaker(random.Random(0))
    maker.agents = {"a": ("ant", "scout"), "c": ("ant", "")}
    team = RunningTeam(maker, parsed.program, 1, failures)
    told: list[str] = []

    def report(rule: Rule, message: Sentence, node: Node, help: Help = "") -> None:
        told.append(rule.code)

    report_effects_done_twice(team.whole, team.crew, team.robots, moves_boxes, report)
    seen = 0
    while team.run.outcome is None:
        team.run.step()
        for agent in team.run.members:
            seen = max(seen, int(agent.machine.cells[agent.machine.layout.variables["Sum"]]))
    return seen, told


@pytest.mark.parametrize(("block", "wanted"), BLOCKS)
def test_a_line_is_told_exactly_where_its_effect_is_there_twice(block: str, wanted: int) -> None:
    text = TEXT.format(failure="substitute", block=block)
    sound, told = sum_after(text, [])
    failed, _ = sum_after(text, [Failure("a", 0.6)])
    assert failed == wanted
    assert bool(told) == (failed != sound)


def test_what_was_done_in_a_block_that_is_over_is_not_done_again() -> None:
    block = "SeqOfPar scouts ( WAIT(1); Sum.Add(1); ); ParOfSeq scouts ( WAIT(100); );"
    text = TEXT.format(failure="substitute", block=block)
    assert sum_after(text, [Failure("a", 0.6)])[0] == 1


def test_without_a_substitute_it_is_done_once() -> None:
    text = TEXT.format(failure="drop", block=BLOCKS[0][0])
    assert sum_after(text, [Failure("a", 0.6)]) == (1, [])
