"""Every node knows its place: in the text that was read, and in the text that was printed."""

from __future__ import annotations

import random

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.lll.parse_results import parse, parse_template
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import And, Call, Conditional, Instruction, Interrupt, Node, Not, Number, Or, Seq, While
from kitrobot.lll.walk import nodes
from tests.strategies import Shape, random_program, shipped_robots


def reads_as(text: str) -> Node:
    """The node that a stretch of text is: one instruction, a condition, or a number."""
    if text.isdigit():
        return Number(int(text))
    if (tree := parse_template(text)[0]) is not None:
        return tree
    raise AssertionError(text)


def without_comments(node: Node) -> Node:
    for one in nodes(node):
        if isinstance(one, Instruction):
            one.above, one.after = [], None
        if isinstance(one, Seq):
            one.below = []
    return node


def has_right_places(text: str, program: Seq) -> None:
    for node in nodes(program):
        assert 0 <= node.start <= node.end <= len(text)
        shown = text[node.start : node.end]
        if isinstance(node, Seq):
            again: Node = parse(shown).program
        elif isinstance(node, And | Or | Not):
            (loop,) = parse(f"[{shown}]();").program.items
            assert isinstance(loop, Conditional)
            again = loop.condition
        else:
            again = reads_as(shown)
        assert without_comments(again) == without_comments(node), shown
        if isinstance(node, Call):
            assert text[node.method_start :].startswith(node.method)


@given(st.randoms(use_true_random=True))
def test_a_node_s_place_in_a_printed_text_reads_as_the_node(rng: random.Random) -> None:
    robot = rng.choice([*shipped_robots().values()])
    program = random_program(rng, robot, Shape(instructions=12, comments=rng.random() < 0.3))
    # Printing sets places, and a node that stands twice in a tree can have only one.
    program = parse(print_program(program)).program
    text = print_program(program)
    has_right_places(text, program)


@given(st.randoms(use_true_random=True))
def test_a_node_s_place_in_a_text_that_was_read_reads_as_the_node(rng: random.Random) -> None:
    robot = rng.choice([*shipped_robots().values()])
    words = print_program(random_program(rng, robot, Shape(instructions=12)))
    text = "".join(one + rng.choice(("", "", " ", "\n\t")) if one in ";,<>&|!" else one for one in words)
    parsed = parse(text)
    assert parsed.ok
    has_right_places(text, parsed.program)


def test_an_instruction_s_place_leaves_out_its_separator_and_its_comments() -> None:
    text = "# why\na.b(1) ;  # how\n"
    (node,) = parse(text).program.items
    assert text[node.start : node.end] == "a.b(1)"


def test_the_place_of_joined_tests_leaves_out_the_parentheses_around_them() -> None:
    text = "*[ (a.b() | c.d()) & e.f() ]();"
    (loop,) = parse(text).program.items
    assert isinstance(loop, While)
    assert isinstance(loop.condition, And)
    assert text[loop.condition.left.start : loop.condition.left.end] == "a.b() | c.d()"


def test_the_whole_text_is_the_place_of_the_program() -> None:
    text = "\n a.b();\n "
    program = parse(text).program
    assert (program.start, program.end) == (0, len(text))


def test_a_marked_call_lies_inside_its_marks() -> None:
    text = "//(° a.b() °);"
    interrupt = next(node for node in nodes(parse(text).program) if isinstance(node, Interrupt))
    assert text[interrupt.start : interrupt.end] == "° a.b() °"
    assert text[interrupt.call.start : interrupt.call.end] == "a.b()"
