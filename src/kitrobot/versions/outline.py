"""Where each vertex of a program stands, read off the arcs: in which body of which constructor, and after whom.

A *chain* is a list of vertices, known by its holder's id and the port it hangs on: ("", "next") for what follows Start,
(constructor, slot) for a body and for what fills a slot, (its first vertex, "parked") for a chain that hangs on
nothing. Every vertex but Start and Stop is in exactly one chain, whatever the graph looks like. Left to others: whether
the graph makes sense (compiler).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Program, Vertex

Chain = tuple[str, str]
PARKED = "parked"


@dataclass(frozen=True)
class Spot:
    """A place in a chain; `after` is the vertex before it, "" for none."""

    chain: Chain
    index: int
    after: str


class Outline:
    """The chains of a program, and the spot of each vertex."""

    def __init__(self, program: Program) -> None:
        self.vertices: Mapping[str, Vertex] = {vertex.id: vertex for vertex in program.vertices}
        self.chains: dict[Chain, list[str]] = {}
        self.spots: dict[str, Spot] = {}
        self._onward: dict[str, str] = {}
        self._into: set[str] = set()
        heads: list[tuple[Chain, str]] = []
        fillers: list[tuple[Chain, str]] = []
        for arc in program.arcs:
            self._take(arc, heads, fillers)
        for chain, first in heads:
            self._follow(chain, first)
        for chain, first in fillers:
            self._follow(chain, first)
        for vertex in program.vertices:
            if vertex.id not in self._into:
                self._follow((vertex.id, PARKED), vertex.id)
        self._parked: dict[str, bool] = {}
        for vertex in program.vertices:  # what goes round in a circle and hangs on nothing
            self._follow((vertex.id, PARKED), vertex.id)

    def _take(self, arc: Arc, heads: list[tuple[Chain, str]], fillers: list[tuple[Chain, str]]) -> None:
        source = self.vertices.get(arc.source)
        if source is None or arc.target not in self.vertices or arc.at == RETURN:
            return
        if arc.at != IN:
            fillers.append(((arc.target, arc.at), arc.source))
        elif source.element == START:
            heads.append((("", NEXT), arc.target))
            self._into.add(arc.target)
        elif arc.out == NEXT:
            self._onward.setdefault(arc.source, arc.target)
            self._into.add(arc.target)
        else:
            heads.append(((arc.source, arc.out), arc.target))
            self._into.add(arc.target)

    def _follow(self, chain: Chain, first: str) -> None:
        at, after = first, ""
        while at and at not in self.spots and self.vertices[at].element not in (START, STOP):
            members = self.chains.setdefault(chain, [])
            self.spots[at] = Spot(chain, len(members), after)
            members.append(at)
            at, after = self._onward.get(at, ""), at

    def is_parked(self, vertex: str) -> bool:
        """Whether a vertex hangs on nothing, or on something that does."""
        seen: dict[str, None] = {}
        while vertex in self.spots and vertex not in seen and vertex not in self._parked:
            seen[vertex] = None
            holder, slot = self.spots[vertex].chain
            if slot == PARKED:
                self._parked[vertex] = True
                break
            vertex = holder
        found = self._parked.get(vertex, vertex in seen)
        self._parked.update(dict.fromkeys(seen, found))
        return found
