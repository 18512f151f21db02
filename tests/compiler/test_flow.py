"""Which loops go round within a tick: a back edge is free where every way round surely blocks."""

from __future__ import annotations

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.compiler.program.flow import FlowAnalysis
from kitrobot.image.listing import disassemble
from kitrobot.image.verification import verify
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Repeat
from tests.compiler.graphs import shipped

FREE = [
    "WAIT(1);",
    "WAIT(0);",
    "Door.Open();",
    "°Door.Open()°;",
    "Motor.AbsoluteTurn(1, 1);",
    "//(Wheel.Stop(););",
    "//();",
    "Wheel.Stop(); WAIT(1);",
    "WAIT(1); Wheel.Stop();",
    "[Run.IsTrue()](WAIT(1);)!(Door.Open(););",
    "[Run.IsTrue()]([Flag.IsTrue()](WAIT(1);)!(WAIT(2););)!(WAIT(3););",
    "1*(WAIT(1););",
    "3*(2*(WAIT(1);););",
    "<Run.IsTrue()>(WAIT(1););",
    "3*(<Run.IsTrue()>(Door.Open();););",
    # a way that leaves is no way round
    "BREAK;",
    "[Run.IsTrue()](BREAK;); WAIT(1);",
    "[Run.IsTrue()](BREAK;)!(WAIT(1););",
    "WAIT(1); [Run.IsTrue()](BREAK;);",
    "[Run.IsTrue()](BREAK;)!(BREAK;);",
    "<Run.IsTrue()>(BREAK;);",
    # BREAK in an inner loop leaves that loop only
    "2*([Run.IsTrue()](BREAK;);); WAIT(1);",
    "2*(WAIT(1); BREAK;);",
    "2*(WAIT(1); [Run.IsTrue()](BREAK;););",
    "2*([Run.IsTrue()](WAIT(1);)!(WAIT(1); BREAK;););",
    # one way round is enough to block, whatever else there is
    "*[Run.IsTrue()](); WAIT(1);",
    "WAIT(1); 0*(BREAK;);",
]

COSTS_A_TICK = [
    "",
    "Wheel.Stop();",
    "°Wheel.Stop()°;",
    "Count.Add(1);",
    "Fault.Clear();",
    "[Run.IsTrue()](WAIT(1););",
    "[Run.IsTrue()](WAIT(1);)!();",
    "[Run.IsTrue()](WAIT(1);)!(Wheel.Stop(););",
    "[Run.IsTrue()]()!(WAIT(1););",
    "0*(WAIT(1););",
    "3*();",
    "3*(Wheel.Stop(););",
    "*[Run.IsTrue()](WAIT(1););",
    "*[Run.IsTrue()]();",
    "<Run.IsTrue()>();",
    "<Run.IsTrue()>(Wheel.Stop(););",
    "3*([Run.IsTrue()](WAIT(1);););",
    "2*(BREAK; WAIT(1););",
    "2*(BREAK;);",
    "2*([Run.IsTrue()](BREAK;); WAIT(1););",
    "2*(<Run.IsTrue()>(BREAK;););",
    "2*([Run.IsTrue()](BREAK;)!(WAIT(1);););",
    "2*(2*([Run.IsTrue()](BREAK;); WAIT(1);););",
]

ROBOT = shipped().robots["mini-robot"]


@pytest.mark.parametrize(
    ("body", "free"), [*((body, True) for body in FREE), *((body, False) for body in COSTS_A_TICK)]
)
def test_a_back_edge_is_free_exactly_where_every_way_round_blocks(body: str, free: bool) -> None:
    (loop,) = parse(f"5*({body})").program.items
    assert isinstance(loop, Repeat)
    assert FlowAnalysis(ROBOT).back_edge_is_free(loop.body) is free


@pytest.mark.parametrize("loop", ["5*({})", "*[Run.IsTrue()]({})"])
@pytest.mark.parametrize(
    ("body", "free"), [*((body, True) for body in FREE), *((body, False) for body in COSTS_A_TICK)]
)
def test_a_loop_is_verified_whether_its_back_edge_is_free_or_not(loop: str, body: str, free: bool) -> None:
    compiled = compile_text(loop.format(body), ROBOT)
    assert compiled.image is not None
    verify(compiled.image)
    back = [line.split()[0] for line in disassemble(compiled.image).split("\n") if line.startswith("    ")]
    last = next(op for op in reversed(back[: back.index("END")]) if op in ("JMP", "LOOP"))
    assert last == ("JMP" if free else "LOOP")
