"""The benchmarks still run, on sizes so small that their numbers mean nothing; what they compare is comparable."""

from __future__ import annotations

import gc
import json
import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from benchmarks.__main__ import main, table
from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.peers import behaviour_tree, blockly, lark_parser
from benchmarks.random_programs import ROBOT, catalogue, graph_of, text_of_lines, tree_of_vertices
from benchmarks.subjects import names, subject
from kitrobot.compiler.compilation import compile_program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from tests.effort import THOROUGH, cases
from tests.strategies import Shape, random_program

ROOT = Path(__file__).parents[2]


CHEAP = ["checking", "compiling", "interpreting", "meetings", "parsing", "starting", "tracing", "watchers"]
IN_A_BROWSER = ("site", "studio")
UNCOMPILED: dict[str, dict[str, Any]] = {"interpreting": {"robots": 0}, "checking": {"compiled": 0, "carriers": (2,)}}
"""Sizes with which Numba compiles nothing, which takes longer than all else."""


@pytest.fixture(autouse=True)
def _left_alone() -> None:
    """Measuring collects garbage: that of other tests takes seconds."""
    gc.freeze()


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.browser] * (name in IN_A_BROWSER) + [pytest.mark.site] * (name == "site"))
        for name in cases(CHEAP, [name for name in names() if name not in CHEAP])
    ],
)
def test_every_subject_runs(name: str) -> None:
    one = subject(name)
    rows = one.run(one.TINY if THOROUGH else replace(one.TINY, **UNCOMPILED.get(name, {})), peers=False)
    assert rows
    assert all(row.ours.slowest > 0 and row.ours.fastest > 0 and row.theirs is None for row in rows)


def test_there_are_the_subjects_that_the_page_tells_of() -> None:
    page = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    assert [name for name in names() if f"`{name}`" not in page] == []


def test_a_generated_text_is_a_program_without_mistakes_and_the_same_for_the_same_seed() -> None:
    text = text_of_lines(300)
    assert text.count("\n") >= 300
    assert text == text_of_lines(300)
    assert parse(text).diagnostics == []


@pytest.mark.parametrize("vertices", [3, 50, 777])
def test_a_generated_graph_has_as_many_vertices_as_asked_for_and_compiles(vertices: int) -> None:
    graph = graph_of(tree_of_vertices(vertices))
    assert len(graph.vertices) == vertices
    assert compile_program(graph, catalogue()).ok


def test_blockly_gets_a_block_for_each_vertex_but_start_and_stop() -> None:
    tree, robot = tree_of_vertices(400), catalogue().robot(ROBOT)
    state, blocks = blockly.workspace(tree, robot)
    assert blocks == 398
    assert json.dumps(state).count('"type"') == blocks
    own = {block["type"] for block in blockly.definitions(robot, tree)}
    assert {node.object + "." + node.method for node in nodes(tree) if isinstance(node, Call)} <= own


def test_lark_reads_the_whole_language_with_the_grammar_it_is_given() -> None:
    lark, robot = lark_parser.LarkParser(), catalogue().robot(ROBOT)
    for seed in range(60):
        text = print_program(random_program(random.Random(seed), robot, Shape(comments=True)))
        ours = sum(isinstance(node, Call) for node in nodes(parse(text).program))
        assert lark_parser.calls(lark.parse(text)) == ours


def test_a_behaviour_tree_goes_through_the_loop() -> None:
    behaviour_tree.run(laps=2, until=5)  # it looks at what came of it


def test_work_is_done_in_turns_and_the_first_round_does_not_count() -> None:
    done: list[str] = []
    seconds = in_turns({"a": lambda: done.append("a"), "b": lambda: done.append("b")}, 2)
    assert done == ["a", "b"] * 3
    assert {name: len(taken) for name, taken in seconds.items()} == {"a": 2, "b": 2}


def test_a_ratio_says_how_many_times_as_fast_we_are() -> None:
    slow, fast = Rate.of(10, [1.0, 2.0, 5.0]), Rate.of(10, [0.5])
    assert (slow.median, slow.slowest, slow.fastest) == (5, 2, 10)
    assert Row("trips", "trips/s", fast, "peer", slow).ratio == 4
    assert Row("time", "ms", slow, "peer", fast, lower_is_better=True).ratio == 4
    assert Row("alone", "trips/s", fast).ratio is None
    assert "4.00×" in table({"subject": [Row("trips", "trips/s", fast, "peer", slow), Row("alone", "ms", slow)]})


def test_the_command_prints_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--tiny", "--no-peers", "--json", "parsing"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert {row["subject"] for row in printed["rows"]} == {"parsing"}


def test_an_unknown_subject_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["speed"])
    assert "there is no subject 'speed'" in capsys.readouterr().err


def test_the_lock_of_the_peers_names_no_host_and_has_a_checksum_for_every_package() -> None:
    folder = ROOT / "benchmarks"
    packages = json.loads((folder / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    package = json.loads((folder / "package.json").read_text(encoding="utf-8"))
    assert packages[""]["dependencies"] == package["dependencies"]
    assert [place for place, entry in packages.items() if "resolved" in entry] == []
    assert [place for place, entry in packages.items() if place and not entry.get("integrity")] == []
