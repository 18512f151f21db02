"""A vertex of a new part in the place of the selection that it was made from.

The program says the same as before: what was typed into the places that are slots now is typed into the new vertex,
what stood in them fills its slots, and notes of what went are its notes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from kitrobot.compiler.graph.graph_to_lll import SlotName
from kitrobot.compiler.graph.part_offers import TYPED, ports_of
from kitrobot.compiler.graph.selection import Selection, chain_behind, fillers_of, held_by
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.graph.model import IN, NEXT, RETURN, Arc, Note, Program, Vertex
from kitrobot.primitives.constructors import Constructor, SlotKind

_NUMBERED = re.compile(r"v([1-9][0-9]{0,8})")


def contents(wiring: Wiring, holes: Mapping[SlotName, str]) -> set[str]:
    """The vertices that stand in holes, with all they hold."""
    inner: list[str] = []
    for vertex, slot in holes:
        if slot == "":
            inner.append(vertex)
        elif (vertex, slot) in wiring.fills:
            inner.append(wiring.fills[vertex, slot])
        for port in [slot, *ports_of(wiring, vertex, slot)]:
            inner += chain_behind(wiring, vertex, port)
    fillers = fillers_of(wiring)
    return {one for name in inner for one in held_by(wiring, fillers, name)}


def put_part(
    wiring: Wiring, selection: Selection, constructor: Constructor, holes: Mapping[SlotName, str]
) -> tuple[Program, str]:
    """The program with a vertex of the constructor where the selection was, and the vertex."""
    placing = _PartPlacer(wiring, selection, constructor, holes)
    return placing.drawn(), placing.vertex


class _PartPlacer:
    """A vertex of the part in the place of the selection."""

    def __init__(
        self, wiring: Wiring, selection: Selection, constructor: Constructor, holes: Mapping[SlotName, str]
    ) -> None:
        self.old, self.wiring, self.selection, self.holes = wiring.program, wiring, selection, holes
        self.into = {arc.target: arc for arc in wiring.out.values() if arc.at == IN}
        self.vertex = _fresh(self.old)
        self.made = Vertex(self.vertex, constructor.name)
        self.arcs: dict[int, Arc | None] = {}
        self.more: list[Arc] = []
        kept = contents(wiring, holes)
        self.gone = [name for name in selection.held if name not in kept]
        for (owner, slot), name in holes.items():
            self.open(owner, slot, name)
        self.join_ends()
        self.take_over()

    def move(self, arc: Arc, source: str, target: str, out: str, at: str) -> None:
        self.arcs[id(arc)] = Arc(source, target, out, at)

    def open(self, owner: str, slot: str, name: str) -> None:
        """What stood in a slot now stands in the new vertex's."""
        if slot == "":
            self.open_action(owner, name)
            return
        constructor = self.wiring.constructor(self.wiring.vertices[owner])
        meaning = constructor.slot(slot) if constructor is not None else None
        filler = self.wiring.fills.get((owner, slot))
        if filler is not None:
            self.move(self.wiring.out[filler, NEXT], filler, self.vertex, NEXT, name)
        elif meaning is not None and meaning.kind is SlotKind.FLOW:
            ports = ports_of(self.wiring, owner, slot) if meaning.repeat else [slot]
            for port in ports:
                self.open_body(owner, port, name + port[len(slot) :])
        elif meaning is None or meaning.kind in TYPED:
            settings = self.wiring.vertices[owner].settings
            if slot in settings:
                self.made.settings[name] = settings[slot]
            else:
                self.made.settings[name] = self.default(owner, slot)

    def default(self, owner: str, slot: str) -> str:
        """What an element means where nothing is typed."""
        vertex = self.wiring.vertices[owner]
        constructor = self.wiring.constructor(vertex)
        if constructor is not None:
            found = constructor.slot(slot)
            assert found is not None
            return found.default or str(found.minimum or 0)
        name, _, method = vertex.element.partition(".")
        parameters = self.wiring.robot.calls[name, method][1].parameters
        return str(max(0, next(one.default for one in parameters if one.name == slot)))

    def open_body(self, owner: str, port: str, name: str) -> None:
        arc = self.wiring.out.get((owner, port))
        if arc is None:
            self.more.append(Arc(self.vertex, self.vertex, name, RETURN))
            return
        chain = chain_behind(self.wiring, owner, port)
        if chain:
            self.move(arc, self.vertex, arc.target, name, IN)
            arc = self.wiring.out.get((chain[-1], NEXT))
        if arc is not None and arc.at == RETURN:
            source, out = (chain[-1], NEXT) if chain else (self.vertex, name)
            self.move(arc, source, self.vertex, out, RETURN)

    def open_action(self, vertex: str, name: str) -> None:
        """A vertex of a chain, alone or beside neighbours of the same hole."""
        before, after = self.into.get(vertex), self.wiring.out.get((vertex, NEXT))
        if before is None or self.holes.get((before.source, "")) != name:
            self.more.append(Arc(self.vertex, vertex, name))
            if before is not None:
                self.arcs[id(before)] = None
        if after is None or after.at != IN or self.holes.get((after.target, "")) != name:
            self.more.append(Arc(vertex, self.vertex, NEXT, RETURN))
            if after is not None:
                self.arcs[id(after)] = None

    def join_ends(self) -> None:
        """The arcs into the selection and out of it."""
        first, last = self.selection.chain[0], self.selection.chain[-1]
        before = self.into.get(first)
        if before is not None and before.source not in self.selection.held:
            self.move(before, before.source, self.vertex, before.out, IN)
        after = self.wiring.out.get((last, NEXT))
        if after is not None:
            self.move(after, self.vertex, after.target, NEXT, after.at)

    def take_over(self) -> None:
        """Notes of what goes, and XML that nobody knows."""
        last = self.selection.chain[-1]
        above: list[str] = []
        rest = []
        for name in self.gone:
            vertex = self.wiring.vertices[name]
            self.made.unknown += vertex.unknown
            for note in vertex.notes:
                slot, _, number = note.at.removeprefix("in:").partition(".")
                hole = self.holes.get((name, slot)) if note.at.startswith("in:") else None
                if hole is not None:
                    rest.append(replace(note, at=f"in:{hole}{'.' if number else ''}{number}"))
                elif note.at == "after" and name == last and not self.selection.is_condition:
                    rest.append(note)
                else:
                    above.append(note.text)
        if above:
            self.made.notes.append(Note("\n".join(above)))
        self.made.notes += rest

    def drawn(self) -> Program:
        gone = set(self.gone)
        first = self.wiring.vertices[self.selection.held[0]]
        vertices: list[Vertex] = []
        for vertex in self.old.vertices:
            if vertex is first:
                vertices.append(self.made)
            if vertex.id not in gone:
                vertices.append(vertex)
        moved = (self.arcs.get(id(arc), arc) for arc in self.old.arcs)
        arcs = [arc for arc in moved if arc is not None and arc.source not in gone and arc.target not in gone]
        return replace(self.old, vertices=vertices, arcs=arcs + self.more)


def _fresh(program: Program) -> str:
    """An id that no vertex and no arc has."""
    names = [vertex.id for vertex in program.vertices]
    names += [name for arc in program.arcs for name in (arc.source, arc.target)]
    return f"v{max((int(found[1]) for found in map(_NUMBERED.fullmatch, names) if found), default=0) + 1}"
