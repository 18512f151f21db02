"""Behaviour trees and programs mean the same: random trees and programs, and files that public projects could have."""

from __future__ import annotations

import collections
import random
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
PROGRAMS = {
    "gate": "[!(Captor.GreaterThan(40))]( Door.Open(); );\nWheel.DriveBy(25);\nDoor.Close();\n",
    "rounds": "Count.Set(0);\n2*(\n  Wheel.DriveBy(30);\n  Motor.LeftBy(90);\n  Wheel.DriveBy(20);\n  Motor.LeftBy(90);\n"
    "  Count.Add(1);\n);\n//(\n  Light.LightOn();\n  WAIT(4);\n  Light.LightOff();,\n  WAIT(2);\n  Motor.LeftBy(180);\n);\n",
    "supply": "Level.Set(60);\n*[Level.GreaterThan(20)](\n  [Button.IsPressed()](\n    Switch.SwitchOn();\n  )!(\n"
    "    [!(Light.IsGreen())](\n      Switch.SwitchOff();\n    )!(\n      Light.LightOn();\n    );\n  );\n"
    "  Level.Sub(15);\n  WAIT(1);\n);\n[Level.LessThan(20)]( Level.Set(100); )!();\n",
}


class TreeMaker(Maker):
    """Makes programs that a tree can say."""

    def marked(self, *_: object) -> Instr:
        return self.action()

    def observe(self, *_: object) -> Instr:
        return self.action()

    def leave(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        return Break() if in_loop else self.wait()


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_file_becomes_its_program(name: str) -> None:
    file, found = read_trees((TREES / f"{name}.xml").read_bytes(), f"{name}.xml")
    assert (file is None, found) == (False, [])
    assert file is not None
    program, refused = tree_to_lll(file, ROBOT)
    assert refused == []
    assert print_program(program) == PROGRAMS[name]


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
            by_tree, tree_ended = events_of(lambda record, root=root: run_tree(root, record), answers)
            by_program, ended = events_of(lambda record, program=program: run_program(program, record), answers)
            if tree_ended and ended:
                assert by_tree == by_program, seed
            else:
                common = min(len(by_tree), len(by_program))
                assert by_tree[:common] == by_program[:common], seed
    assert min(taken.values()) > 50, taken
