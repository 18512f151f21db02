"""Graph → LLL for a program that came from one by an edit: only what the edit touched is translated.

The two states share the vertices and arcs that stayed. What is different is found by identity; then every piece whose
vertex, whatever it holds, has neither changed nor lost or got an arc is taken over with its nodes, and the others are
walked as ever. The state before must be without anything to say about it, and so must the new one: a piece that is
taken over was walked without a mistake, and an arc that would lead into it from elsewhere touches a vertex of it.
Otherwise the whole is translated, so the answer is always that of `graph_to_lll`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from copy import copy
from typing import TypeVar

from kitrobot.compiler.expansion_limit import oversize
from kitrobot.compiler.graph_to_lll import Translation, Walk, graph_to_lll
from kitrobot.compiler.wiring import Wiring
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Program, Vertex
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.affixes import common_affixes

Thing = TypeVar("Thing")


def graph_to_lll_again(before: Translation, program: Program, catalogue: Catalogue) -> Translation:
    """As `graph_to_lll`; `before` is what became of an earlier state of the program, by the same catalogue."""
    made = None if before.diagnostics or before.wiring.catalogue is not catalogue else _again(before, program)
    return graph_to_lll(program, catalogue) if made is None else made


def _again(before: Translation, program: Program) -> Translation | None:
    old = before.wiring.program
    if (old.target, old.level) != (program.target, program.level):
        return None
    if oversize(program, before.wiring.catalogue) is not None:
        return None
    wiring, changed = _wired_again(before.wiring, program)
    if wiring is None or wiring.found:
        return None
    dirty = _with_owners(changed, before.wiring) | _with_owners(changed, wiring)
    # Start's notes stand above the first instruction.
    for one in (before.wiring, wiring):
        if one.start is not None and one.start.notes and (first := one.out.get((one.start.id, NEXT))) is not None:
            dirty |= _with_owners([first.target], one)
    dirty |= _with_noted_nodes(dirty, before)
    kept = {name: piece for name, piece in before.pieces.items() if name not in dirty}
    if not kept:
        return None
    walk = Walk(program, wiring.catalogue, {}, wiring, kept)
    seq = walk.whole()
    if wiring.found or len(walk.visited) + walk.inside != len(wiring.vertices):
        return None
    gone = dirty - walk.pieces.keys()
    pieces = {name: piece for name, piece in before.pieces.items() if name not in gone} | walk.pieces
    stretches = {name: row for name, row in before.stretches.items() if name not in dirty} | walk.stretches
    taken = {id(node) for name in walk.taken for node in kept[name].row}
    return Translation(seq, wiring, stretches, [], pieces, before.lineage.grown(), before.program, taken)


def _with_noted_nodes(dirty: set[str], before: Translation) -> set[str]:
    """Those whose nodes have the notes of a longer template around them, which is translated anew: its ends."""
    rows = [before.pieces[name].row for name in dirty & before.stretches.keys() if name in before.pieces]
    noted = {id(node) for row in rows for node in (*row[:1], *row[-1:])}
    if not noted:
        return set()
    return {
        name
        for name, (row, *_) in before.pieces.items()
        if not noted.isdisjoint((*map(id, row[:1]), *map(id, row[-1:])))
    }


# -- the wiring


def _wired_again(before: Wiring, program: Program) -> tuple[Wiring | None, set[str]]:
    """The wiring of the program as it is now, and the vertices that changed, or of which an arc did; no wiring where it
    is to be made anew.
    """
    old = before.program
    gone, come = _differing(old.vertices, program.vertices)
    arcs_gone, arcs_come = _differing(old.arcs, program.arcs)
    ids_gone, ids_come = {one.id for one in gone}, {one.id for one in come}
    if _ends(gone) != _ends(come):
        return None, set()
    lost = ids_gone - ids_come
    other = {one.id for one in come if one.id in ids_gone and before.vertices[one.id].element != one.element}
    if lost or other:
        # Their arcs are looked at again: they may fit no more.
        new = set(map(id, arcs_come))
        again = lost | other
        touched = [arc for arc in program.arcs if (arc.source in again or arc.target in again) and id(arc) not in new]
        arcs_gone, arcs_come = [*arcs_gone, *touched], [*arcs_come, *touched]

    made = copy(before)
    made.program, made.found = program, []
    made.vertices, made.out = dict(before.vertices), dict(before.out)
    made.fills, made.ports = dict(before.fills), dict(before.ports)
    for arc in arcs_gone:
        if made.out.pop((arc.source, arc.out), None) is not None and arc.at not in (IN, RETURN):
            made.fills.pop((arc.target, arc.at), None)
    for name in ids_gone:
        made.vertices.pop(name, None)
    for vertex in come:
        made.add_vertex(vertex)
    for what in ("start", "stop"):
        end: Vertex | None = getattr(before, what)
        setattr(made, what, None if end is None else made.vertices.get(end.id))
    sources = {arc.source for arc in (*arcs_gone, *arcs_come)}
    for source in sources:
        made.ports.pop(source, None)
    for arc in arcs_come:
        made.add_arc(arc)
    for source in sources:
        made.ports.pop(source, None)
    for arc in program.arcs if sources else ():
        if arc.source in sources:
            made.ports.setdefault(arc.source, []).append(arc.out)
    changed = ids_gone | ids_come
    for arc in (*arcs_gone, *arcs_come):
        changed |= {arc.source, arc.target}
    return made, changed


def _ends(vertices: Iterable[Vertex]) -> set[tuple[str, str]]:
    return {(one.id, one.element) for one in vertices if one.element in (START, STOP)}


def _differing(before: Sequence[Thing], after: Sequence[Thing]) -> tuple[list[Thing], list[Thing]]:
    """The things of one list that are not in the other, each way, by identity."""
    start, tail = common_affixes([*map(id, before)], [*map(id, after)])
    old, new = before[start : len(before) - tail], after[start : len(after) - tail]
    one, other = Counter(map(id, old)), Counter(map(id, new))
    return [it for it in old if one[id(it)] != other[id(it)]], [it for it in new if one[id(it)] != other[id(it)]]


# -- what holds a vertex


def _with_owners(names: Iterable[str], wiring: Wiring) -> set[str]:
    """Those vertices, and all that hold them: in a body, or in a slot."""
    found: set[str] = set()
    waiting = [name for name in names if name in wiring.vertices]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        found.add(name)
        owner = _owner(name, wiring)
        if owner is not None:
            waiting.append(owner)
    return found


def _owner(name: str, wiring: Wiring) -> str | None:
    """The vertex that holds another one; None where that stands in the program's own row, or leads nowhere."""
    seen: set[str] = set()
    while name not in seen:
        seen.add(name)
        arc = wiring.out.get((name, NEXT))
        if arc is None:
            return None
        if arc.at != IN:
            return arc.target
        name = arc.target
    return None
