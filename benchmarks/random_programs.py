"""Random programs for benchmarks, made from a seed and shaped like what people write, for the shipped mini-robot.

A program is a row of *tasks*: a few calls, loops around them, choices inside, now and then branches side by side, with
a comment above. The same seed gives the same program.
"""

from __future__ import annotations

import random
from functools import cache

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import Program
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Not,
    Number,
    Or,
    Parallel,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue, load_catalogue

ROBOT = "mini-robot"
_COMMENTS = ("go round the table", "slowly here", "wait for the others", "look first, then turn", "home again")
_DEEPEST = 4


@cache
def catalogue() -> Catalogue:
    """What ships with us."""
    return load_catalogue()


def text_of_lines(lines: int, seed: int = 1) -> str:
    """An LLL text of at least that many lines, with everything the language has."""
    maker = _Maker(random.Random(seed), parallels=True)
    chunks: list[str] = []
    count = 0
    while count < lines:
        chunk = print_program(Seq([maker.task()]))
        chunks.append(chunk)
        count += chunk.count("\n")
    return "".join(chunks)


def tree_of_vertices(vertices: int, seed: int = 1) -> Seq:
    """A program whose graph has exactly that many vertices, Start and Stop included; no parallels."""
    maker = _Maker(random.Random(seed), parallels=False)
    seq = Seq()
    left = vertices - 2
    while left > 0:
        task = maker.task()
        size = _vertices(task)
        if size > left:
            task, size = _call("Wheel", "Stop"), 1
        seq.items.append(task)
        left -= size
    return seq


def graph_of(tree: Seq) -> Program:
    """The graph of a program."""
    robot = catalogue().robot(ROBOT)
    return lll_to_graph(tree, robot, catalogue(), "measured")


def _vertices(node: Instr) -> int:
    return sum(not isinstance(part, (Seq, Number)) for part in nodes(node))


def _call(name: str, method: str, *numbers: int) -> Call:
    return Call(name, method, [Number(number) for number in numbers])


class _Maker:
    def __init__(self, rng: random.Random, *, parallels: bool) -> None:
        self.rng = rng
        self.parallels = parallels

    def task(self) -> Instr:
        """Something as large as what people draw on one screen."""
        node = self.rng.choices((self.repeat, self.loop, self.choice, self.event), (4, 3, 3, 1))[0](1)
        node.above = [self.rng.choice(_COMMENTS)]
        return node

    def body(self, depth: int, *, in_loop: bool) -> Seq:
        items = [self.instruction(depth) for _ in range(self.rng.choice((1, 2, 2, 3, 4, 5)))]
        if in_loop and self.rng.random() < 0.1:
            items.append(Break())
        return Seq(items)

    def instruction(self, depth: int) -> Instr:
        nested = depth < _DEEPEST and self.rng.random() < 0.35
        if not nested:
            node: Instr = Wait(10 * self.rng.randint(1, 9)) if self.rng.random() < 0.12 else self.call()
            if self.rng.random() < 0.06:
                node.after = self.rng.choice(_COMMENTS)
            return node
        makers = (self.repeat, self.loop, self.choice, self.event, self.parallel)
        return self.rng.choices(makers, (3, 3, 4, 1, 1 if self.parallels else 0))[0](depth + 1)

    def call(self) -> Call:
        rng = self.rng
        kind = rng.randrange(9)
        if kind < 3:
            return _call("Wheel", rng.choice(("Advance", "Reverse")), 10 * rng.randint(0, 10))
        if kind == 3:
            return _call("Motor", "AbsoluteTurn", 25 * rng.randint(0, 4), 50)
        if kind == 4:
            return _call(
                *rng.choice((("Light", "LightOn"), ("Light", "LightOff"), ("Door", "Open"), ("Wheel", "Stop")))
            )
        if kind == 5:
            return Call("Level", "Set", [Call("Captor", "Value")])
        if kind == 6:
            return _call("Count", rng.choice(("Add", "Sub")), rng.randint(1, 3))
        if kind == 7:
            return _call("Run", "Set", rng.randint(0, 1))
        return _call("Motor", "Turn", 10 * rng.randint(0, 10))

    def test(self) -> Call:
        rng = self.rng
        kind = rng.randrange(5)
        if kind < 2:
            return _call("Captor", rng.choice(("LessThan", "GreaterThan")), 10 * rng.randint(0, 10))
        if kind == 2:
            return _call("Button", rng.choice(("IsPressed", "IsReleased")))
        if kind == 3:
            return _call("Light", rng.choice(("IsRed", "IsGreen", "IsBlue")))
        return _call("Count", "EqualTo", 10 * rng.randint(0, 10))

    def condition(self) -> Condition:
        chance = self.rng.random()
        if chance < 0.1:
            return And(self.test(), self.test())
        if chance < 0.2:
            return Or(self.test(), And(self.test(), self.test()))
        if chance < 0.3:
            # Not alone: under it a test and its instruction may be one part of the graph.
            return And(Not(self.test()), self.test())
        return self.test()

    def repeat(self, depth: int) -> Instr:
        return Repeat(self.rng.randint(2, 20), self.body(depth, in_loop=True))

    def loop(self, depth: int) -> Instr:
        return While(self.condition(), self.body(depth, in_loop=True))

    def choice(self, depth: int) -> Instr:
        orelse = self.body(depth, in_loop=False) if self.rng.random() < 0.4 else None
        return Conditional(self.condition(), self.body(depth, in_loop=False), orelse)

    def event(self, depth: int) -> Instr:
        return Event(self.condition(), self.body(depth, in_loop=False))

    def parallel(self, depth: int) -> Instr:
        branches = [self.body(depth, in_loop=False) for _ in range(self.rng.randint(2, 3))]
        branches[-1].items.append(Interrupt(_call("Wheel", "Advance", 50)))
        return Parallel(branches)
