"""What is known of the pieces that the states of one program share: an edit leaves most of its tree as it is.

A state that was translated from the one before (`retranslation`) has the very nodes of it, but for those around the
edit. Nodes say where they stand in a text, so their places are those of one state at a time: of `tree`, whose text is
`text`. Whoever reads or writes places of nodes that may be shared does so under `lock`.

What passes find out about a node is kept here with it: who meets the very node again need not look inside.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Any, TypeVar

from kitrobot.lll.tree import Node, Seq
from kitrobot.lll.walk import nodes

Thing = TypeVar("Thing", bound=Node)
Found = TypeVar("Found")

_SWEPT = 64
"""States after which what is known of nodes that are gone is forgotten."""

Table = dict[int, tuple[Node, Any]]
"""By the `id` of a node, that node, which so stays the only one of that `id`, and what a pass found out about it."""


def remembered(table: Table, node: Thing, find: Callable[[Thing], Found]) -> Found:
    """What a table knows of a node; found out, and kept there, where it knows nothing."""
    known = table.get(id(node))
    if known is None:
        known = table[id(node)] = (node, find(node))
    found: Found = known[1]
    return found


@dataclass(eq=False)
class Lineage:
    """The states of a program that came from one another.

    Attributes:
        tree, text: the state that the places of nodes are of, and its text; None before one was printed.
        read: a state of which it is known that its text reads as it, without anything to say about that.
    """

    lock: threading.RLock = field(default_factory=threading.RLock)
    tree: Seq | None = None
    text: str = ""
    read: Seq | None = None
    _found: dict[str, tuple[Seq, str, Hashable, Any]] = field(default_factory=dict)
    _tables: dict[tuple[str, Hashable], Table] = field(default_factory=dict)
    _states: int = 0

    def grown(self) -> Lineage:
        """This lineage, with one state more."""
        with self.lock:
            self._states += 1
            if self._states % _SWEPT == 0 and self.tree is not None:
                there = set(map(id, nodes(self.tree)))
                self._tables = {
                    name: {key: known for key, known in table.items() if key in there}
                    for name, table in self._tables.items()
                }
        return self

    def table(self, what: str, of: Hashable) -> Table:
        """What a pass found out about nodes, in the circumstances `of`; the pass adds to it."""
        return self._tables.setdefault((what, of), {})

    def found(self, what: str, tree: Seq, text: str, of: Hashable) -> Any:
        """What `find` was told of a whole tree whose text it is, in the circumstances `of`; None where it was not."""
        known = self._found.get(what)
        same = known is not None and known[0] is tree and known[2] == of and known[1] == text
        return known[3] if known is not None and same else None

    def find(self, what: str, tree: Seq, text: str, of: Hashable, value: Any) -> None:
        """Keeps what a pass found out about a whole tree, for as long as it is the newest."""
        self._found[what] = (tree, text, of, value)
