"""The oracle's own analysis of passes, on bodies that are easy to judge by eye."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse
from tests.oracle.passes import back_edge_costs_a_tick
from tests.semantics.facts import mini_robot

FREE = [
    "WAIT(1)",
    "Door.Open()",
    "°Door.Open()°",
    "//()",
    "//(BREAK, BREAK)",
    "Wheel.Stop(); WAIT(0); Wheel.Stop()",
    "[Run.IsTrue()](WAIT(1))!(Door.Open())",
    "[Run.IsTrue()](WAIT(1))!(BREAK)",
    "[Run.IsTrue()](BREAK); WAIT(1)",
    "<Run.IsTrue()>(WAIT(1))",
    "<Run.IsTrue()>(BREAK)",
    "1*(WAIT(1))",
    "3*(WAIT(1); [Run.IsTrue()](BREAK))",
    "3*([Run.IsTrue()](Door.Open(); BREAK)!(WAIT(1)))",
    "BREAK; Wheel.Stop()",
    "BREAK",
    "WAIT(1); *[Run.IsTrue()]()",
]
COSTLY = [
    "",
    "Wheel.Stop()",
    "°Wheel.Stop()°",
    "Count.Add(1)",
    "0*(WAIT(1))",
    "3*()",
    "3*(Wheel.Stop())",
    "3*(BREAK; WAIT(1))",
    "3*([Run.IsTrue()](BREAK)!(WAIT(1)))",
    "*[Run.IsTrue()](WAIT(1))",
    "[Run.IsTrue()](WAIT(1))",
    "[Run.IsTrue()](WAIT(1))!(Wheel.Stop())",
    "<Run.IsTrue()>()",
    "<Run.IsTrue()>([Run.IsTrue()](WAIT(1)))",
    "*[Run.IsTrue()](BREAK)",
]


@pytest.mark.parametrize("body", FREE)
def test_the_back_edge_is_free_where_every_way_round_blocks(body: str) -> None:
    assert not back_edge_costs_a_tick(parse(body).program, mini_robot())


@pytest.mark.parametrize("body", COSTLY)
def test_the_back_edge_costs_a_tick_where_one_way_round_does_not_block(body: str) -> None:
    assert back_edge_costs_a_tick(parse(body).program, mini_robot())
