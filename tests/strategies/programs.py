"""Random well-typed LLL programs over a robot.

`random_program` draws from a `random.Random`-like source only, so the same source state gives the same program. The
programs are biased to where mistakes hide: parallels in parallels, marks in every arrangement (no branch, one, all),
loops whose pass blocks on some ways only, BREAK in all places, small waits, one favoured actuator that is driven from
many branches. Numbers are taken near the limits of what they are compared with or clamped to.

What is left out: what the checker calls an error (a test where a value is needed, a literal outside its range).
"""

from __future__ import annotations

import copy
import random
from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.lll.tree import (
    MAX_NUMBER,
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
    Param,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.primitives.robot import Category, Kind, Method, Parameter, Robot, RobotObject, ValueType

Meaning = tuple[RobotObject, Method]
Making = Callable[[int, bool, bool], Instr]


@dataclass(frozen=True)
class Shape:
    """How large a program may be. `comments`: whether it carries comments, for tests of text."""

    instructions: int = 25
    depth: int = 6
    comments: bool = False


def random_program(rng: random.Random, robot: Robot, shape: Shape | None = None) -> Seq:
    """A well-typed program for the robot."""
    return Maker(rng, robot, shape or Shape()).program()


class Maker:
    def __init__(self, rng: random.Random, robot: Robot, shape: Shape) -> None:
        self.rng = rng
        self.shape = shape
        self.left = rng.randint(1, shape.instructions)
        calls = list(robot.calls.values())
        self.tests = [call for call in calls if call[1].kind is Kind.TEST]
        self.values = [call for call in calls if call[1].kind is Kind.VALUE]
        procedures = [call for call in calls if call[1].kind is Kind.PROCEDURE and self.can_be_written(call)]
        self.devices = [call for call in procedures if call[0].category is Category.ACTUATOR]
        self.changes = [call for call in procedures if call[0].category is not Category.ACTUATOR]
        self.favourite = rng.choice(self.devices)[0] if self.devices and rng.random() < 0.6 else None

    def program(self) -> Seq:
        seq = Seq()
        while self.left > 0:
            seq.items += self.seq(0, in_loop=False, in_parallel=False, least=1).items
        if self.rng.random() < 0.3:
            return Seq([While(self.always() if self.rng.random() < 0.7 else None, seq)])
        return seq

    # ---- bodies -----------------------------------------------------------------------------------------

    def seq(self, depth: int, *, in_loop: bool, in_parallel: bool, least: int) -> Seq:
        length = max(least, self.rng.choice((0, 1, 1, 1, 2, 2, 3, 4)))
        items = [self.instruction(depth, in_loop, in_parallel) for _ in range(length)]
        seq = Seq(items)
        if self.shape.comments and self.rng.random() < 0.15:
            seq.below = self.some_comments()
        return seq

    def instruction(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        self.left -= 1
        nested = 3 if depth < self.shape.depth and self.left > 0 else 0
        makers: dict[Making, float] = {
            self.action: 7,
            self.marked: 4 if in_parallel else 0.4,
            self.wait: 4,
            self.leave: 3 if in_loop else 1 if in_parallel else 0.1,
            self.observe: 0.2,
            self.repeat: nested,
            self.loop: nested,
            self.choice: nested,
            self.event: nested * 0.7,
            self.parallel: nested * 1.5,
            **self.more_makers(nested),
        }
        node = self.rng.choices(list(makers), list(makers.values()))[0](depth + 1, in_loop, in_parallel)
        if self.shape.comments:
            if self.rng.random() < 0.1:
                node.above = self.some_comments()
            if self.rng.random() < 0.1:
                node.after = self.some_comments()[0]
        return node

    def more_makers(self, nested: float) -> dict[Making, float]:
        """What else an instruction may be, and how often."""
        return {}

    def action(self, *_: object) -> Instr:
        if not self.devices or (self.changes and self.rng.random() < 0.4):
            return self.call(self.rng.choice(self.changes))
        favoured = [call for call in self.devices if call[0] is self.favourite]
        return self.call(self.rng.choice(favoured if favoured and self.rng.random() < 0.7 else self.devices))

    def marked(self, *_: object) -> Instr:
        call = self.action()
        assert isinstance(call, Call)
        return Interrupt(call)

    def observe(self, *_: object) -> Instr:
        return self.call(self.rng.choice(self.tests + self.values))

    def wait(self, *_: object) -> Instr:
        return Wait(self.rng.choice((0, 0, 1, 1, 1, 2, 3)))

    def leave(self, *_: object) -> Instr:
        return Break()

    def repeat(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        count = self.rng.choice((0, 1, 1, 2, 2, 3, 4))
        return Repeat(count, self.seq(depth, in_loop=True, in_parallel=in_parallel, least=0))

    def loop(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        kind = self.rng.random()
        condition = None if kind < 0.2 else self.always() if kind < 0.5 else self.condition(depth)
        return While(condition, self.seq(depth, in_loop=True, in_parallel=in_parallel, least=0))

    def choice(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        condition = self.condition(depth)
        then = self.seq(depth, in_loop=in_loop, in_parallel=in_parallel, least=0)
        orelse = None
        if self.rng.random() < 0.6:
            orelse = self.seq(depth, in_loop=in_loop, in_parallel=in_parallel, least=0)
        return Conditional(condition, then, orelse)

    def event(self, depth: int, in_loop: bool, in_parallel: bool) -> Instr:
        return Event(self.condition(depth), self.seq(depth, in_loop=in_loop, in_parallel=in_parallel, least=0))

    def parallel(self, depth: int, *_: object) -> Instr:
        count = self.rng.choice((0, 1, 1, 2, 2, 2, 2, 3, 3, 4))
        branches = [self.seq(depth, in_loop=False, in_parallel=True, least=1) for _ in range(count)]
        for branch in self.rng.choice(([], branches[:1], branches[-1:], branches, branches)):
            branch.items.insert(self.rng.randint(0, len(branch.items)), self.marked())
        return Parallel(branches)

    def always(self) -> Condition:
        """A condition that holds, which the compiler cannot know: otherwise most programs would end at once."""
        test = self.rng.choice(self.tests)
        return Or(raised := self.call(test), Not(copy.deepcopy(raised)))

    # ---- calls ------------------------------------------------------------------------------------------

    def condition(self, depth: int) -> Condition:
        if depth < self.shape.depth and self.rng.random() < 0.25:
            kind = self.rng.choice((And, Or, None))
            if kind is None:
                return Not(self.condition(depth + 1))
            return kind(self.condition(depth + 1), self.condition(depth + 1))
        return self.call(self.rng.choice(self.tests))

    def call(self, what: Meaning, nesting: int = 0) -> Call:
        part, method = what
        return Call(part.name, method.name, [self.param(what, given, nesting) for given in method.parameters])

    def can_be_written(self, what: Meaning) -> bool:
        """Numbers in a program have no sign: for a range below 0 there must be a value to give."""
        return bool(self.values) or all(given.maximum >= 0 for given in what[1].parameters)

    def param(self, what: Meaning, parameter: Parameter, nesting: int) -> Param:
        wanted = self.tests if parameter.type is ValueType.BOOLEAN else self.values
        if wanted and ((nesting < 3 and self.rng.random() < 0.3) or self.only_negative(what, parameter)):
            return self.call(self.rng.choice(wanted), nesting + 1)
        numbers = near(self.rng, parameter.minimum, parameter.maximum)
        if what[1].kind is Kind.TEST:
            # What a test compares with is usually near the range of the object it looks at, and may be anything.
            numbers = [*near(self.rng, what[0].minimum, what[0].maximum), self.rng.choice((0, MAX_NUMBER))]
        written = [number for number in numbers if 0 <= number <= MAX_NUMBER]
        return Number(self.rng.choice(written or [min(max(parameter.maximum, 0), MAX_NUMBER)]))

    def only_negative(self, what: Meaning, parameter: Parameter) -> bool:
        return parameter.maximum < 0 and what[1].kind is not Kind.TEST

    def some_comments(self) -> list[str]:
        words = ("", "slowly", "# twice", "wait; then go(", " indented", "Größe °", "WAIT(1)", "a, b")
        return [self.rng.choice(words) for _ in range(self.rng.choice((1, 1, 2)))]


def near(rng: random.Random, minimum: int, maximum: int) -> list[int]:
    """Some numbers of a range: its ends, their neighbours, the middle, any."""
    ends = [minimum, minimum + 1, (minimum + maximum) // 2, maximum - 1, maximum, rng.randint(minimum, maximum)]
    return [number for number in ends if minimum <= number <= maximum]
