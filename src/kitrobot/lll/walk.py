"""Walks over a tree without recursion of the host."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from kitrobot.lll.tree import (
    And,
    Call,
    Conditional,
    Declaration,
    Event,
    GroupDeclaration,
    Instruction,
    Interrupt,
    Joint,
    Node,
    Not,
    Or,
    Parallel,
    ParOfSeq,
    Repeat,
    Seq,
    SeqOfPar,
    TeamProgram,
    Where,
    While,
)


def nodes(root: Node) -> list[Node]:
    """All nodes of a tree in reading order, the root first."""
    found: list[Node] = []
    waiting: list[Node] = [root]
    while waiting:
        node = waiting.pop()
        found.append(node)
        inside = _INSIDE.get(type(node))
        if inside is not None:
            waiting += inside(node)[::-1]
    return found


Tree = TypeVar("Tree", bound=Node)


def without_comments(root: Tree) -> Tree:
    """The same tree, whose comments are taken away in place."""
    for node in nodes(root):
        if isinstance(node, Instruction | Declaration):
            node.above, node.after = [], None
        elif isinstance(node, Seq):
            node.below = []
    return root


def bodies(node: Node) -> list[Seq]:
    """The bodies, or branches, of an instruction, in reading order."""
    return [child for child in children(node) if isinstance(child, Seq)]


def children(node: Node) -> list[Any]:
    """The nodes directly inside a node, in reading order."""
    inside = _INSIDE.get(type(node))
    return inside(node) if inside is not None else []


# A table by type: every pass of the compiler walks each node, and trying one type after another took half of that time.
_INSIDE: dict[type, Callable[[Any], list[Any]]] = {
    Seq: lambda node: list(node.items),
    Call: lambda node: list(node.params),
    Interrupt: lambda node: [node.call],
    Repeat: lambda node: [node.body],
    While: lambda node: [node.condition, node.body] if node.condition is not None else [node.body],
    Event: lambda node: [node.condition, node.body],
    Conditional: lambda node: [node.condition, node.then, *([node.orelse] if node.orelse is not None else [])],
    Parallel: lambda node: list(node.branches),
    And: lambda node: [node.left, node.right],
    Or: lambda node: [node.left, node.right],
    Not: lambda node: [node.condition],
    SeqOfPar: lambda node: [node.members, node.body],
    ParOfSeq: lambda node: [node.members, node.body],
    Where: lambda node: [
        *(node.members, node.condition, node.then),
        *([node.orelse] if node.orelse is not None else []),
    ],
    Joint: lambda node: [node.members, node.condition],
    TeamProgram: lambda node: [*node.declarations, node.seq],
    GroupDeclaration: lambda node: [node.members],
}
