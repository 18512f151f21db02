"""Where the vertices of a graph stand in a text: the outermost stretches of each, in reading order."""

from __future__ import annotations

from typing import Any, NamedTuple

from kitrobot.compiler.lineage import Lineage, Table
from kitrobot.diagnostics.model import Source
from kitrobot.lll.tree import Call, Node, Seq, Wait
from kitrobot.lll.walk import children


class VertexPlace(NamedTuple):
    """The stretch of a text that a vertex is: character offsets, the end exclusive, and the line from 1."""

    vertex: str
    start: int
    end: int
    line: int


def vertex_places(tree: Seq, source: Source, lineage: Lineage | None = None) -> list[VertexPlace]:
    """The places of all vertices of a tree in its text.

    `lineage`: what is known of the instructions that are the same as in another state of the program.
    """
    lineage = lineage or Lineage()
    known: list[VertexPlace] | None = lineage.found("places", tree, source.text, None)
    if known is None:
        known = _Places(source, lineage.table("places", None)).whole(tree)
        lineage.find("places", tree, source.text, None, known)
    return [*known]


class _Places:
    def __init__(self, source: Source, known: Table) -> None:
        self.position = source.position
        self.known = known
        self.ends: dict[str, int] = {}
        self.found: list[VertexPlace] = []

    def whole(self, tree: Seq) -> list[VertexPlace]:
        self.node(tree)
        return self.found

    def node(self, node: Node) -> None:
        """Adds the places in a node; depth is bounded by that of programs."""
        vertex, start, found = node.vertex, node.start, self.found
        if vertex is not None and start >= self.ends.get(vertex, 0) and node.end > start:
            self.ends[vertex] = node.end
            found.append(VertexPlace(vertex, start, node.end, self.position(start)[0]))
        for child in children(node):
            if isinstance(node, Seq) and not isinstance(child, Call | Wait):
                self.kept(child)
            else:
                self.node(child)

    def kept(self, node: Any) -> None:
        """As `node`, for an instruction that another state of the program may share."""
        _, known = self.known.get(id(node), (None, None))
        # At another depth its lines are longer, and more of them may be needed.
        if known is None or known[0] != node.end - node.start:
            # As if nothing were around it: what is in the stretch of a vertex around is left out each time.
            inner, self.ends = self.ends, {}
            outer, self.found = self.found, []
            self.node(node)
            known = (node.end - node.start, node.start, self.position(node.start)[0], self.found)
            self.known[id(node)] = (node, known)
            self.ends, self.found = inner, outer
        _, start, line, places = known
        ends, by, down = self.ends, node.start - start, self.position(node.start)[0] - line
        for vertex, begin, end, at in places:
            if begin + by >= ends.get(vertex, 0):
                ends[vertex] = end + by
                self.found.append(VertexPlace(vertex, begin + by, end + by, at + down))
