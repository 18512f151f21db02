"""Walks over a tree without recursion of the host."""

from __future__ import annotations

from typing import Any

from kitrobot.lll.tree import (
    And,
    Call,
    Conditional,
    Event,
    Interrupt,
    Node,
    Not,
    Or,
    Parallel,
    Repeat,
    Seq,
    While,
)


def nodes(root: Node) -> list[Node]:
    """All nodes of a tree in reading order, the root first."""
    found: list[Node] = []
    waiting: list[Node] = [root]
    while waiting:
        node = waiting.pop()
        found.append(node)
        waiting += reversed(children(node))
    return found


def bodies(node: Node) -> list[Seq]:
    """The bodies, or branches, of an instruction, in reading order."""
    return [child for child in children(node) if isinstance(child, Seq)]


def children(node: Node) -> list[Any]:
    """The nodes directly inside a node, in reading order."""
    match node:
        case Seq():
            return list(node.items)
        case Call():
            return list(node.params)
        case Interrupt():
            return [node.call]
        case Repeat():
            return [node.body]
        case While() | Event():
            return [node.condition, node.body]
        case Conditional():
            return [node.condition, node.then, *([node.orelse] if node.orelse is not None else [])]
        case Parallel():
            return list(node.branches)
        case And() | Or():
            return [node.left, node.right]
        case Not():
            return [node.condition]
        case _:
            return []
