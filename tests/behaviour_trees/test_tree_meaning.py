"""Behaviour trees and programs mean the same: random trees and programs, and files that public projects could have."""

from __future__ import annotations

import collections
import random
import re
from functools import partial
from pathlib import Path

import pytest

from kitrobot.behaviour_trees.lll_to_tree import lll_to_tree
from kitrobot.behaviour_trees.model import TreeFile
from kitrobot.behaviour_trees.tree_to_lll import tree_to_lll
from kitrobot.behaviour_trees.tree_writer import write_tree
from kitrobot.behaviour_trees.tree_xml import read_trees
from kitrobot.compiler.compilation import compile_lll
from kitrobot.diagnostics.model import Source
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Break, Instr, Seq
from kitrobot.primitives.catalogue import load_catalogue
from tests.behaviour_trees.meaning import events_of, random_tree, run_program, run_tree
from tests.effort import cases
from tests.strategies import Shape
from tests.strategies.programs import Maker

ROBOT = load_catalogue([]).robots["mini-robot"]
TREES = Path(__file__).parent / "trees"
DOCUMENT = Path(__file__).parents[2] / "docs" / "behaviour-trees.md"


class TreeMaker(Maker):
    """Makes programs that a tree can say."""

    def marked(self, *_: object) -> Instr:
        return self.action()

    def observe(self, *_: object) -> Instr:
        return self.action()

    def leave(self, *where: object) -> Instr:
        _, in_loop, _ = where
        return Break() if in_loop else self.wait()


def program_of(data: bytes) -> str:
    file, found = read_trees(data, "tree.xml")
    assert file is not None, found
    program, found = tree_to_lll(file, ROBOT)
    assert found == []
    return print_program(program)


@pytest.mark.parametrize("name", ["gate", "rounds", "supply"])
def test_a_file_becomes_its_program(name: str) -> None:
    assert program_of((TREES / f"{name}.xml").read_bytes()) == (TREES / f"{name}.lll").read_text()


def test_the_tree_of_the_document_is_the_program_below_it() -> None:
    tree, program = re.findall(r"```(?:xml|lll)\n(.*?)```", DOCUMENT.read_text(), re.DOTALL)
    assert program_of(tree.encode()) == program


@pytest.mark.parametrize("start", cases(range(0, 200, 100), range(200, 2000, 100)))
def test_a_program_becomes_a_tree_and_comes_back_with_the_same_image(start: int) -> None:
    for seed in range(start, start + 100):
        program = TreeMaker(random.Random(seed), ROBOT, Shape()).program()
        root, found = lll_to_tree(program, ROBOT, Source("p.lll", print_program(program)))
        assert found == [], seed
        file, found = read_trees(write_tree(root, "main", ROBOT).encode(), "t.xml")
        assert file is not None, (seed, found)
        assert file.trees["main"] == root, "what is written is what is read"
        again, found = tree_to_lll(file, ROBOT)
        assert found == [], seed
        assert compile_lll(again, ROBOT).image == compile_lll(program, ROBOT).image, seed
        assert lll_to_tree(again, ROBOT, Source("p.lll", print_program(again)))[0] == root, "the same tree"


@pytest.mark.parametrize("start", cases(range(0, 1500, 500), range(1500, 20000, 500)))
def test_a_tree_that_is_taken_calls_and_asks_what_its_program_does(start: int) -> None:
    taken = collections.Counter[bool]()
    for seed in range(start, start + 500):
        root = random_tree(random.Random(seed))
        program, found = tree_to_lll(TreeFile({"main": root}, "main"), ROBOT)
        taken[not found] += 1
        if found:
            assert program == Seq(), seed
            continue
        for answers in range(3):
            by_tree, tree_ended = events_of(partial(run_tree, root), answers)
            by_program, ended = events_of(partial(run_program, program), answers)
            if tree_ended and ended:
                assert by_tree == by_program, seed
            else:
                common = min(len(by_tree), len(by_program))
                assert by_tree[:common] == by_program[:common], seed
    assert min(taken.values()) > 50, taken
