"""Graph → LLL: structure is read off the arcs in one walk, and each vertex becomes its template with the holes filled.

The walk goes from Start along `next`; a constructor's slots are walked when the constructor is met, and each must come
back at its `return`. Nothing here knows any one constructor. Vertices leave their id on every node they became.

The walk can leave holes: what stands in a slot of a vertex, or a vertex of a chain itself, then becomes a `Hole` of the
given name and is not walked. That is how a stretch of a program becomes a template (own_part).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, cast

from kitrobot.compiler.graph import rules
from kitrobot.compiler.graph.expand_template import fill
from kitrobot.compiler.graph.expansion_limit import oversize
from kitrobot.compiler.graph.typed_numbers import nearest_number, typed_number
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.compiler.target import target_of
from kitrobot.diagnostics.model import Diagnostic, Fix, FixKind, Rule
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.lll.tree import MAX_NESTING, MAX_NUMBER, Call, Condition, Hole, Instr, Number, Param, Seq
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, Role
from kitrobot.primitives.robot import Parameter
from kitrobot.text.sentences import Help, Sentence, Word


@dataclass(frozen=True)
class Translation:
    """The program as far as it could be read off the graph, what is wrong with the graph, and how it is wired.

    `stretches`: the instructions in a row that each vertex of a longer template became, those in its hole among them.
    """

    program: Seq
    wiring: Wiring = field(repr=False, compare=False)
    stretches: dict[str, list[Instr]] = field(repr=False, compare=False, default_factory=dict)
    diagnostics: list[Diagnostic] = field(default_factory=list)

    @property
    def ok(self) -> bool:
        """Whether the graph is free of errors."""
        return not any(item.is_error for item in self.diagnostics)


SlotName = tuple[str, str]
"""A vertex and a slot or parameter of it; the slot "" is the vertex itself, where it stands in a chain."""


def graph_to_lll(program: Program, catalogue: Catalogue, holes: Mapping[SlotName, str] | None = None) -> Translation:
    """Translates a program; the rest of it stays usable where something is wrong.

    Args:
        program: the graph.
        catalogue: what its elements mean.
        holes: the slots that are left open, and the name of the hole in each.

    Raises KitRobotError when the catalogue has no such robot.
    """
    found = oversize(program, catalogue)
    if found is not None:
        return Translation(Seq(), Wiring(program, target_of(program, catalogue), catalogue), {}, [found])
    walk = _Walk(program, catalogue, holes or {})
    seq = walk.whole()
    return Translation(seq, walk.wiring, walk.stretches, walk.wiring.found)


def condition_to_lll(
    program: Program, vertex: str, catalogue: Catalogue, holes: Mapping[SlotName, str]
) -> tuple[Condition, list[Diagnostic]]:
    """Translates one vertex of a program as the condition that it is, with holes as in `graph_to_lll`."""
    walk = _Walk(program, catalogue, holes)
    return walk.condition(walk.wiring.vertices[vertex]), walk.wiring.found


class _Walk:
    """One walk over a program."""

    def __init__(self, program: Program, catalogue: Catalogue, holes: Mapping[SlotName, str]) -> None:
        self.holes = holes
        self.stretches: dict[str, list[Instr]] = {}
        self.program = program
        self.robot = target_of(program, catalogue)
        self.catalogue = catalogue
        self.wiring = Wiring(program, self.robot, catalogue)
        self.visited: set[str] = set()
        self.depth = 0
        self.notes: list[str] = []

    def report(
        self,
        rule: Rule,
        message: Sentence,
        *vertices: str,
        help: Help = "",
        arc: Arc | None = None,
        fix: Fix | None = None,
    ) -> None:
        """Collects a diagnostic of this program."""
        arcs = ((arc.source, arc.out, arc.target, arc.at),) if arc is not None else ()
        made = rule(message, help=help, program=self.program.name, vertices=vertices, arcs=arcs, fix=fix)
        self.wiring.report(made)

    def whole(self) -> Seq:
        start, stop = self.wiring.start, self.wiring.stop
        seq = Seq()
        if start is not None:
            self.visited.add(start.id)
            self.chain(seq, start.id, NEXT, None)
            self.notes = [line for note in start.notes for line in note.lines]
            if self.notes:
                (seq.items[0].above if seq.items else seq.below)[:0] = self.notes
        if stop is not None:
            self.visited.add(stop.id)
            seq.below += [line for note in stop.notes for line in note.lines]
        self.parked()
        return seq

    def parked(self) -> None:
        """Reports each piece that nothing leads to, by its first vertex (any of it where it is a ring).

        What hangs on a vertex that was visited is not parked: it was not walked because of a mistake that was reported.
        """
        behind: dict[str, list[str]] = {}
        for arc in self.wiring.out.values():
            if arc.at == IN:
                behind.setdefault(arc.source, []).append(arc.target)
            elif arc.at != RETURN:
                behind.setdefault(arc.target, []).append(arc.source)
        followers = {vertex for source, vertices in behind.items() for vertex in vertices if vertex != source}
        reached = set(self.visited)
        waiting = list(self.visited)
        heads = [vertex for vertex in self.wiring.vertices if vertex not in followers]
        for vertex in (None, *heads, *self.wiring.vertices):
            if vertex is not None and vertex not in reached:
                element = self.wiring.vertices[vertex].element
                message = Sentence(
                    "nothing leads to {element} (`{vertex}`), so it is not part of the program", Word(element), vertex
                )
                self.report(rules.PARKED, message, vertex, help=Sentence("join it to the flow, or leave it parked"))
                reached.add(vertex)
                waiting.append(vertex)
            while waiting:
                for follower in behind.get(waiting.pop(), ()):
                    if follower not in reached:
                        reached.add(follower)
                        waiting.append(follower)

    # -- chains

    def chain(self, seq: Seq, vertex: str, port: str, inside: str | None) -> None:
        """Fills `seq` with what follows a port, up to Stop (`inside` None) or the `return` of the vertex `inside`."""
        while True:
            arc = self.wiring.out.get((vertex, port))
            if arc is None:
                self.not_closed(vertex, port, inside)
                return
            target = self.wiring.vertices[arc.target]
            if arc.at == RETURN:
                if target.id != inside:
                    self.wrong_way(
                        arc,
                        Sentence(
                            "`{source}` leads to the `return` of `{target}`, which it is not inside of",
                            arc.source,
                            target.id,
                        ),
                    )
                return
            if arc.at != IN:
                self.wrong_way(
                    arc,
                    Sentence(
                        "`{source}` stands in the flow and fills the slot `{at}` of `{target}` too",
                        arc.source,
                        arc.at,
                        target.id,
                    ),
                )
                return
            if target.element == STOP:
                if inside is not None:
                    self.not_closed(vertex, port, inside, arc)
                return
            if target.id in self.visited:
                self.wrong_way(
                    arc,
                    Sentence(
                        "`{source}` leads to `{target}`, which stands elsewhere in the program already",
                        arc.source,
                        target.id,
                    ),
                )
                return
            self.visited.add(target.id)
            hole = self.hole(target, "") if self.holes else None
            if hole is not None:
                self.put(target, seq, Seq(hole=hole))
            else:
                self.instruction(seq, target)
            vertex, port = target.id, NEXT

    def not_closed(self, vertex: str, port: str, inside: str | None, arc: Arc | None = None) -> None:
        where = f"`{vertex}`" if port == NEXT else Sentence("the slot `{port}` of `{vertex}`", port, vertex)
        if inside is None:
            message = Sentence("the way from {where} never reaches Stop", where)
            help = Sentence("draw an arc from `{vertex}` on to Stop", vertex)
        else:
            message = Sentence("the way from {where} does not come back to `{constructor}`", where, inside)
            help = Sentence("draw an arc to the `return` of `{constructor}`", inside)
        self.report(rules.NOT_CLOSED, message, vertex, help=help, arc=arc)

    def wrong_way(self, arc: Arc, message: Sentence) -> None:
        help = Sentence("delete the arc, or draw it anew")
        self.report(rules.WRONG_WAY, message, arc.source, arc.target, help=help, arc=arc)

    # -- holes

    def hole(self, vertex: Vertex, slot: str) -> Hole | None:
        """The hole that is left where that slot of that vertex would be walked."""
        name = self.holes.get((vertex.id, slot))
        return None if name is None else Hole(name, vertex=vertex.id)

    def put(self, vertex: Vertex, seq: Seq, more: Seq) -> None:
        """Adds instructions, and the hole among them, to a body; vertices in a row may share one hole."""
        if more.hole is not None:
            at = len(seq.items) + more.hole_at
            if seq.hole is not None and (seq.hole.name, seq.hole_at) != (more.hole.name, at):
                message = Sentence(
                    "`{hole}` and `{other}` are two places for instructions in one body", seq.hole.name, more.hole.name
                )
                help = Sentence("choose one place in a body, or give neighbours the same name")
                self.report(rules.TWO_HOLES, message, vertex.id, help=help)
            seq.hole, seq.hole_at = more.hole, at
        seq.items += more.items
        seq.below += more.below

    # -- vertices

    def instruction(self, seq: Seq, vertex: Vertex) -> None:
        """Adds the instructions a vertex in the flow becomes: one, or those of a longer template."""
        notes, self.notes = self.notes, []
        constructor = self.wiring.constructor(vertex)
        row = Seq()
        if constructor is None:
            row.items.append(self.call(vertex))
        elif constructor.role is not Role.INSTRUCTION or constructor.template is None:
            self.report(
                rules.WRONG_PLACE,
                Sentence(
                    "`{vertex}` ({element}) cannot stand in the flow as an instruction", vertex.id, Word(vertex.element)
                ),
                vertex.id,
            )
        else:
            self.look_at_level(vertex, constructor)
            filled = fill(self, vertex, constructor)
            if isinstance(filled, Seq):
                row = filled
                self.notes += row.below  # no body ends here, so they go above, as those of conditions do
                row.below = []
                self.stretches[vertex.id] = row.items
            else:
                row.items.append(filled)
        made: list[Any] = row.items
        inner, self.notes = self.notes, notes
        if made and (vertex.notes or inner):
            above = [line for note in vertex.notes if note.at == "" for line in note.lines]
            made[0].above = above + inner + made[0].above
            after = [" ".join(note.text.split("\n")) for note in vertex.notes if note.at == "after"]
            if after:
                made[-1].after = " ".join([*filter(None, (made[-1].after,)), *after]).rstrip()
        self.put(vertex, seq, row)

    def look_at_level(self, vertex: Vertex, constructor: Constructor) -> None:
        """Reports what speaks of more robots than the program does."""
        if not self.program.level.holds(constructor.level):
            message = Sentence(
                "`{vertex}` ({element}) stands in a program of the level {level}; this is one of the level {found}",
                vertex.id,
                Word(vertex.element),
                Word(constructor.level),
                Word(self.program.level),
            )
            self.report(rules.WRONG_LEVEL, message, vertex.id, help=Sentence("put it into the team's program"))

    def call(self, vertex: Vertex) -> Call:
        name, _, method = vertex.element.partition(".")
        call = Call(name if method else "", method, vertex=vertex.id)
        meaning = self.robot.calls.get((name, method))
        if meaning is not None:
            parameters, fills = meaning[1].parameters, self.wiring.fills
            nests = any((vertex.id, parameter.name) in fills for parameter in parameters)
            if nests and not self.deeper(vertex):
                return Call("", "", vertex=vertex.id)
            call.params = [self.parameter(vertex, parameter) for parameter in parameters]
            self.depth -= nests
            known = [parameter.name for parameter in parameters]
            for setting in vertex.settings:
                if setting not in known:
                    message = Sentence(
                        "`{vertex}` ({element}) has no parameter `{setting}`", vertex.id, Word(vertex.element), setting
                    )
                    fix = Fix("", FixKind.UNSET, setting)
                    self.report(rules.NOT_A_NUMBER, message, vertex.id, help=Sentence("take the setting away"), fix=fix)
        else:
            call.params = [
                Number(int(text))
                for text in vertex.settings.values()
                if text.isascii() and text.isdigit() and len(text) < 6
            ]
        return call

    def parameter(self, vertex: Vertex, parameter: Parameter) -> Param:
        hole = self.hole(vertex, parameter.name) if self.holes else None
        if hole is not None:
            return hole
        filler = self.wiring.fills.get((vertex.id, parameter.name))
        if filler is not None:
            return self.read(self.wiring.vertices[filler])
        text = vertex.settings.get(parameter.name, str(max(0, parameter.default)))
        return Number(self.number(vertex, parameter.name, text, 0, MAX_NUMBER), vertex=vertex.id)

    def number(self, vertex: Vertex, name: str, text: str, low: int, high: int) -> int:
        typed = typed_number(text, low, high)
        if typed is not None:
            return typed
        shown = text if len(text) <= 24 else text[:21] + "…"
        message = Sentence(
            "expected a whole number from {low} to {high} as the {parameter} of `{vertex}`, found `{found}`",
            low,
            high,
            Word(name),
            vertex.id,
            shown,
        )
        nearest = nearest_number(text, low, high)
        fix = None if nearest is None else Fix(str(nearest), FixKind.SETTING, name)
        help = Sentence("write a number from {minimum} to {maximum}", low, high)
        self.report(rules.NOT_A_NUMBER, message, vertex.id, help=help, fix=fix)
        return low

    # -- templates

    def deeper(self, vertex: Vertex) -> bool:
        """Goes a level down, as the parser counts them: bodies, joined conditions, calls in parameters."""
        if self.depth < MAX_NESTING:
            self.depth += 1
            return True
        message = Sentence("the program nests more than {most} levels deep here", MAX_NESTING)
        self.report(rules.TOO_DEEP, message, vertex.id)
        return False

    def body(self, vertex: Vertex, port: str) -> Seq:
        seq = Seq()
        self.chain(seq, vertex.id, port, vertex.id)
        if vertex.notes:
            seq.below += [line for note in vertex.notes if note.at == f"in:{port}" for line in note.lines]
        return seq

    def condition(self, vertex: Vertex) -> Condition:
        """What a vertex that fills a condition slot becomes."""
        constructor = self.wiring.constructor(vertex)
        if constructor is None:
            return self.read(vertex)
        if not self.enter(vertex):
            return Call("", "")
        if constructor.role is not Role.CONDITION:
            message = Sentence("`{vertex}` ({element}) is no condition", vertex.id, Word(vertex.element))
            self.report(rules.WRONG_PLACE, message, vertex.id)
            return Call("", "")
        self.look_at_level(vertex, constructor)
        return cast("Condition", fill(self, vertex, constructor))

    def read(self, vertex: Vertex) -> Call:
        """The call that a test, value or action vertex is."""
        if not self.enter(vertex):
            return Call("", "")
        if "." not in vertex.element or self.wiring.constructor(vertex) is not None:
            if vertex.element in (START, STOP) or self.wiring.constructor(vertex) is not None:  # others are unknown
                message = Sentence("`{vertex}` ({element}) does not fit into a slot", vertex.id, Word(vertex.element))
                self.report(rules.WRONG_PLACE, message, vertex.id)
            return Call("", "")
        return self.call(vertex)

    def enter(self, vertex: Vertex) -> bool:
        """Visits a filler once; its notes go to the instruction around it, since conditions hold no comments."""
        if vertex.id in self.visited:
            message = Sentence(
                "`{vertex}` ({element}) stands elsewhere in the program already", vertex.id, Word(vertex.element)
            )
            self.report(rules.WRONG_WAY, message, vertex.id, help=Sentence("take a copy of it"))
            return False
        self.visited.add(vertex.id)
        self.notes += [line for note in vertex.notes for line in note.lines]
        return True
