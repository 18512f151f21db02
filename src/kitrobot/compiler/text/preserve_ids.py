"""Keeps vertex ids, notes and marks when a graph is made anew from its edited text.

An instruction that is still in the text (see `tree_diff`) keeps its vertex: the id, settings that say the same, notes
whose text did not change, XML that nobody knows. Vertices that were no part of the text (parked chains, elements
nobody knows beside the flow) stay with their arcs, and so do arcs that fitted nowhere. Branches that held nothing,
so that the text does not show them, stay between the same neighbours.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

from kitrobot.compiler.graph.graph_to_lll import Translation
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.compiler.target import program_for
from kitrobot.compiler.text.tree_diff import Same, same_nodes
from kitrobot.graph.model import NEXT, RETURN, START, Arc, Note, Program, Vertex
from kitrobot.lll.tree import Node, Number, Seq
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.robot import Robot

_NUMBERED = re.compile(r"^v([1-9][0-9]{0,8})$", re.MULTILINE)


@dataclass(frozen=True)
class Origin:
    """The vertex an instruction or a condition was, and the nodes it had become (the first of each template item)."""

    vertex: Vertex
    nodes: list[Any]


@dataclass(frozen=True)
class Row:
    """Instructions in a row that may still be a vertex whose template holds others between its own.

    They reach to the place `end`, exclusive, of the body that they begin in.
    """

    origin: Origin
    end: int


@dataclass(frozen=True)
class Branch:
    """A body of a repeated slot: what stands in it, and the port it had before, if any."""

    body: Seq
    port: str | None = None


class Before:
    """A graph as it was before an edit, with its translation to LLL; nothing of either may change any more."""

    def __init__(self, translation: Translation) -> None:
        self.program = translation.wiring.program
        self.translation = translation

    @cached_property
    def root_of(self) -> dict[int, str]:
        """`id` of a node → the vertex that it is the outermost node of, or one of several."""
        return {id(node): name for name, found in self.roots.items() for node in found}

    @cached_property
    def roots(self) -> dict[str, list[Any]]:
        """The outermost nodes of each vertex: a template's inner nodes name the vertex too."""
        found: dict[str, list[Any]] = {}
        waiting: list[tuple[Node, str | None]] = [(self.translation.program, None)]
        while waiting:
            node, owner = waiting.pop()
            if node.vertex is not None and node.vertex != owner and not isinstance(node, Number):
                found.setdefault(node.vertex, []).append(node)
            owner = node.vertex or owner
            waiting += [(child, owner) for child in reversed(children(node))]
        return found

    @cached_property
    def hole_at(self) -> dict[str, int]:
        """Vertices whose template has a hole for instructions between its own, and where."""
        wiring, found = self.translation.wiring, {}
        for name in self.translation.stretches:
            constructor = wiring.constructor(wiring.vertices[name])
            template = constructor.template if constructor is not None else None
            if isinstance(template, Seq) and template.hole is not None:
                found[name] = template.hole_at
        return found

    @cached_property
    def highest_number(self) -> int:
        """The highest n of the ids v<n> in use, by vertices or by arcs."""
        ids = {vertex.id for vertex in self.program.vertices}
        if not self.translation.ok:  # else arcs join vertices that are there
            for arc in self.program.arcs:
                ids |= {arc.source, arc.target}
        return max(map(int, _NUMBERED.findall("\n".join(ids))), default=0)


def nothing_before(robot: Robot, catalogue: Catalogue) -> Before:
    """What there was before the first text: no graph."""
    program = program_for(robot, "")
    return Before(Translation(Seq(), Wiring(program, robot, catalogue)))


class Old:
    """The graph before the edit, and which of its nodes those of the new text are."""

    def __init__(self, before: Before, same: Same) -> None:
        self.same = same
        self.program = before.program
        self.tree, self.wiring = before.translation.program, before.translation.wiring
        self.stretches = before.translation.stretches
        self.roots, self.root_of = before.roots, before.root_of
        self.hole_at = before.hole_at
        self.highest_number = before.highest_number

    @staticmethod
    def beside(before: Before, new: Seq) -> Old:
        """The graph beside a whole new text."""
        return Old(before, same_nodes(before.translation.program, new))

    def unchanged(self, node: Node) -> Any:
        """What an instruction was, where nothing in it changed and it is all that its vertex became; or None."""
        was = self.same.get(id(node))
        name = self.root_of.get(id(was))
        if name is None or name in self.stretches or len(self.roots[name]) > 1 or was != node:
            return None
        return was

    def parts_of(self, root: Node) -> tuple[list[Vertex], list[Arc]]:
        """The vertices that an instruction is, whatever it holds, and the arcs between them, in their order."""
        wiring, place = self.wiring, self._place
        names = {node.vertex for node in nodes(root) if node.vertex is not None}
        arcs = [wiring.out[name, out] for name in names for out in wiring.ports.get(name, ())]
        leaving = wiring.out.get((root.vertex or "", NEXT))
        return (
            sorted((wiring.vertices[name] for name in names), key=lambda one: place[id(one)]),
            sorted((arc for arc in arcs if arc is not leaving), key=lambda one: place[id(one)]),
        )

    @cached_property
    def _place(self) -> dict[int, int]:
        """By the `id` of a vertex or an arc, its place in the lists of the program."""
        lists = (self.program.vertices, self.program.arcs)
        return {id(one): at for things in lists for at, one in enumerate(things)}

    def rows(self, items: list[Any]) -> dict[int, list[Row]]:
        """The rows of a body by the place where they begin, the longest first.

        A vertex is there when its own instructions are, in order, those before and behind its hole in a row each. What
        stands between them is in the hole; at an open end, what stood there before and what is new among it.
        """
        if not self.hole_at:
            return {}
        before = [self.same.get(id(item)) for item in items]
        at = {id(node): index for index, node in enumerate(before) if node is not None}
        found: dict[int, list[Row]] = {}
        for name in dict.fromkeys(self.root_of.get(id(node), "") for node in before):
            if name not in self.hole_at:
                continue
            own = [at.get(id(node), -1) for node in self.roots[name]]
            head, tail = own[: self.hole_at[name]], own[self.hole_at[name] :]
            if -1 in own or not (_in_a_row(head) and _in_a_row(tail)) or (head and tail and head[-1] > tail[0]):
                continue
            held = {id(node) for node in self.stretches[name]} - {id(node) for node in self.roots[name]}
            start = head[0] if head else _reach(before, held, tail[0], -1)
            end = tail[-1] + 1 if tail else _reach(before, held, head[-1], 1) + 1
            origin = Origin(self.wiring.vertices[name], self.stretches[name])
            found.setdefault(start, []).append(Row(origin, end))
        for rows in found.values():
            rows.sort(key=lambda row: -row.end)
        return found

    def origin(self, node: Node) -> Origin | None:
        """What a node of the new text was; None when it is new, or was an inner part of a vertex."""
        before = self.same.get(id(node))
        name = self.root_of.get(id(before)) if before is not None else None
        if name is None or self.roots[name][0] is not before:
            return None
        return Origin(self.wiring.vertices[name], self.roots[name])

    def end(self, element: str) -> Vertex:
        """Start or Stop as it was, with its notes."""
        found = self.wiring.start if element == START else self.wiring.stop
        if found is not None:
            return replace(found, notes=list(found.notes))
        name = element.lower()
        while name in self.wiring.vertices:
            name += "-"
        return Vertex(name, element)

    def branches(self, origin: Origin, slot: str, before: list[Seq], after: list[Seq]) -> list[Branch]:
        """The bodies of a repeated slot, with those that held nothing in their places."""
        layout = self._layout(origin.vertex.id, slot, before)
        if layout is None:
            return [Branch(body) for body in after]
        place = {id(body): at for at, (_, body) in enumerate(layout) if body is not None}
        places = [place.get(id(self.same.get(id(body)))) for body in after]
        made: list[Branch] = []
        at = 0
        for index, body in enumerate(after):
            known = places[index]
            ahead = [one for one in places[index:] if one is not None and one >= at]
            if known is not None and known >= at:
                made += [Branch(Seq(), port) for port, old in layout[at:known] if old is None]
                made.append(Branch(body, layout[known][0]))
                at = known + 1
                continue
            free = [one for one in range(at, min(ahead, default=len(layout))) if layout[one][1] is None]
            made.append(Branch(body, layout[free[0]][0] if free else None))
            at = free[0] + 1 if free else at
        return made + [Branch(Seq(), port) for port, old in layout[at:] if old is None]

    def _layout(self, vertex: str, slot: str, before: list[Seq]) -> list[tuple[str, Seq | None]] | None:
        """Port and body of each branch in order, the body None where it holds nothing; None when they do not agree."""
        base = slot + "."
        ports = [port for port in self.wiring.ports.get(vertex, ()) if port.startswith(base)]
        ports.sort(key=lambda port: int(port[len(base) :]))
        full = [port for port in ports if self.wiring.out[vertex, port].at != RETURN]
        if len(full) != len(before):
            return None
        bodies = dict(zip(full, before, strict=True))
        return [(port, bodies.get(port)) for port in ports]

    def leave(self, program: Program, *, loose_only: bool) -> None:
        """Adds what was no part of the text. `loose_only`: without arcs between it and the flow."""
        in_text = set(self.roots)
        first = {id(vertex) for vertex in self.wiring.vertices.values()}
        in_text |= {end.id for end in (self.wiring.start, self.wiring.stop) if end is not None}
        flow = {vertex.id for vertex in program.vertices}
        program.vertices += [
            vertex for vertex in self.program.vertices if vertex.id not in in_text or id(vertex) not in first
        ]
        there = {vertex.id for vertex in program.vertices}
        drawn = {(arc.source, arc.out, arc.target, arc.at) for arc in program.arcs}
        fitted = {id(arc) for arc in self.wiring.out.values()}
        for arc in self.program.arcs:
            if arc.source in in_text and id(arc) in fitted:
                continue
            if arc.source not in there or arc.target not in there:
                continue
            if loose_only and (arc.source in flow or arc.target in flow):
                continue
            if (arc.source, arc.out, arc.target, arc.at) not in drawn:
                program.arcs.append(arc)


def _in_a_row(places: list[int]) -> bool:
    return all(after == one + 1 for one, after in pairwise(places))


def _reach(before: list[Node | None], held: set[int], place: int, step: int) -> int:
    """The last place from `place` on that something held reached, across what is new."""
    last = place
    place += step
    while 0 <= place < len(before):
        node = before[place]
        if node is not None and id(node) not in held:
            break
        if node is not None:
            last = place
        place += step
    return last


def note(text: list[str], at: str = "") -> list[Note]:
    """The note of some comment lines, or none."""
    return [Note("\n".join(text), at)] if text else []


def lines_of(notes: list[Note]) -> list[str]:
    """Notes as the comment lines that they become."""
    return [line.rstrip() for one in notes for line in one.text.split("\n")]
