"""Round trips of random programs: LLL ↔ text, LLL ↔ graph, image ↔ bytes, image ↔ listing."""

from __future__ import annotations

import os
import random
import re
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_lll
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import Program
from kitrobot.image.listing import assemble, disassemble
from kitrobot.image.model import Image
from kitrobot.lll.formatter import format_text
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Instruction, Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.robot import Robot
from tests.effort import examples
from tests.patience import PATIENCE_S
from tests.strategies import Shape, random_program, random_robot, shipped_robots

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "200"))


def program_and_robot(rng: random.Random, *, comments: bool) -> tuple[Seq, Robot]:
    if type(rng) is not random.Random:
        # Small, for the paper's robot: what Hypothesis can draw fast and make smaller.
        robot = shipped_robots()["mini-robot"]
        return random_program(rng, robot, Shape(8, 4, comments=comments)), robot
    robot = rng.choice([*shipped_robots().values(), random_robot(rng)])
    shape = Shape(rng.choice((3, 10, 25, 60)), rng.choice((3, 6, 12)), comments=comments)
    return random_program(rng, robot, shape), robot


def catalogue_with(robot: Robot) -> Catalogue:
    catalogue = load_catalogue()
    return replace(catalogue, robots={**catalogue.robots, robot.name: robot})


def comments_of(program: Seq) -> list[str]:
    found = list(program.below)
    for node in nodes(program):
        if isinstance(node, Seq) and node is not program:
            found += node.below
        elif isinstance(node, Instruction):
            found += node.above
            found += [node.after] if node.after is not None else []
    return sorted(found)


def untidy(rng: random.Random, text: str) -> str:
    """The same program (without comments) with other white space, and without the semicolons that may be left out."""
    text = re.sub(r";(?=\s*([,)]|$))", lambda _: rng.choice((";", "", ";;")), text)
    text = text.replace("°", rng.choice("°º˚"))
    return re.sub(r"\s+|(?<=[;,(){}<>&|!*°])", lambda _: rng.choice(("", " ", "\n", "\t  ", "\r\n")), text)


# ---- the properties -------------------------------------------------------------------------------------


def printing_and_parsing(rng: random.Random) -> None:
    program, _ = program_and_robot(rng, comments=True)
    text = print_program(program)
    parsed = parse(text)
    assert parsed.diagnostics == []
    assert parsed.program == program
    assert print_program(parsed.program) == text


def formatting(rng: random.Random) -> None:
    program, _ = program_and_robot(rng, comments=True)
    text = print_program(program)
    once, _ = format_text(text)
    assert once == text
    assert format_text(re.sub(r"(?m)^ +", "", text)) == (text, [])
    kept = parse(re.sub(r";\n +", ";", text))
    assert comments_of(kept.program) == comments_of(program)


def untidy_text(rng: random.Random) -> None:
    program, _ = program_and_robot(rng, comments=False)
    text = print_program(program)
    formatted, problems = format_text(untidy(rng, text))
    assert (formatted, problems) == (text, [])


def lll_graph_lll(rng: random.Random) -> None:
    program, robot = program_and_robot(rng, comments=True)
    catalogue = catalogue_with(robot)
    graph = lll_to_graph(program, robot, catalogue, "p")
    back = graph_to_lll(graph, catalogue)
    assert back.diagnostics == []
    assert back.program == program


def graph_lll_graph(rng: random.Random) -> None:
    program, robot = program_and_robot(rng, comments=True)
    catalogue = catalogue_with(robot)
    graph = lll_to_graph(program, robot, catalogue, "p")
    text = print_program(graph_to_lll(graph, catalogue).program)
    assert lll_to_graph(parse(text).program, robot, catalogue, "p") == graph


def graph_in_any_order(rng: random.Random) -> None:
    program, robot = program_and_robot(rng, comments=True)
    catalogue = catalogue_with(robot)
    graph = lll_to_graph(program, robot, catalogue, "p")
    back = graph_to_lll(disordered(rng, graph), catalogue)
    assert back.diagnostics == []
    assert back.program == program


def disordered(rng: random.Random, graph: Program) -> Program:
    """The same graph with other names for its vertices, and everything in another order."""
    numbers = list(range(len(graph.vertices)))
    rng.shuffle(numbers)
    names = {vertex.id: f"w{number}" for vertex, number in zip(graph.vertices, numbers, strict=True)}
    vertices = [replace(vertex, id=names[vertex.id]) for vertex in graph.vertices]
    arcs = [replace(arc, source=names[arc.source], target=names[arc.target]) for arc in graph.arcs]
    rng.shuffle(vertices)
    rng.shuffle(arcs)
    return replace(graph, vertices=vertices, arcs=arcs)


def image_file_and_listing(rng: random.Random) -> None:
    program, robot = program_and_robot(rng, comments=False)
    compiled = compile_lll(program, robot)
    if compiled.image is None:
        assert {item.code for item in compiled.diagnostics if item.is_error} == {"too-large"}
        return
    data = compiled.image.to_bytes()
    assert Image.from_bytes(data) == compiled.image
    assert Image.from_bytes(data).to_bytes() == data
    assert assemble(disassemble(compiled.image)).to_bytes() == data


def comments_and_layout_do_not_change_the_image(rng: random.Random) -> None:
    program, robot = program_and_robot(rng, comments=True)
    tidy = compile_lll(program, robot)
    bare = re.sub(r"[ \t]*#[^\n]*", "", print_program(program))
    other = compile_lll(parse(untidy(rng, bare)).program, robot)
    assert (tidy.image and tidy.image.to_bytes()) == (other.image and other.image.to_bytes())


PROPERTIES = [
    printing_and_parsing,
    formatting,
    untidy_text,
    lll_graph_lll,
    graph_lll_graph,
    graph_in_any_order,
    image_file_and_listing,
    comments_and_layout_do_not_change_the_image,
]


@pytest.mark.timeout(0 if BUDGET > 1000 else PATIENCE_S)
@pytest.mark.parametrize("holds", PROPERTIES, ids=lambda holds: holds.__name__)
def test_round_trip_of_many_programs(holds: object) -> None:
    assert callable(holds)
    for seed in range(BUDGET // 4):
        try:
            holds(random.Random(seed))
        except AssertionError as error:
            raise AssertionError(f"seed {seed}") from error


@pytest.mark.parametrize("holds", PROPERTIES, ids=lambda holds: holds.__name__)
@given(rng=st.randoms(note_method_calls=False))
@settings(max_examples=examples(5))
def test_round_trip_of_small_programs(holds: object, rng: random.Random) -> None:
    assert callable(holds)
    holds(rng)
