"""The arcs of a program by port, and what is wrong with them one by one.

After this, every arc that is left joins two vertices that exist at ports that exist, one arc a port; the walk over the
graph (graph_to_lll) need not look at single arcs again.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

from kitrobot.compiler.graph import rules
from kitrobot.compiler.target import words_for
from kitrobot.diagnostics.model import ArcName, Diagnostic, Fix, FixKind
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, SlotKind
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence, Word
from kitrobot.text.suggestions import Suggestions


class Wiring:
    """`out[vertex, port]` is the one arc that leaves there; `fills[vertex, slot]` the vertex that fills that slot;
    `ports[vertex]` the out-ports that are used.
    """

    def __init__(self, program: Program, robot: Robot, catalogue: Catalogue) -> None:
        self.program = program
        self.robot = robot
        self.catalogue = catalogue
        self.suggestions = Suggestions()
        self.found: list[Diagnostic] = []
        self.vertices: dict[str, Vertex] = {}
        self.out: dict[tuple[str, str], Arc] = {}
        self.fills: dict[tuple[str, str], str] = {}
        self.ports: dict[str, list[str]] = {}
        for vertex in program.vertices:
            self.add_vertex(vertex)
        self.start = self._only(START)
        self.stop = self._only(STOP)
        for what, end in ((Word(START), self.start), (Word(STOP), self.stop)):
            if end is None:
                message = Sentence("the program has no vertex {vertex}", what)
                self.report(rules.START_STOP(message, help=Sentence("add a vertex {vertex}", what), **self._at()))
        for arc in program.arcs:
            self.add_arc(arc)

    def report(self, diagnostic: Diagnostic) -> None:
        """Collects a diagnostic of this program."""
        self.found.append(diagnostic)

    def constructor(self, vertex: Vertex) -> Constructor | None:
        """The constructor a vertex is of, or None."""
        return self.catalogue.constructors.get(vertex.element)

    def add_vertex(self, vertex: Vertex) -> None:
        """Adds a vertex, and reports what is wrong with it."""
        if vertex.id in self.vertices:
            self.report(
                rules.SAME_ID(
                    Sentence("the id `{vertex}` is used twice", vertex.id),
                    help=Sentence("give one of them another id"),
                    **self._at(vertex.id),
                )
            )
            return
        self.vertices[vertex.id] = vertex
        if vertex.element not in (START, STOP) and self.constructor(vertex) is None:
            self._check_call(vertex)

    def _only(self, element: str) -> Vertex | None:
        """The one vertex that is Start, or Stop; a second one is reported."""
        found = [vertex for vertex in self.vertices.values() if vertex.element == element]
        for extra in found[1:]:
            message = Sentence("the program has a second {element}", Word(element))
            self.report(
                rules.START_STOP(message, help=Sentence("delete one of them"), **self._at(found[0].id, extra.id))
            )
        return found[0] if found else None

    @cached_property
    def _calls(self) -> list[str]:
        """The names of everything that the robot offers."""
        return [f"{name}.{method}" for name, method in self.robot.calls]

    def _check_call(self, vertex: Vertex) -> None:
        name, dot, method = vertex.element.partition(".")
        if dot and name and method and (name, method) in self.robot.calls:
            return
        where = words_for(self.robot) if dot else Sentence("the constructors' XML")
        near = (
            self._nearest_call(name, method)
            if dot
            else self.suggestions.nearest(vertex.element, self.catalogue.constructors)
        )
        self.report(
            rules.UNKNOWN_ELEMENT(
                Sentence("`{element}` is not in {where}", vertex.element, where),
                help=Sentence("did you mean {near}?", near)
                if near
                else Sentence("bring its XML file back, or delete the vertex"),
                fix=Fix(near, FixKind.ELEMENT, near) if near else None,
                **self._at(vertex.id),
            )
        )

    def _nearest_call(self, name: str, method: str) -> str:
        """The call of the robot that was meant, or ""."""
        calls = self.robot.calls
        near = self.suggestions.nearest(name, dict.fromkeys(known for known, _ in calls))
        of_it = self.suggestions.nearest(method, [known for owner, known in calls if owner == near])
        return f"{near}.{of_it}" if of_it else ""

    def add_arc(self, arc: Arc) -> None:
        """Adds an arc between vertices that were added, or reports why it cannot be."""
        name: ArcName = (arc.source, arc.out, arc.target, arc.at)
        if arc.source not in self.vertices or arc.target not in self.vertices:
            end = arc.target if arc.source in self.vertices else arc.source
            self.report(
                rules.DANGLING_ARC(
                    Sentence(
                        "an arc from `{source}` to `{target}` names `{end}`, which is not there",
                        arc.source,
                        arc.target,
                        end,
                    ),
                    help=self.suggestions.did_you_mean(end, self.vertices) or Sentence("delete the arc"),
                    program=self.program.name,
                    arcs=(name,),
                )
            )
            return
        if not self._has_out(self.vertices[arc.source], arc.out):
            self._no_port(arc, name, arc.source, arc.out, Sentence("nothing leaves"))
        elif not self._has_in(self.vertices[arc.target], arc.at):
            self._no_port(arc, name, arc.target, arc.at, Sentence("nothing arrives"))
        elif (arc.source, arc.out) in self.out:
            other = self.out[arc.source, arc.out]
            self._twice(Sentence("two arcs leave `{source}` at `{out}`", arc.source, arc.out), arc, other, name)
        elif arc.at not in (IN, RETURN) and (arc.target, arc.at) in self.fills:
            other = self.out[self.fills[arc.target, arc.at], NEXT]
            self._twice(Sentence("two parts fill the slot `{at}` of `{target}`", arc.at, arc.target), arc, other, name)
        else:
            self.out[arc.source, arc.out] = arc
            self.ports.setdefault(arc.source, []).append(arc.out)
            if arc.at not in (IN, RETURN):
                self.fills[arc.target, arc.at] = arc.source

    def _twice(self, message: Sentence, arc: Arc, other: Arc, name: ArcName) -> None:
        self.report(
            rules.TWO_ARCS(
                message,
                help=Sentence("delete one of them"),
                program=self.program.name,
                vertices=(arc.source,),
                arcs=((other.source, other.out, other.target, other.at), name),
            )
        )

    def _no_port(self, arc: Arc, name: ArcName, vertex: str, port: str, what: str) -> None:
        element = self.vertices[vertex].element
        self.report(
            rules.DANGLING_ARC(
                Sentence(
                    "`{vertex}` ({element}) has no port `{port}`, so {what} there", vertex, Word(element), port, what
                ),
                help=Sentence("delete the arc, or draw it anew"),
                program=self.program.name,
                vertices=(vertex,),
                arcs=(name,),
            )
        )

    def _has_out(self, vertex: Vertex, port: str) -> bool:
        if port == NEXT:
            return vertex.element != STOP
        constructor = self.constructor(vertex)
        if constructor is None:
            return vertex.element not in (START, STOP) and not self._is_known_call(vertex)
        slot = constructor.slot(port)
        if slot is not None:
            return slot.kind is SlotKind.FLOW and not slot.repeat
        base, _, number = port.rpartition(".")
        slot = constructor.slot(base)
        counts = number.isascii() and number.isdigit() and not number.startswith("0") and len(number) <= 4
        return slot is not None and slot.kind is SlotKind.FLOW and slot.repeat and counts

    def _has_in(self, vertex: Vertex, port: str) -> bool:
        if port == IN:
            return vertex.element != START
        if vertex.element in (START, STOP):
            return False
        constructor = self.constructor(vertex)
        if constructor is not None:
            if port == RETURN:
                return any(slot.kind is SlotKind.FLOW for slot in constructor.slots)
            slot = constructor.slot(port)
            return slot is not None and slot.kind in (SlotKind.CONDITION, SlotKind.VALUE, SlotKind.ACTION)
        if not self._is_known_call(vertex):
            return True
        name, _, method = vertex.element.partition(".")
        return any(port == parameter.name for parameter in self.robot.calls[name, method][1].parameters)

    def _is_known_call(self, vertex: Vertex) -> bool:
        name, _, method = vertex.element.partition(".")
        return (name, method) in self.robot.calls

    def _at(self, *vertices: str) -> dict[str, Any]:
        return {"program": self.program.name, "vertices": vertices}
