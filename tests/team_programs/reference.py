"""What a team's program means, said directly: the oracle of projection.

Robots are names; each has a counter of its own, and nothing else is asked about. A program is done by all at once: for
each robot the numbers of the lines that it does, in order, and which lines are over before which begin.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field

from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Joint,
    Members,
    Move,
    Not,
    Number,
    Or,
    Parallel,
    ParOfSeq,
    ProgramCall,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    Where,
    While,
)
from kitrobot.lll.walk import nodes

MOST_LINES = 3000


class TooLong(Exception):
    """The program goes on for longer than a test waits."""


class _Left(Exception):
    """A BREAK."""


@dataclass
class Meaning:
    """The run of a team's program.

    Attributes:
        lines: of each robot, the numbers of the lines that it does.
        before: of each moment at which some wait for others, how many lines each of those has done.
        left: of each work, how many units are not done.
    """

    roles: Mapping[str, str]
    declared: Mapping[str, list[str]]
    programs: Mapping[str, Seq]
    groups: dict[str, set[str]] = field(default_factory=dict)
    lines: dict[str, list[int]] = field(default_factory=dict)
    before: list[dict[str, int]] = field(default_factory=list)
    counters: dict[str, int] = field(default_factory=dict)
    left: dict[str, int] = field(default_factory=dict)
    held: set[tuple[str, str]] = field(default_factory=set)
    steps: int = 0

    def __post_init__(self) -> None:
        for name in self.roles:
            self.lines[name], self.counters[name] = [], 0
        for group, names in self.declared.items():
            own = {name for name in names if name == group or name not in self.declared}
            self.groups[group] = {name for name, role in self.roles.items() if name in own or role in own}

    def who(self, members: object) -> list[str]:
        assert isinstance(members, Members)
        return [name for name in self.roles if any(self.is_in(name, one) for one in members.names)]

    def is_in(self, robot: str, name: str) -> bool:
        """Whether a robot is that one, plays that role, or is in that group or one in it."""
        if name not in self.declared:
            return name in (robot, self.roles[robot])
        return robot in self.groups[name] or any(
            self.is_in(robot, inner) for inner in self.declared[name] if inner in self.declared and inner != name
        )

    def meet(self, robots: list[str]) -> None:
        self.before.append({name: len(self.lines[name]) for name in robots})

    def seq(self, seq: Seq, robots: list[str], lockstep: bool = False) -> None:
        for node in seq.items:
            self.instruction(node, robots, lockstep)

    def instruction(self, node: Instr, robots: list[str], lockstep: bool) -> None:
        self.steps += 1
        if self.steps > MOST_LINES:
            raise TooLong
        match node:
            case SeqOfPar():
                self.seq(node.body, self.who(node.members), lockstep=True)
                self.meet(robots)
            case ParOfSeq() | Where():
                for name in self.who(node.members):
                    self.alone(node, name)
                self.meet(robots)
            case Parallel() if not lockstep or self.inside(node):
                for branch in node.branches:
                    # Whoever is in a branch is in no other: one after another is the same as at the same time.
                    inside = self.inside(branch)
                    with suppress(_Left):
                        self.seq(branch, [name for name in robots if name in inside])
                self.meet(robots)
            case While() | Conditional() if lockstep and self.is_own(node.condition):
                for name in robots:
                    self.each(Seq([node]), name)
                self.meet(robots)
            case Repeat():
                assert isinstance(node.count, int)
                self.loop(iter([True] * node.count + [False]).__next__, node.body, robots, lockstep)
            case While(condition=None):
                self.loop(lambda: True, node.body, robots, lockstep)
            case While(condition=condition):
                assert condition is not None
                asked = condition
                self.loop(lambda: self.holds(asked, robots), node.body, robots, lockstep)
            case Conditional():
                body = node.then if self.holds(node.condition, robots) else node.orelse
                if body is not None:
                    self.seq(body, robots, lockstep)
            case Event():
                if not self.holds(node.condition, robots):
                    raise TooLong  # nothing else changes a counter of those who wait
                self.seq(node.body, robots, lockstep)
            case Move():
                assert isinstance(node.source, str)
                assert isinstance(node.target, str)
                assert isinstance(node.count, int)
                self.meet(robots)
                going = [name for name in self.roles if self.is_in(name, node.source)][: node.count]
                for group in (node.source, *self.declared[node.source]):
                    if group in self.groups:
                        self.groups[group] -= set(going)
                self.groups[node.target] |= set(going)
            case Break():
                raise _Left
            case ProgramCall():
                assert isinstance(node.name, str)
                self.seq(self.programs[node.name], robots, lockstep)
            case _:
                for name in robots:
                    self.line(node, name)
                if lockstep:
                    self.meet(robots)

    def is_own(self, condition: Condition | None) -> bool:
        return isinstance(condition, Call) and condition.object not in self.left

    def loop(self, again: Callable[[], bool], body: Seq, robots: list[str], lockstep: bool) -> None:
        try:
            while again():
                self.steps += 1
                self.seq(body, robots, lockstep)
                if self.steps > MOST_LINES:
                    raise TooLong
        except _Left:
            pass

    def inside(self, seq: Seq | Parallel) -> set[str]:
        return {
            name
            for node in nodes(seq)
            if isinstance(node, SeqOfPar | ParOfSeq | Where)
            for name in self.who(node.members)
        }

    def alone(self, node: ParOfSeq | Where, name: str) -> None:
        if isinstance(node, ParOfSeq):
            self.each(node.body, name)
        elif self.one_holds(node.condition, name):
            self.each(node.then, name)
        elif node.orelse is not None:
            self.each(node.orelse, name)

    def each(self, seq: Seq, name: str) -> None:
        for node in seq.items:
            self.steps += 1
            match node:
                case Conditional():
                    body = node.then if self.one_holds(node.condition, name) else node.orelse
                    if body is not None:
                        self.each(body, name)
                case Repeat():
                    assert isinstance(node.count, int)
                    for _ in range(node.count):
                        self.each(node.body, name)
                case While():
                    assert node.condition is not None
                    while self.one_holds(node.condition, name):
                        self.each(node.body, name)
                case ProgramCall():
                    assert isinstance(node.name, str)
                    self.each(self.programs[node.name], name)
                case _:
                    self.line(node, name)

    def line(self, node: Instr, name: str) -> None:
        match node:
            case Call(object="Arm", params=[Number(value=number)]):
                self.lines[name].append(number)
            case Call(object="Count", method="Add", params=[Number(value=number)]):
                self.counters[name] = min(1000, self.counters[name] + number)
            case Wait():
                pass
            case Call(object=work, method="Take") if work in self.left:
                # Who waits is given a unit when another's is done, if one is left then: as if they came one by one.
                if sum(held == work for _, held in self.held) < self.left[work]:
                    self.held.add((name, work))
            case Call(object=work, method="Done") if work in self.left:
                self.left[work] -= (name, work) in self.held
                self.held.discard((name, work))
            case _:
                raise AssertionError(node)

    def holds(self, condition: Condition, robots: list[str]) -> bool:
        self.meet(robots)
        match condition:
            case Joint():
                asked = [name for name in self.who(condition.members) if name in robots]
                yes = sum(self.one_holds(condition.condition, name) for name in asked)
                return {"any": yes > 0, "all": yes == len(asked), "most": 2 * yes > len(asked)}[condition.quantifier]
            case And():
                return self.holds(condition.left, robots) and self.holds(condition.right, robots)
            case Or():
                return self.holds(condition.left, robots) or self.holds(condition.right, robots)
            case Not():
                return not self.holds(condition.condition, robots)
            case Call(object=work, method="IsEmpty"):
                return self.left[work] == 0
        raise AssertionError(condition)

    def one_holds(self, condition: Condition, name: str) -> bool:
        match condition:
            case And():
                return self.one_holds(condition.left, name) and self.one_holds(condition.right, name)
            case Or():
                return self.one_holds(condition.left, name) or self.one_holds(condition.right, name)
            case Not():
                return not self.one_holds(condition.condition, name)
            case Call(object="Count", method="LessThan", params=[Number(value=number)]):
                return self.counters[name] < number
            case Call(object=work, method="IsEmpty"):
                return self.left[work] == 0
        raise AssertionError(condition)
