"""An edited text beside its graph, where only a stretch of it was edited: what a key press does.

The two trees are compared from outside in, until what differs is a row of instructions in one body. That row is drawn
anew (lll_to_graph) and takes the place of what it was in the lists of the graph; everything else is taken over as it
stands. The result is translated back and must say what the text says, or the whole is drawn instead: where a title
moves, a template stands around others, the graph has loose ends. So this is only ever quicker, never another answer;
but an instruction around the edit keeps its vertex for certain, where the whole drawing may choose among equals.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from kitrobot.compiler.accepted_forms import normalise
from kitrobot.compiler.graph_to_lll import Translation
from kitrobot.compiler.lll_to_graph import Drawing, redraw
from kitrobot.compiler.preserve_ids import Before, Old, lines_of
from kitrobot.compiler.retranslation import graph_to_lll_again
from kitrobot.compiler.target import program_for
from kitrobot.compiler.tree_diff import same_nodes
from kitrobot.graph.model import IN, NEXT, Arc, Program
from kitrobot.lll.tree import Call, Interrupt, Repeat, Seq
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.robot import Robot


@dataclass(frozen=True)
class Stretch:
    """A body of both trees, and where its items stop and begin again to be equal (`tail` counts from the end)."""

    old: Seq
    new: Seq
    start: int
    tail: int

    def row(self, body: Seq) -> list[Any]:
        return body.items[self.start : len(body.items) - self.tail]


def redraw_edited(seq: Seq, robot: Robot, catalogue: Catalogue, before: Before) -> tuple[Program, Translation]:
    """The graph of an edited text, and its translation back; sets the vertices of the text's nodes.

    Raises KitRobotError when no constructor at hand draws a construct of the text.
    """
    name = before.program.name
    normalise(seq, catalogue)
    drawn = None if before.translation.program == seq else _with_stretch(seq, robot, catalogue, before)
    if drawn is not None:
        translation = graph_to_lll_again(before.translation, drawn, catalogue)
        if translation.program == seq:
            for node, made in zip(nodes(seq), nodes(translation.program), strict=True):
                node.vertex = made.vertex
            return drawn, translation
        for node in nodes(seq):
            node.vertex = None
    return redraw(seq, robot, catalogue, name, before)


def _with_stretch(seq: Seq, robot: Robot, catalogue: Catalogue, before: Before) -> Program | None:
    """The graph with the edited stretch drawn anew; None where the whole must be drawn."""
    if not before.translation.ok:
        return None
    stretch = _differing(before, seq)
    return None if stretch is None else draw_stretch(stretch, robot, catalogue, before)


def draw_stretch(stretch: Stretch, robot: Robot, catalogue: Catalogue, before: Before) -> Program | None:
    """The graph with a stretch drawn anew; None where it cannot be told where that belongs.

    Raises KitRobotError when no constructor at hand draws a construct of the text.
    """
    wiring, program = before.translation.wiring, before.program
    entry = _entry(before, stretch)
    row = stretch.row(stretch.old)
    leaving = wiring.out.get((before.root_of[id(row[-1])], NEXT)) if row else entry
    if entry is None or leaving is None:
        return None

    old = Old(before, same_nodes(Seq(row), Seq(stretch.row(stretch.new))))
    drawing = Drawing(program_for(robot, program.name), robot, catalogue, old)
    title: list[str] = []
    if stretch.old is before.translation.program and stretch.start == 0:
        assert wiring.start is not None, "a graph without Start has an error"
        title = drawing.title = lines_of(wiring.start.notes)
        if stretch.new.items[0].above[: len(title)] != title:
            return None
    last, port = drawing.chain(Seq(stretch.row(stretch.new)), entry.source, entry.out, len(title))
    drawing.arc(last, leaving.target, port, leaving.at)
    return _spliced(before, drawing.program, entry, stretch)


# -- where the trees differ


def _differing(before: Before, new: Seq) -> Stretch | None:
    """The innermost body that holds every difference and whose items are a vertex each."""
    found: Stretch | None = None
    inner: tuple[Seq, Seq] | None = (before.translation.program, new)
    while inner is not None:
        old, new = inner
        if not old.items or not new.items or old.below != new.below or not all(_is_own(before, o) for o in old.items):
            break
        shorter = min(len(old.items), len(new.items))
        start = tail = 0
        while start < shorter and old.items[start] == new.items[start]:
            start += 1
        while tail < shorter - start and old.items[-1 - tail] == new.items[-1 - tail]:
            tail += 1
        found = Stretch(old, new, start, tail)
        row, edited = found.row(old), found.row(new)
        inner = _edited_body(row[0], edited[0]) if len(row) == len(edited) == 1 else None
    return found


def _is_own(before: Before, item: Any) -> bool:
    """Whether an instruction is all that its vertex became."""
    name = before.root_of.get(id(item))
    return name is not None and name not in before.translation.stretches and len(before.roots[name]) == 1


def _edited_body(old: Any, new: Any) -> tuple[Seq, Seq] | None:
    """The one body in which two instructions differ; None when they differ in something else too."""
    if type(old) is not type(new) or isinstance(old, Call | Interrupt):
        return None
    if old.above != new.above or old.after != new.after:
        return None
    if isinstance(old, Repeat) and old.count != new.count:
        return None
    one, other = children(old), children(new)
    if len(one) != len(other):
        return None
    pairs = [(a, b) for a, b in zip(one, other, strict=True) if a != b]
    if len(pairs) != 1 or not (isinstance(pairs[0][0], Seq) and isinstance(pairs[0][1], Seq)):
        return None
    return pairs[0]


# -- in the lists of the graph


def _entry(before: Before, stretch: Stretch) -> Arc | None:
    """The arc that leads into the stretch, or across the place where something is put in."""
    out = before.translation.wiring.out
    if stretch.start > 0:
        return out.get((before.root_of[id(stretch.old.items[stretch.start - 1])], NEXT))
    first = before.root_of[id(stretch.old.items[0])]
    return next((arc for arc in out.values() if arc.target == first and arc.at == IN), None)


def _spliced(before: Before, drawn: Program, entry: Arc, stretch: Stretch) -> Program | None:
    """The graph with the vertices and arcs of the stretch in the places of the old ones."""
    program, out = before.program, before.translation.wiring.out
    gone = {node.vertex for item in stretch.row(stretch.old) for node in nodes(item)} - {None}
    around = gone
    if not gone and stretch.start > 0:
        around = {node.vertex for node in nodes(stretch.old.items[stretch.start - 1])}
    elif not gone:
        around = {stretch.old.items[0].vertex}
    places = [at for at, vertex in enumerate(program.vertices) if vertex.id in around]
    place = places[-1] + 1 if not gone and stretch.start > 0 else places[0]

    arcs: list[Arc] = []
    for arc in program.arcs:
        if arc is entry:
            arcs += drawn.arcs
        elif arc.source in gone:
            if out.get((arc.source, arc.out)) is not arc:
                return None
        elif arc.target in gone:
            return None
        else:
            arcs.append(arc)
    vertices = program.vertices
    kept = [vertex for vertex in vertices[place:] if vertex.id not in gone]
    return replace(program, target=drawn.target, vertices=[*vertices[:place], *drawn.vertices, *kept], arcs=arcs)
