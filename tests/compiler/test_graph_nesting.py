"""Graphs that nest: to the limit, beyond it, and far beyond it."""

from __future__ import annotations

import pytest

from kitrobot.compiler.compilation import compile_lll
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import MAX_NESTING
from tests.compiler.graphs import graph, shipped, text_of, told, translated, with_constructors
from tests.lll.frames import at_most_frames


def nested_loops(depth: int) -> list[str]:
    inner = [f"v{n}.body > v{n + 1}:Repetition count=1 > v{n}.return" for n in range(1, depth)]
    return ["start > v1:Repetition count=1 > stop", *inner, f"v{depth}.body > v{depth}.return"]


def nested_tests(depth: int) -> list[str]:
    inner = [f"v{n + 1}:No > v{n}.condition" for n in range(1, depth)]
    last = f"last:Run.IsTrue > v{depth}.condition"
    return ["start > w:When > stop", "w.body > w.return", "v1:No > w.condition", *inner, last]


def nested_values(depth: int) -> list[str]:
    return ["start > v0:Count.Set > stop", *(f"v{n + 1}:Count.Set > v{n}.value" for n in range(depth))]


def nested_parallels(depth: int) -> list[str]:
    inner = [f"v{n}.branch.1 > v{n + 1}:Parallelism > v{n}.return" for n in range(1, depth)]
    return ["start > v1:Parallelism > stop", *inner]


NESTS = [nested_loops, nested_tests, nested_values, nested_parallels]


@pytest.mark.parametrize("lines", NESTS)
def test_a_graph_at_the_nesting_limit_is_translated_to_a_text_that_reads(lines: object) -> None:
    assert callable(lines)
    program = graph(*lines(MAX_NESTING))
    with at_most_frames(850):  # of the host's 1000; doors, tests and debuggers need some too
        translation = translated(program)
        parsed = parse(print_program(translation.program))
        compile_lll(translation.program, shipped().robots["mini-robot"])
    assert translation.diagnostics == []
    assert parsed.diagnostics == []
    assert parsed.program == translation.program


@pytest.mark.parametrize("lines", NESTS)
@pytest.mark.parametrize("depth", [MAX_NESTING + 1, 5000])
def test_a_graph_beyond_the_nesting_limit_is_told_once(lines: object, depth: int) -> None:
    assert callable(lines)
    program = graph(*lines(depth))
    assert [code for code, _ in told(program)] == ["graph-too-deep"]


def test_templates_do_not_take_a_program_over_the_nesting_limit() -> None:
    deep = "2*(" * 30 + "{body}" + ")" * 30
    catalogue = with_constructors(f'<constructor name="Deep"><flow name="body"/><code>{deep}</code></constructor>')

    def chain(count: int) -> list[str]:
        inner = [f"v{n}.body > v{n + 1}:Deep > v{n}.return" for n in range(1, count)]
        return ["start > v1:Deep > stop", *inner, f"v{count}.body > v{count}.return"]

    assert told(graph(*chain(3)), catalogue) == []
    assert [code for code, _ in told(graph(*chain(4)), catalogue)] == ["graph-too-deep"]
    assert [code for code, _ in told(graph(*chain(90)), catalogue)] == ["graph-too-deep"]


def test_a_long_program_does_not_nest() -> None:
    chain = " > ".join(f"v{n}:Wheel.Stop" for n in range(5000))
    assert text_of(graph(f"start > {chain} > stop")).count("\n") == 5000
