"""Graph → text → graph: the same parts come back, also those whose LLL a more general part could write.

A graph is generated as what its parts say, `(element, settings, fillers, bodies)`, drawn, printed, read and drawn anew.
Left out is what no text can tell apart: a general part that holds just what a more specific one writes.
"""

from __future__ import annotations

import os
import random
from typing import Any, NamedTuple

import pytest

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.primitives.constructors import Constructor, Role, SlotKind
from kitrobot.primitives.robot import Kind, Robot
from tests.compiler.graphs import with_constructors

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "200"))

OWN = """
<constructor name="Twice"><flow name="body" loop="yes"/><code>2*({body})</code></constructor>
<constructor name="Nor"><condition name="one"/><condition name="two"/><code>!({one} | {two})</code></constructor>
<constructor name="Steadily"><condition name="test"/><flow name="body" loop="yes"/><number name="pause" max="9"/>
  <code>*[{test}]({body}; WAIT({pause}))</code></constructor>
<constructor name="Drive"><value name="speed" min="0" max="100"/><code>°Wheel.Advance({speed})°</code></constructor>
<constructor name="Fork"><flow name="one"/><action name="two"/><code>//({one}, °{two}°)</code></constructor>
"""


class Part(NamedTuple):
    """A vertex, and what hangs on it."""

    element: str
    settings: dict[str, str]
    fillers: dict[str, Part]
    bodies: dict[str, list[Part]]


def is_general(part: Part) -> bool:
    """Whether a more specific part writes the same."""

    def holds(slot: str, *elements: str) -> bool:
        return part.fillers[slot].element in elements

    match part.element:
        case "While":
            last = part.bodies["body"][-1:]
            waits = bool(last) and last[0].element == "Wait" and int(last[0].settings["duration"]) <= 9
            return waits or holds("condition", "No", "Nor")
        case "Repeat Until":
            # Neither this one nor Steadily is a special case of the other; this one stands first in the palette.
            return False
        case "Steadily":
            return holds("test", "No", "Nor")
        case "If Then":
            return holds("condition", "No", "Nor")
        case "When":
            return not part.bodies["body"]
        case "Repetition":
            return part.settings["count"] == "2"
        case "No":
            return holds("condition", "Or")
        case "Interrupt":
            return holds("action", "Wheel.Advance")
        case "Parallelism":
            return len(part.bodies) == 2 and [one.element for one in part.bodies["branch.2"]] in (
                ["Interrupt"],
                ["Drive"],
            )
    return False


class Maker:
    """Random parts over a robot."""

    def __init__(self, rng: random.Random, robot: Robot, constructors: list[Constructor]) -> None:
        self.rng = rng
        self.robot = robot
        self.instructions = [one for one in constructors if one.role is Role.INSTRUCTION]
        self.conditions = [one for one in constructors if one.role is Role.CONDITION]

    def chain(self, depth: int, least: int = 0) -> list[Part]:
        return [self.instruction(depth) for _ in range(self.rng.choice((least, 1, 1, 2, 3)))]

    def instruction(self, depth: int) -> Part:
        if depth == 0 or self.rng.random() < 0.2:
            return self.call(Kind.PROCEDURE, depth)
        return self.part(self.instructions, depth)

    def part(self, among: list[Constructor], depth: int) -> Part:
        while True:
            made = self.filled(self.rng.choice(among), depth - 1)
            if not is_general(made):
                return made

    def filled(self, constructor: Constructor, depth: int) -> Part:
        part = Part(constructor.name, {}, {}, {})
        for slot in constructor.slots:
            if slot.kind is SlotKind.FLOW and slot.repeat:
                for number in range(1, self.rng.randint(2, 4)):
                    part.bodies[f"{slot.name}.{number}"] = self.chain(depth, least=1)
            elif slot.kind is SlotKind.FLOW:
                part.bodies[slot.name] = self.chain(depth, least=int(constructor.name == "Fork"))
            elif slot.kind is SlotKind.CONDITION:
                part.fillers[slot.name] = self.condition(depth)
            elif slot.kind is SlotKind.ACTION:
                part.fillers[slot.name] = self.call(Kind.PROCEDURE, 0)
            elif slot.kind is SlotKind.VALUE and depth > 0 and self.rng.random() < 0.5:
                part.fillers[slot.name] = self.call(Kind.VALUE, depth)
            else:
                part.settings[slot.name] = str(self.rng.randint(slot.minimum or 0, min(9, slot.maximum or 9)))
        return part

    def condition(self, depth: int) -> Part:
        if depth <= 0 or self.rng.random() < 0.4:
            return self.call(Kind.TEST, depth)
        return self.part(self.conditions, depth)

    def call(self, kind: Kind, depth: int) -> Part:
        calls = [call for call in self.robot.calls.values() if call[1].kind is kind]
        part, method = self.rng.choice(calls)
        made = Part(f"{part.name}.{method.name}", {}, {}, {})
        for parameter in method.parameters:
            if depth > 0 and parameter.type.value == "integer" and self.rng.random() < 0.3:
                made.fillers[parameter.name] = self.call(Kind.VALUE, depth - 1)
            else:
                made.settings[parameter.name] = str(max(0, parameter.minimum))
        return made


class Drawn:
    """The graph of some parts."""

    def __init__(self, parts: list[Part], robot: str) -> None:
        self.program = Program("p", robot, [Vertex("start", START)])
        self.chain(parts, "start", NEXT, "stop", IN)
        self.program.vertices.append(Vertex("stop", STOP))

    def chain(self, parts: list[Part], source: str, out: str, target: str, at: str) -> None:
        for part in parts:
            vertex = self.vertex(part)
            self.program.arcs.append(Arc(source, vertex, out, IN))
            source, out = vertex, NEXT
        self.program.arcs.append(Arc(source, target, out, at))

    def vertex(self, part: Part) -> str:
        name = f"x{len(self.program.vertices)}"
        self.program.vertices.append(Vertex(name, part.element, part.settings))
        for slot, filler in part.fillers.items():
            self.program.arcs.append(Arc(self.vertex(filler), name, NEXT, slot))
        for port, body in part.bodies.items():
            self.chain(body, name, port, name, RETURN)
        return name


def parts_of(program: Program, wiring: Wiring) -> list[Part]:
    def chain(source: str, out: str) -> list[Part]:
        arc = wiring.out[source, out]
        if arc.at != IN or wiring.vertices[arc.target].element == STOP:
            return []
        return [part(arc.target), *chain(arc.target, NEXT)]

    def part(name: str) -> Part:
        vertex: Any = wiring.vertices[name]
        fillers = {slot: part(filler) for (target, slot), filler in wiring.fills.items() if target == name}
        bodies = {port: chain(name, port) for port in wiring.ports.get(name, ()) if port != NEXT}
        return Part(vertex.element, vertex.settings, fillers, bodies)

    assert wiring.start is not None
    return chain(wiring.start.id, NEXT)


@pytest.mark.timeout(0 if BUDGET > 1000 else 300)
def test_the_parts_of_a_graph_come_back_from_its_text() -> None:
    catalogue = with_constructors(OWN)
    robot = catalogue.robots["mini-robot"]
    constructors = [one for one in catalogue.constructors.values() if not one.level.is_team]
    seen: set[str] = set()
    for seed in range(BUDGET):
        parts = Maker(random.Random(seed), robot, constructors).chain(3, least=1)
        drawn = Drawn(parts, robot.name).program
        translation = graph_to_lll(drawn, catalogue)
        assert translation.diagnostics == [], seed
        assert parts_of(drawn, translation.wiring) == parts
        text = print_program(translation.program)
        again = lll_to_graph(parse(text).program, robot, catalogue, "p")
        assert parts_of(again, graph_to_lll(again, catalogue).wiring) == parts, f"seed {seed}:\n{text}"
        seen |= {vertex.element for vertex in drawn.vertices}
    assert {one.name for one in constructors if one.role is not Role.BRANCH} <= seen
