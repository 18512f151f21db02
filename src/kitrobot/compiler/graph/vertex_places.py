"""Where the vertices of a graph stand in a text: the outermost stretches of each, in reading order."""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.diagnostics.model import Source
from kitrobot.lll.tree import Seq
from kitrobot.lll.walk import nodes


class VertexPlace(NamedTuple):
    """The stretch of a text that a vertex is: character offsets, the end exclusive, and the line from 1."""

    vertex: str
    start: int
    end: int
    line: int


def vertex_places(tree: Seq, source: Source) -> list[VertexPlace]:
    """The places of all vertices of a tree in its text."""
    found: list[VertexPlace] = []
    ends: dict[str, int] = {}
    for node in nodes(tree):
        vertex, start = node.vertex, node.start
        if vertex is not None and start >= ends.get(vertex, 0) and node.end > start:
            ends[vertex] = node.end
            found.append(VertexPlace(vertex, start, node.end, source.position(start)[0]))
    return found
