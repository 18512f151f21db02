"""LLL → graph: templates run backwards.

A construct becomes a vertex of the constructor whose template is that very construct around distinct holes; matching
the template against the node says which part of the node fills which slot. Ids are v1, v2, … in reading order.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from kitrobot.diagnostics import KitRobotError
from kitrobot.graph import IN, NEXT, RETURN, START, STOP, Arc, Note, Program, Vertex
from kitrobot.lll import Call, Hole, Instruction, Node, Number, Seq
from kitrobot.primitives import Catalogue, Constructor, Robot, SlotKind, shape


def lll_to_graph(program: Seq, robot: Robot, catalogue: Catalogue, name: str) -> Program:
    """The graph of an LLL program.

    Raises KitRobotError when no constructor at hand is the inverse of a construct the program uses.
    """
    drawing = _Drawing(Program(name, robot.name), robot, catalogue)
    drawing.whole(program)
    return drawing.program


class _Drawing:
    def __init__(self, program: Program, robot: Robot, catalogue: Catalogue) -> None:
        self.program = program
        self.robot = robot
        self.catalogue = catalogue
        self.count = 0

    def whole(self, seq: Seq) -> None:
        self.program.vertices.append(Vertex("start", START))
        last, port = self.chain(seq, "start", NEXT)
        stop = Vertex("stop", STOP)
        if seq.below:
            stop.notes.append(Note("\n".join(seq.below)))
        self.program.vertices.append(stop)
        self.arc(last, "stop", port)

    def arc(self, source: str, target: str, out: str = NEXT, at: str = IN) -> None:
        self.program.arcs.append(Arc(source, target, out, at))

    def vertex(self, element: str) -> Vertex:
        self.count += 1
        vertex = Vertex(f"v{self.count}", element)
        self.program.vertices.append(vertex)
        return vertex

    def chain(self, seq: Seq, source: str, port: str) -> tuple[str, str]:
        """Draws a body behind a port; the port from which it goes on."""
        for node in seq.items:
            element, constructor = self.element(node)
            vertex = self.vertex(element)
            self.arc(source, vertex.id, port)
            self.notes(vertex, node)
            self.inside(vertex, node, constructor)
            source, port = vertex.id, NEXT
        return source, port

    def notes(self, vertex: Vertex, node: Instruction) -> None:
        if node.above:
            vertex.notes.append(Note("\n".join(node.above)))
        if node.after is not None:
            vertex.notes.append(Note(node.after, "after"))

    def element(self, node: Node) -> tuple[str, Constructor | None]:
        if isinstance(node, Call):
            return f"{node.object}.{node.method}", None
        constructor = self.catalogue.inverse.get(shape(node))
        if constructor is None:
            raise KitRobotError(
                f"no constructor at hand draws the LLL construct {type(node).__name__}",
                "bring back the constructors' XML that was shipped",
            )
        return constructor.name, constructor

    def inside(self, vertex: Vertex, node: Any, constructor: Constructor | None) -> None:
        """Fills the slots of a vertex from its node: settings, fillers, bodies."""
        if constructor is None:
            self.params(vertex, node)
            return
        matched = _match(constructor.template, node)
        for slot in constructor.slots:
            content = matched[slot.name]
            match slot.kind:
                case SlotKind.FLOW:
                    bodies = content if slot.repeat else [content]
                    for number, body in enumerate(bodies, 1):
                        self.body(vertex, f"{slot.name}.{number}" if slot.repeat else slot.name, body)
                case SlotKind.CONDITION | SlotKind.ACTION:
                    self.filler(vertex, slot.name, content)
                case _:
                    vertex.settings[slot.name] = str(content)

    def body(self, vertex: Vertex, port: str, seq: Seq) -> None:
        if seq.below:
            vertex.notes.append(Note("\n".join(seq.below), f"in:{port}"))
        last, out = self.chain(seq, vertex.id, port)
        self.arc(last, vertex.id, out, RETURN)

    def filler(self, vertex: Vertex, slot: str, node: Any) -> None:
        element, constructor = self.element(node)
        filler = self.vertex(element)
        self.arc(filler.id, vertex.id, NEXT, slot)
        self.inside(filler, node, constructor)

    def params(self, vertex: Vertex, call: Call) -> None:
        meaning = self.robot.calls.get((call.object, call.method))
        names = [parameter.name for parameter in meaning[1].parameters] if meaning is not None else []
        names += [f"parameter{number}" for number in range(len(names) + 1, len(call.params) + 1)]
        for name, param in zip(names, call.params, strict=False):
            if isinstance(param, Number):
                vertex.settings[name] = str(param.value)
            elif isinstance(param, Call):
                self.filler(vertex, name, param)


def _match(template: Any, node: Any) -> dict[str, Any]:
    """Hole name → the part of the node that stands there; a repeated body gives the list of all branches."""
    matched: dict[str, Any] = {}
    for part in fields(template):
        pattern, value = getattr(template, part.name), getattr(node, part.name)
        if isinstance(pattern, list) and pattern and isinstance(pattern[0], Seq):
            assert pattern[0].hole is not None
            matched[pattern[0].hole.name] = value
        elif isinstance(pattern, Seq) and pattern.hole is not None:
            matched[pattern.hole.name] = value
        elif isinstance(pattern, Hole):
            matched[pattern.name] = value
    return matched
