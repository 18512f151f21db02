"""Makes a program that shows a fault smaller while it still shows it: for reports of the volume runs."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator

from kitrobot.lll.tree import And, Conditional, Event, Interrupt, Not, Or, Parallel, Repeat, Seq, Wait, While
from kitrobot.lll.walk import nodes


def shrink(program: Seq, shows_it: Callable[[Seq], bool]) -> Seq:
    """A program, at most as large, for which `shows_it` is still true and no single simplification keeps it true."""
    smaller = True
    while smaller:
        smaller = False
        for candidate in _simplifications(program):
            if _is_readable(candidate) and shows_it(copy.deepcopy(candidate)):
                program = candidate
                smaller = True
                break
    return program


def _is_readable(program: Seq) -> bool:
    """Whether the parser could give such a tree: it drops branches that hold nothing."""
    return all(branch.items for node in nodes(program) if isinstance(node, Parallel) for branch in node.branches)


def _simplifications(program: Seq) -> Iterator[Seq]:
    count = len(nodes(program))
    for index in range(count):
        for change in range(8):
            candidate = copy.deepcopy(program)
            if _simplify(nodes(candidate)[index], change):
                yield candidate
    for index in range(count):
        for position in range(20):
            candidate = copy.deepcopy(program)
            node = nodes(candidate)[index]
            if isinstance(node, Seq) and position < len(node.items):
                if _unwrap(node, position):
                    yield candidate
            else:
                break


def _simplify(node: object, change: int) -> bool:
    """Makes one node smaller in place; says whether that way of doing it exists for the node."""
    match node:
        case Seq() if change < len(node.items):
            del node.items[change]
            return True
        case Parallel() if change < len(node.branches):
            del node.branches[change]
            return True
        case Conditional() if change == 0 and node.orelse is not None:
            node.orelse = None
            return True
        case Repeat() if change == 0 and isinstance(node.count, int) and node.count > 1:
            node.count -= 1
            return True
        case Wait() if change == 0 and isinstance(node.duration, int) and node.duration > 0:
            node.duration -= 1
            return True
        case While() if change == 0 and node.condition is not None:
            node.condition = None
            return True
        case While() | Conditional() | Event() if change in (1, 2):
            inner = node.condition
            if isinstance(inner, And | Or):
                node.condition = inner.left if change == 1 else inner.right
                return True
            if isinstance(inner, Not):
                node.condition = inner.condition
                return True
    return False


def _unwrap(seq: Seq, position: int) -> bool:
    """Replaces one instruction of a body by what is inside it."""
    item = seq.items[position]
    match item:
        case Repeat() | While() | Event():
            inside = item.body.items
        case Conditional():
            inside = item.then.items + (item.orelse.items if item.orelse is not None else [])
        case Interrupt():
            inside = [item.call]  # type: ignore[list-item]
        case Parallel() if len(item.branches) == 1:
            inside = item.branches[0].items
        case _:
            return False
    seq.items[position : position + 1] = inside
    return True
