"""Two people's edits of one program brought together: a three-way merge by vertices and arcs.

Each out-port leads to one place, so two edits of different places change different ports and both stand; ids that both
sides gave to different new vertices are made fresh first. A program whose merged graph would not hang together as both
sides' graphs do stays whole as one of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from kitrobot.graph.model import IN, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.conflicts import Decisions
from kitrobot.versions.lists import merged_order
from kitrobot.versions.outline import Outline
from kitrobot.versions.phrases import named

Port = tuple[str, str]


def merge_programs(
    base: Program, ours: Program, theirs: Program, decisions: Decisions, fresh: dict[tuple[str, str], str]
) -> Program:
    """The program with both sides' edits of `base`.

    Args:
        base: what both began with.
        ours: our program, of the same name.
        theirs: theirs, likewise.
        decisions: where both changed the same thing differently.
        fresh: is given, by program and id, the new id of each of their vertices that has one.
    """
    if theirs in (base, ours):
        return ours
    if ours == base:
        return theirs
    inner = decisions.within(ours.name)
    ids = _fresh_ids(base, ours, theirs)
    merged = _ProgramMerge(base, ours, _with_ids(theirs, ids), inner).whole()
    if merged is None:
        inner = decisions.within(ours.name)
        takes = inner.takes(
            Sentence("how its instructions hang together"),
            Sentence("both changed how its instructions hang together: ours is kept as a whole"),
            Sentence("both changed how its instructions hang together: theirs is taken as a whole"),
        )
        merged = theirs if takes else ours
    else:
        fresh.update(((ours.name, id), new) for id, new in ids.items())
    decisions.found += inner.found
    return merged


def _fresh_ids(base: Program, ours: Program, theirs: Program) -> dict[str, str]:
    """Other ids for their new vertices where ours gave the same ids to new vertices."""
    old = {vertex.id for vertex in base.vertices}
    mine = {vertex.id for vertex in ours.vertices} - old
    taken = mine | old | {vertex.id for vertex in theirs.vertices}
    names: dict[str, str] = {}
    number = 1
    for vertex in theirs.vertices:
        if vertex.id not in mine or vertex.element in (START, STOP):
            continue
        while f"v{number}" in taken:
            number += 1
        names[vertex.id] = f"v{number}"
        taken.add(names[vertex.id])
    return names


def _with_ids(program: Program, ids: Mapping[str, str]) -> Program:
    vertices = [replace(vertex, id=ids.get(vertex.id, vertex.id)) for vertex in program.vertices]
    arcs = [
        replace(arc, source=ids.get(arc.source, arc.source), target=ids.get(arc.target, arc.target))
        for arc in program.arcs
    ]
    return replace(program, vertices=vertices, arcs=arcs)


class _ProgramMerge:
    def __init__(self, base: Program, ours: Program, theirs: Program, decisions: Decisions) -> None:
        self.sides = (base, ours, theirs)
        self.choose = decisions.choose

    def whole(self) -> Program | None:
        """The merged program; None when it would not hang together."""
        _, ours, theirs = self.sides
        ports = [_ports(program) for program in self.sides]
        if any(found is None for found in ports):
            return None
        vertices = self.vertices()
        if vertices is None:
            return None
        known = {vertex.id for vertex in vertices}
        arcs = self.arcs([found or {} for found in ports], known)
        if arcs is None:
            return None
        robot, level = self.choose(Sentence("the robot"), *((side.target, side.level) for side in self.sides))
        merged = Program(ours.name, robot, vertices, arcs, level)
        return merged if _hangs_together(merged, ours, theirs) else None

    def vertices(self) -> list[Vertex] | None:
        old, mine, other = ({vertex.id: vertex for vertex in side.vertices} for side in self.sides)
        found: dict[str, Vertex] = {}
        for id in merged_order(old, mine, other):
            one, two, three = old.get(id), mine.get(id), other.get(id)
            if two is not None and three is not None:
                found[id] = self.vertex(one or Vertex(id, two.element), two, three)
            elif one is None:
                found[id] = two or three  # type: ignore[assignment]
            elif (two or three) != one:
                return None  # removed by one, changed by the other
        return list(found.values())

    def vertex(self, one: Vertex, two: Vertex, three: Vertex) -> Vertex:
        what = named(two)
        settings: dict[str, str] = {}
        for name in merged_order(one.settings, two.settings, three.settings):
            values = (one.settings.get(name), two.settings.get(name), three.settings.get(name))
            value = self.choose(Sentence("the {setting} of {vertex}", Word(name), what), *values)
            if value is not None:
                settings[name] = value
        return Vertex(
            two.id,
            self.choose(Sentence("the element of {vertex}", what), one.element, two.element, three.element),
            settings,
            self.choose(Sentence("the notes of {vertex}", what), one.notes, two.notes, three.notes),
            self.choose(Sentence("what is inside {vertex}", what), one.unknown, two.unknown, three.unknown),
        )

    def arcs(self, ports: Sequence[Mapping[Port, Arc]], known: set[str]) -> list[Arc] | None:
        old, mine, other = ports
        found: list[Arc] = []
        for port in merged_order(old, mine, other):
            one, two, three = old.get(port), mine.get(port), other.get(port)
            if two != one and three not in (one, two):
                return None  # both put something else here
            arc = three if two == one else two
            if arc is not None:
                if arc.source not in known or arc.target not in known:
                    return None
                found.append(arc)
        return found


def _ports(program: Program) -> dict[Port, Arc] | None:
    """Each out-port's arc; None when two leave one."""
    found = {(arc.source, arc.out): arc for arc in program.arcs}
    return found if len(found) == len(program.arcs) else None


def _hangs_together(merged: Program, ours: Program, theirs: Program) -> bool:
    """Whether nothing came loose, every in-port is entered once, and no chain ends where both sides' went on."""
    into = [(arc.target, arc.at) for arc in merged.arcs if arc.at != RETURN]
    stops = _ids(merged, STOP)
    single = [(target, at) for target, at in into if at != IN or target not in stops]
    if len(single) != len(set(single)):
        return False
    now, mine, other = Outline(merged), Outline(ours), Outline(theirs)
    for vertex in now.spots:
        if now.is_parked(vertex) and not any(vertex in side.spots and side.is_parked(vertex) for side in (mine, other)):
            return False
    return _loose(merged) - stops <= _loose(ours) | _loose(theirs)


def _loose(program: Program) -> set[str]:
    """The vertices that no arc leaves."""
    return _ids(program) - {arc.source for arc in program.arcs}


def _ids(program: Program, element: str | None = None) -> set[str]:
    return {vertex.id for vertex in program.vertices if element in (None, vertex.element)}
