"""Matches the instructions of a new text to those of an old one: a diff of two trees.

`same_nodes` pairs nodes of the new tree with nodes of the old: equal subtrees in the same order of their body first,
then what was changed in its place (same element, then same kind), and at last equal subtrees that moved elsewhere,
as when instructions are wrapped in a loop. Comments do not count. A node of the old tree is paired at most once.
Cost grows with the number of nodes and with how deep an edit lies, not with the square of anything.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Any

from kitrobot.compiler.common_order import common_order
from kitrobot.lll.tree import (
    And,
    Call,
    Conditional,
    Event,
    Interrupt,
    Joint,
    Members,
    Move,
    Node,
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
from kitrobot.lll.walk import children, nodes

Same = dict[int, Node]
"""`id` of a new node → the old node it is."""

_BODIES: dict[type[Node], tuple[str, ...]] = {
    Repeat: ("body",),
    While: ("body",),
    Event: ("body",),
    Conditional: ("then", "orelse"),
    SeqOfPar: ("body",),
    ParOfSeq: ("body",),
    Where: ("then", "orelse"),
}


def same_nodes(old: Seq, new: Seq) -> Same:
    """The pairs of two programs."""
    return _TreeMatcher(old, new).same


class _TreeMatcher:
    def __init__(self, old: Seq, new: Seq) -> None:
        self.keys: dict[int, int] = {}
        self.table: dict[tuple[object, ...], int] = {}
        self.same: Same = {}
        self.taken: set[int] = set()
        self.bodies(old, new)
        self.moved(old, new)

    def key(self, root: Node) -> int:
        """A number that equal subtrees have in common, comments apart. All in the subtree is numbered with it."""
        if id(root) not in self.keys:
            self.count(root)
        return self.keys[id(root)]

    def count(self, root: Node) -> None:
        """Gives equal subtrees equal numbers, from the leaves up."""
        keys, table = self.keys, self.table
        for node in reversed(nodes(root)):
            kind = type(node)
            own = _OWN.get(kind)
            key = (kind, own and own(node), *[keys[id(child)] for child in children(node)])
            keys[id(node)] = table.setdefault(key, len(table))

    def is_equal(self, old: Node, new: Node) -> bool:
        return self.key(old) == self.key(new)

    def pair(self, old: Node, new: Node) -> None:
        self.same[id(new)] = old
        self.taken.add(id(old))

    def whole(self, old: Node, new: Node) -> None:
        """Pairs two equal subtrees, node by node."""
        taken = nodes(old)
        self.same.update(zip(map(id, nodes(new)), taken, strict=True))
        self.taken.update(map(id, taken))

    # -- bodies

    def bodies(self, old: Seq, new: Seq) -> None:
        self.pair(old, new)
        self.row(old.items, new.items)

    def row(self, old: list[Any], new: list[Any]) -> None:
        """Two bodies' instructions, or two parallels' branches."""
        # Most often one of many differs: the equal ends need no numbers.
        shorter, start, tail = min(len(old), len(new)), 0, 0
        while start < shorter and old[start] == new[start]:
            self.whole(old[start], new[start])
            start += 1
        while tail < shorter - start and old[-1 - tail] == new[-1 - tail]:
            tail += 1
            self.whole(old[-tail], new[-tail])
        old, new = old[start : len(old) - tail], new[start : len(new) - tail]
        pairs = common_order([self.key(item) for item in old], [self.key(item) for item in new])
        for i, j in pairs:
            self.whole(old[i], new[j])
        i = j = 0
        for i_next, j_next in [*pairs, (len(old), len(new))]:
            if i < i_next and j < j_next:
                self.changed(old[i:i_next], new[j:j_next])
            i, j = i_next + 1, j_next + 1

    def changed(self, old: list[Any], new: list[Any]) -> None:
        """A stretch in which nothing is equal: what was changed in its place."""
        old, new = self.not_within(old, new), self.not_within(new, old)
        pairs = common_order([_element(item) for item in old], [_element(item) for item in new])
        i = j = 0
        for i_next, j_next in [*pairs, (len(old), len(new))]:
            kinds = [type(item) for item in old[i:i_next]]
            if kinds == [type(item) for item in new[j:j_next]]:
                for one, other in zip(old[i:i_next], new[j:j_next], strict=True):
                    self.inside(one, other)
            if i_next < len(old) and j_next < len(new):
                self.inside(old[i_next], new[j_next])
            i, j = i_next + 1, j_next + 1

    def not_within(self, items: list[Any], others: list[Any]) -> list[Any]:
        """Without what stands inside one of the others, unchanged: it was wrapped or unwrapped."""
        inside = {self.key(node) for item in others if not isinstance(item, Call) for node in nodes(item)[1:]}
        return [item for item in items if self.key(item) not in inside]

    def inside(self, old: Any, new: Any) -> None:
        """Two nodes of a kind that are one, though not equal: pairs them, and goes on in what they hold."""
        if isinstance(old, Seq):
            self.bodies(old, new)
            return
        self.pair(old, new)
        if isinstance(old, Call):
            self.calls(old.params, new.params)
        elif isinstance(old, Interrupt):
            self.calls([old.call], [new.call])
        elif isinstance(old, Parallel):
            self.row(old.branches, new.branches)
        elif isinstance(old, While | Event | Conditional | Where) and None not in (old.condition, new.condition):
            self.condition(old.condition, new.condition)
        for name in _BODIES.get(type(old), ()):
            one, other = getattr(old, name), getattr(new, name)
            if one is not None and other is not None:
                self.bodies(one, other)

    def calls(self, old: list[Any], new: list[Any]) -> None:
        for one, other in zip(old, new, strict=False):
            if isinstance(one, Call) and isinstance(other, Call):
                self.inside(one, other)

    # -- conditions

    def condition(self, old: Any, new: Any) -> None:
        if self.is_equal(old, new):
            self.whole(old, new)
            return
        for part in nodes(new)[1:]:
            if self.is_equal(old, part) and not isinstance(part, Number):
                self.whole(old, part)
                return
        for part in nodes(old)[1:]:
            if self.is_equal(part, new) and not isinstance(part, Number):
                self.whole(part, new)
                return
        if type(old) is not type(new):
            return
        if isinstance(old, And | Or):
            self.pair(old, new)
            self.condition(old.left, new.left)
            self.condition(old.right, new.right)
        elif isinstance(old, Not | Joint):
            self.pair(old, new)
            self.condition(old.condition, new.condition)
        else:
            self.inside(old, new)

    # -- moves

    def moved(self, old: Seq, new: Seq) -> None:
        """Equal subtrees that are left on both sides, in reading order."""
        waiting: dict[int, list[Node]] = {}
        for node in reversed(nodes(old)):
            if id(node) not in self.taken and not isinstance(node, Seq | Number | Members):
                waiting.setdefault(self.key(node), []).append(node)
        if not waiting:
            return
        for node in nodes(new):
            if id(node) in self.same or isinstance(node, Seq | Number | Members):
                continue
            candidates = waiting.get(self.key(node), [])
            while candidates:
                candidate = candidates.pop()
                parts = nodes(candidate)
                if self.taken.isdisjoint(map(id, parts)):
                    if not any(id(part) in self.same for part in nodes(node)):
                        self.whole(candidate, node)
                    break


# What a node says itself, besides what is inside it.
_OWN: dict[type[Node], Callable[[Any], object]] = {
    Call: attrgetter("object", "method"),
    Number: attrgetter("value"),
    Repeat: attrgetter("count"),
    Wait: attrgetter("duration"),
    Conditional: lambda node: node.orelse is not None,
    Where: lambda node: node.orelse is not None,
    While: lambda node: node.condition is not None,
    Members: lambda node: (*node.names, node.braced),
    Joint: attrgetter("quantifier"),
    ProgramCall: attrgetter("name"),
    Move: attrgetter("count", "source", "target"),
}


def _element(node: Any) -> tuple[object, ...]:
    """What an instruction is, whatever it holds."""
    return (type(node), node.object, node.method) if isinstance(node, Call) else (type(node),)
