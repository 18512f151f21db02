"""Pieces of projected programs, and what is asked about pieces of a team's program."""

from __future__ import annotations

from typing import TypeVar

from kitrobot.lll.tree import Block, Break, Call, Instr, Instruction, Move, Node, Number, Parallel, Repeat, Seq, While
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.team_objects import TEAM

Lines = dict[str, list[Instr]]
"""What each kind of robot does, by its name."""

Made = TypeVar("Made", bound=Instruction)


def team_call(method: str, *params: Number | Call) -> Call:
    """A call of the robot object `Team`."""
    return Call(TEAM, method, list(params))


def answer() -> Call:
    """The test whether the team's last answer was yes."""
    return team_call("Answer")


def come_from(node: Instruction, made: Made) -> Made:
    """A new instruction, which comes from where another came from."""
    made.vertex, made.program = node.vertex, node.program
    return made


def append(lines: Lines, more: Lines) -> None:
    """Adds what each kind does next; kinds that do not come there are passed over."""
    for kind, items in more.items():
        if kind in lines:
            lines[kind] += items


def has_blocks(node: Node) -> bool:
    """Whether robots of the team meet within an instruction."""
    return any(isinstance(inner, Block | Move) for inner in nodes(node))


def loose_break(seq: Seq) -> Break | None:
    """A BREAK that leaves what is around a body."""
    waiting: list[Node] = [seq]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Break):
            return node
        if not isinstance(node, While | Repeat | Parallel):
            waiting += children(node)
    return None
