"""LLL → graph: templates run backwards.

A construct becomes a vertex of the most specific constructor whose template it is made from (`Catalogue.drawn`);
matching the template against the node says which part of the node fills which slot. Where a number is outside the range
of its slot, the constructor is the one whose template is that very construct around distinct holes. Ids are v1, v2, …
in reading order.

Drawn beside the graph that the text came from (`keep`), an instruction that is still there keeps its vertex, also one
of a constructor whose template is more than one construct, as long as the text is still made from that template.
The result is read back: where it does not say what the text says (a note that had two homes, a slot that was
filled twice), it is drawn once more with less of the old.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from kitrobot.compiler.graph.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.target import program_for
from kitrobot.compiler.text.accepted_forms import normalise
from kitrobot.compiler.text.preserve_ids import Before, Branch, Old, Origin, Row, lines_of, note, nothing_before
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Note, Program, Vertex
from kitrobot.lll.printer import print_members
from kitrobot.lll.tree import Call, Instruction, Members, Node, Number, Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, SlotKind
from kitrobot.primitives.match_template import Bound, unfill, unfill_all, unfill_row
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.templates import shape
from kitrobot.text.sentences import Sentence


def lll_to_graph(
    seq: Seq,
    robot: Robot,
    catalogue: Catalogue,
    name: str,
    keep: Program | None = None,
    *,
    apart_from: str = "",
) -> Program:
    """The graph of an LLL program. Sets the vertices of its nodes, and writes anew what is written differently today.

    Args:
        seq: the program; its places do not matter.
        robot: the robot it is for.
        catalogue: the constructors to draw with.
        name: the name of the graph.
        keep: the graph to take over as much from as can be; the same text gives this very graph back.
        apart_from: the constructor that is not drawn, as long as there is another.

    Raises KitRobotError when no constructor at hand is the inverse of a construct the program uses, or the catalogue
    lacks the robot that `keep` is for.
    """
    if keep is not None:
        return redraw(seq, robot, catalogue, name, Before(graph_to_lll(keep, catalogue)))[0]
    normalise(seq, catalogue)
    old = Old(nothing_before(robot, catalogue), {})
    return Drawing(program_for(robot, name), robot, catalogue, old, apart_from=apart_from).whole(seq)


def redraw(seq: Seq, robot: Robot, catalogue: Catalogue, name: str, before: Before) -> tuple[Program, Translation]:
    """`lll_to_graph` with a graph to keep: the graph, and its translation back."""
    normalise(seq, catalogue)
    tree = before.translation.program
    if tree == seq:
        for node, was in zip(nodes(seq), nodes(tree), strict=True):
            node.vertex = was.vertex
        return replace(before.program, name=name, target=robot.name, level=robot.level), before.translation
    old = Old.beside(before, seq)
    drawn, translation = program_for(robot, name), before.translation
    for notes_anew in (False, True):
        drawn = Drawing(program_for(robot, name), robot, catalogue, old, notes_anew=notes_anew).whole(seq)
        old.leave(drawn, loose_only=notes_anew)
        translation = graph_to_lll(drawn, catalogue)
        if translation.program == seq:
            for node, made in zip(nodes(seq), nodes(translation.program), strict=True):
                node.vertex = made.vertex
            break
    return drawn, translation


@dataclass(frozen=True)
class _Choice:
    """What an instruction is drawn as: an element, what its slots hold, and the vertex it was before, if any.

    `before` is what the slots held then, when it was the same element; `width` counts the instructions it stands for.
    `hole`: the slot whose instructions are among those, first of them (`begins_inside`) or last (`ends_inside`).
    """

    element: str
    constructor: Constructor | None = None
    bound: Bound | None = None
    origin: Origin | None = None
    before: Any = None
    width: int = 1
    begins_inside: bool = False
    ends_inside: bool = False
    hole: str = ""


class Drawing:
    """A program being drawn from its text."""

    def __init__(
        self,
        program: Program,
        robot: Robot,
        catalogue: Catalogue,
        old: Old,
        *,
        notes_anew: bool = False,
        apart_from: str = "",
    ) -> None:
        self.program = program
        self.robot = robot
        self.catalogue = catalogue
        self.old = old
        self.notes_anew = notes_anew
        self.apart_from = apart_from
        self.number = old.highest_number
        self.used: set[str] = set()
        self.title: list[str] = []
        """Start's notes, which stand above the first instruction."""

    def whole(self, seq: Seq) -> Program:
        start, stop = self.old.end(START), self.old.end(STOP)
        self.used |= {start.id, stop.id}
        self.title = lines_of(start.notes)
        top = seq.items[0].above if seq.items else seq.below
        if self.notes_anew or top[: len(self.title)] != self.title:
            start.notes, self.title = [], []
        self.program.vertices.append(start)
        last, port = self.chain(seq, start.id, NEXT, len(self.title))
        below = seq.below[0 if seq.items else len(self.title) :]
        if lines_of(stop.notes) != below:
            stop.notes = note(below)
        self.program.vertices.append(stop)
        self.arc(last, stop.id, port)
        return self.program

    def arc(self, source: str, target: str, out: str = NEXT, at: str = IN) -> None:
        self.program.arcs.append(Arc(source, target, out, at))

    def vertex(self, choice: _Choice) -> Vertex:
        """The vertex of an instruction: the one it was, or a new one."""
        if choice.origin is None:
            self.number += 1
            vertex = Vertex(f"v{self.number}", choice.element)
        else:
            was = choice.origin.vertex
            settings = dict(was.settings) if was.element == choice.element else {}
            # By hand: `replace` takes ten times as long.
            vertex = Vertex(was.id, choice.element, settings, list(was.notes), was.unknown)
        self.used.add(vertex.id)
        self.program.vertices.append(vertex)
        return vertex

    def chain(self, seq: Seq, source: str, port: str, title: int = 0) -> tuple[str, str]:
        """Draws a body behind a port; the port from which it goes on. The first `title` comments are not its own."""
        at = 0
        rows = self.old.rows(seq.items)
        while at < len(seq.items):
            was = None if self.notes_anew or at in rows or (title and at == 0) else self.old.unchanged(seq.items[at])
            if was is not None and was.vertex not in self.used:
                self.arc(source, was.vertex, port)
                self.keep(was)
                source, port, at = was.vertex, NEXT, at + 1
                continue
            choice = self.row(rows.get(at, []), seq.items, at) or self.choose(seq.items[at], seq, at)
            vertex = self.vertex(choice)
            self.arc(source, vertex.id, port)
            for node in seq.items[at : at + choice.width]:
                node.vertex = vertex.id
            first, last = seq.items[at], seq.items[at + choice.width - 1]
            own = title if at == 0 else 0
            bare = self.notes(vertex, choice, first.above[own:], last)
            self.inside(vertex, first, choice, bare, own if choice.begins_inside else 0)
            source, port = vertex.id, NEXT
            at += choice.width
        return source, port

    def keep(self, was: Instruction) -> None:
        """Takes over an instruction in which nothing changed: its vertices, and the arcs in it, as they are."""
        vertices, arcs = self.old.parts_of(was)
        self.used |= {vertex.id for vertex in vertices}
        self.program.vertices += vertices
        self.program.arcs += arcs

    def notes(self, vertex: Vertex, choice: _Choice, above: list[str], last: Instruction) -> bool:
        """Sets the notes above and behind an instruction; whether what stands in its slots may bring none."""
        kept = [one for one in vertex.notes if one.at not in ("", "after")]
        over = [one for one in vertex.notes if one.at == ""]
        behind = [one for one in vertex.notes if one.at == "after"]
        after, bare = last.after, True
        if choice.origin is not None and not self.notes_anew:
            before = choice.origin.nodes
            first = bool(self.old.tree.items) and self.old.tree.items[0] is before[0]
            bare = before[0].above[len(self.title) if first else 0 :] != above
            if before[-1].after == after:
                after = None
            else:
                behind = []
        else:
            behind = []
        # What a vertex in the hole says stays with that one.
        anew = [] if choice.begins_inside else note(above)
        vertex.notes = (anew if bare else over) + behind
        if after is not None and not choice.ends_inside:
            vertex.notes.append(Note(after, "after"))
        vertex.notes += kept
        return bare

    # -- which element

    def choose(self, node: Node, body: Seq, at: int = 0) -> _Choice:
        """What a node is drawn as; an instruction stands in `body` at the place `at`."""
        origin = self.old.origin(node)
        if origin is not None and origin.vertex.id in self.used:
            origin = None
        if origin is not None:
            kept = self.still(origin, node, body, at)
            if kept is not None:
                return kept
        if isinstance(node, Call):
            element = f"{node.object}.{node.method}"
            same = origin is not None and origin.vertex.element == element and isinstance(origin.nodes[0], Call)
            return _Choice(element, origin=origin, before=origin.nodes[0] if origin is not None and same else None)
        kind = shape(node)
        for constructor in self.catalogue.drawn.get(kind, ()):
            assert constructor.template is not None, "only what has a template is drawn"
            bound = unfill(constructor, constructor.template, node)
            if bound is not None and constructor.name != self.apart_from and self.robot.level.holds(constructor.level):
                return _Choice(constructor.name, constructor, bound, origin)
        inverse = self.catalogue.inverse.get(kind)
        if inverse is None:
            raise KitRobotError(
                Sentence("no constructor at hand draws the LLL construct {name}", type(node).__name__),
                Sentence("bring back the constructors' XML that was shipped"),
            )
        assert inverse.template is not None, "only what has a template is an inverse"
        return _Choice(inverse.name, inverse, unfill(inverse, inverse.template, node, any_number=True), origin)

    def still(self, origin: Origin, node: Node, body: Seq, at: int) -> _Choice | None:
        """The constructor that the vertex was of, where its template still stands in the text."""
        constructor = self.catalogue.constructors.get(origin.vertex.element)
        if constructor is None or constructor.template is None:
            return None
        template = constructor.template
        if not isinstance(template, Seq):
            bound = unfill(constructor, template, node)
            before = unfill(constructor, template, origin.nodes[0])
            return None if bound is None else _Choice(constructor.name, constructor, bound, origin, before)
        width = len(template.items)
        if template.hole is not None or template.below or width == 0:
            return None
        bound = unfill_all(constructor, template.items, body.items[at : at + width])
        before = unfill_all(constructor, template.items, origin.nodes)
        return None if bound is None else _Choice(constructor.name, constructor, bound, origin, before, width)

    def row(self, rows: list[Row], items: list[Any], at: int) -> _Choice | None:
        """A vertex whose own instructions stand around others, where its template still stands in the text."""
        for one in rows:
            vertex = one.origin.vertex
            constructor = self.catalogue.constructors[vertex.element]
            template = constructor.template
            assert isinstance(template, Seq), "rows are of templates with several instructions"
            assert template.hole is not None, "rows are of templates with a hole among them"
            nodes = items[at : one.end]
            bound = None if vertex.id in self.used else unfill_row(constructor, template, nodes)
            if bound is None:
                continue
            before = unfill_row(constructor, template, one.origin.nodes)
            held = len(bound[template.hole.name].items) > 0
            return _Choice(
                constructor.name,
                constructor,
                bound,
                one.origin,
                before,
                len(nodes),
                begins_inside=held and template.hole_at == 0,
                ends_inside=held and template.hole_at == len(template.items),
                hole=template.hole.name,
            )
        return None

    # -- what it holds

    def inside(self, vertex: Vertex, node: Any, choice: _Choice, bare: bool, title: int = 0) -> None:
        """Fills the slots of a vertex from its node: settings, fillers, bodies."""
        below = [one for one in vertex.notes if one.at.startswith("in:")]
        vertex.notes = [one for one in vertex.notes if not one.at.startswith("in:")]
        if choice.constructor is None:
            self.params(vertex, node, choice, bare)
            return
        assert choice.bound is not None, "an inverse fits its shape"
        before: Bound = choice.before or {}
        for slot in choice.constructor.slots:
            content, was = choice.bound[slot.name], before.get(slot.name)
            if slot.kind is SlotKind.FLOW and slot.repeat:
                branches = [Branch(body) for body in content]
                if choice.origin is not None and was is not None:
                    branches = self.old.branches(choice.origin, slot.name, was, content)
                for number, branch in enumerate(branches, 1):
                    self.body(vertex, f"{slot.name}.{number}", branch.body, _at(below, branch.port), bare=bare)
            elif slot.kind is SlotKind.FLOW and slot.name == choice.hole:
                vertex.notes += [] if bare else _at(below, slot.name)  # they stand above, where nothing changed
                last, out = self.chain(content, vertex.id, slot.name, title)
                self.arc(last, vertex.id, out, RETURN)
            elif slot.kind is SlotKind.FLOW:
                self.body(vertex, slot.name, content, _at(below, slot.name))
            elif isinstance(content, Node) and not isinstance(content, Number | Members):
                self.filler(vertex, slot.name, content, bare)
            else:
                self.setting(vertex, slot.name, content, was)

    def setting(self, vertex: Vertex, name: str, value: Any, was: Any) -> None:
        """What was typed; what says the same as before stays as it was written."""
        if was is None or value != was:
            written = print_members(value) if isinstance(value, Members) else value
            vertex.settings[name] = str(written.value if isinstance(written, Number) else written)

    def body(self, vertex: Vertex, port: str, seq: Seq, notes: list[Note], *, bare: bool = True) -> None:
        """A body, with the notes that stood at its end before. An empty branch keeps them unless `bare`."""
        if lines_of(notes) == seq.below or not (bare or seq.items):
            vertex.notes += [replace(one, at=f"in:{port}") for one in notes]
        else:
            vertex.notes += note(seq.below, f"in:{port}")
        last, out = self.chain(seq, vertex.id, port)
        self.arc(last, vertex.id, out, RETURN)

    def filler(self, vertex: Vertex, slot: str, node: Any, bare: bool) -> None:
        choice = self.choose(node, Seq())
        filler = self.vertex(choice)
        node.vertex = filler.id
        if bare:
            filler.notes = []
        self.arc(filler.id, vertex.id, NEXT, slot)
        self.inside(filler, node, choice, bare)

    def params(self, vertex: Vertex, call: Call, choice: _Choice, bare: bool) -> None:
        meaning = self.robot.calls.get((call.object, call.method))
        before = choice.before.params if isinstance(choice.before, Call) else []
        if meaning is not None:
            names = [parameter.name for parameter in meaning[1].parameters]
        else:
            names = list(vertex.settings) if len(vertex.settings) == len(before) else []
        names += [f"parameter{number}" for number in range(len(names) + 1, len(call.params) + 1)]
        for index, (name, param) in enumerate(zip(names, call.params, strict=False)):
            if isinstance(param, Number):
                self.setting(vertex, name, param, before[index] if index < len(before) else None)
            elif isinstance(param, Call):
                self.filler(vertex, name, param, bare)
        if meaning is None:
            for name in names[len(call.params) :]:
                vertex.settings.pop(name, None)


def _at(notes: list[Note], port: str | None) -> list[Note]:
    return [one for one in notes if one.at == f"in:{port}"]
