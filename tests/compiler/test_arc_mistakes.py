"""A mistake of an arc names the arc."""

from __future__ import annotations

import pytest

from tests.compiler.graphs import graph, translated

ARCS = [
    (["start > v1:Wheel.Stop > stop", "v1 > v9"], [("v1", "next", "v9", "in")]),
    (["start > v1:Wheel.Stop > stop", "v1.body > stop"], [("v1", "body", "stop", "in")]),
    (
        ["start > v1:Wheel.Stop > stop", "start > v2:Door.Open > stop"],
        [("start", "next", "v1", "in"), ("start", "next", "v2", "in")],
    ),
    (["start > v1:Wheel.Stop > v1"], [("v1", "next", "v1", "in")]),
    (
        ["start > v1:Repetition > v2:Repetition > stop", "v1.body > v2.return", "v2.body > v2.return"],
        [("v1", "body", "v2", "return")],
    ),
    (["start > v1:Repetition > stop", "v1.body > stop"], [("v1", "body", "stop", "in")]),
]


@pytest.mark.parametrize(("lines", "arcs"), ARCS)
def test_a_mistake_of_an_arc_names_the_arc(lines: list[str], arcs: list[tuple[str, ...]]) -> None:
    mistake = next(item for item in translated(graph(*lines)).diagnostics if item.is_error)
    assert list(mistake.arcs) == arcs
