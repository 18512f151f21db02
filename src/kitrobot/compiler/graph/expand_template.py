"""Expands a vertex's template to LLL: the tree is copied, and its holes are filled from the vertex's slots."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, Protocol

from kitrobot.compiler.graph import rules
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.diagnostics.model import Rule
from kitrobot.graph.model import Vertex
from kitrobot.lll.parse_results import parse_members
from kitrobot.lll.tree import (
    MAX_NUMBER,
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Hole,
    Interrupt,
    Joint,
    Members,
    Move,
    Node,
    Not,
    Number,
    Or,
    Parallel,
    Param,
    ParOfSeq,
    ProgramCall,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    Where,
    While,
)
from kitrobot.primitives.constructors import Constructor, Slot, SlotKind
from kitrobot.text.sentences import Help, Sentence, Word


class Walk(Protocol):
    """What filling asks of the walk over the graph."""

    wiring: Wiring
    notes: list[str]
    depth: int

    def deeper(self, vertex: Vertex) -> bool:
        """Goes a level down; False, and reported, where it is one too many."""

    def hole(self, vertex: Vertex, slot: str) -> Hole | None:
        """The hole that is left where that slot would be filled, if any."""

    def put(self, vertex: Vertex, seq: Seq, more: Seq) -> None:
        """Adds instructions, and the hole among them, to a body."""

    def report(self, rule: Rule, message: Sentence, *vertices: str, help: Help = "") -> None:
        """Collects a diagnostic."""

    def number(self, vertex: Vertex, name: str, text: str, low: int, high: int) -> int:
        """A number that was typed in."""

    def body(self, vertex: Vertex, port: str) -> Seq:
        """What a flow slot leads to."""

    def condition(self, vertex: Vertex) -> Condition:
        """What a vertex in a condition slot becomes."""

    def read(self, vertex: Vertex) -> Call:
        """The call that a value or action vertex is."""


def fill(walk: Walk, vertex: Vertex, constructor: Constructor) -> Any:
    """The template of a constructor with its holes filled from a vertex of it."""
    return _TemplateExpander(walk, vertex, constructor).node(constructor.template)


class _TemplateExpander:
    """One vertex's template on its way to become LLL."""

    def __init__(self, walk: Walk, vertex: Vertex, constructor: Constructor) -> None:
        self.walk = walk
        self.vertex = vertex
        self.constructor = constructor

    def node(self, template: Any) -> Any:
        made = _BUILDERS[type(template)](self, template)
        made.vertex = made.vertex or self.vertex.id
        return made

    def slot(self, hole: Hole) -> Slot:
        slot = self.constructor.slot(hole.name)
        assert slot is not None, "a template's holes are its constructor's slots"
        return slot

    def number(self, value: int | Hole) -> int | Hole:
        if isinstance(value, int):
            return value
        left = self.left(value)
        if left is not None:
            return left
        slot = self.slot(value)
        text = self.vertex.settings.get(slot.name, slot.default or str(slot.minimum or 0))
        low, high = max(0, slot.minimum or 0), MAX_NUMBER if slot.maximum is None else min(slot.maximum, MAX_NUMBER)
        return self.walk.number(self.vertex, slot.name, text, low, high)

    def name(self, value: str | Hole) -> str | Hole:
        if isinstance(value, str):
            return value
        left = self.left(value)
        return self.typed(value) if left is None else left

    def typed(self, hole: Hole) -> str:
        """What was typed into a slot, on one line."""
        slot = self.slot(hole)
        text = " ".join(self.vertex.settings.get(slot.name, slot.default).split("\n"))
        if not text.strip():
            self.empty(hole, Sentence("write a name into it"))
        return text

    def members(self, value: Members | Hole) -> Members | Hole:
        if isinstance(value, Members):
            return replace(value)
        left = self.left(value)
        if left is not None:
            return left
        text = self.typed(value)
        members = parse_members(text)
        if members is None and text.strip():
            message = Sentence(
                "expected a set as the {slot} of `{vertex}`, found `{found}`", Word(value.name), self.vertex.id, text
            )
            self.walk.report(
                rules.NOT_A_SET, message, self.vertex.id, help=Sentence("write a name, or several: {a, b}")
            )
        return Members([], vertex=self.vertex.id) if members is None else replace(members, vertex=self.vertex.id)

    def joint(self, template: Joint) -> Condition:
        members = self.members(template.members)
        return self.joined(partial(Joint, template.quantifier, members), template.condition)

    def left(self, hole: Hole) -> Hole | None:
        """The hole that the walk leaves in the place of this one."""
        return self.walk.hole(self.vertex, hole.name)

    def filler(self, hole: Hole) -> Vertex | None:
        filler = self.walk.wiring.fills.get((self.vertex.id, hole.name))
        if filler is not None:
            return self.walk.wiring.vertices[filler]
        kind = self.slot(hole).kind
        wanted = (
            Sentence("a test")
            if kind is SlotKind.CONDITION
            else Sentence("an action")
            if kind is SlotKind.ACTION
            else Sentence("a value")
        )
        self.empty(hole, Sentence("drop {wanted} on it", wanted))
        return None

    def empty(self, hole: Hole, help: Help) -> None:
        """Reports a slot that holds nothing."""
        message = Sentence(
            "the slot `{hole}` of `{vertex}` ({element}) is empty", hole.name, self.vertex.id, Word(self.vertex.element)
        )
        self.walk.report(rules.EMPTY_SLOT, message, self.vertex.id, help=help)

    def condition(self, template: Any) -> Condition:
        made: Condition = self.filled(template, self.walk.condition)
        return made

    def filled(self, template: Any, read: Callable[[Vertex], Any]) -> Any:
        """A part of a template; a hole is what is left open in it, or what `read` makes of the vertex in it."""
        if not isinstance(template, Hole):
            return self.node(template)
        left = self.left(template)
        if left is not None:
            return left
        vertex = self.filler(template)
        return Call("", "") if vertex is None else read(vertex)

    def param(self, template: Any) -> Param:
        if not isinstance(template, Hole):
            return Number(template.value) if isinstance(template, Number) else self.node(template)
        left = self.left(template)
        if left is not None:
            return left
        if self.is_filled(template):
            vertex = self.filler(template)
            assert vertex is not None
            return self.walk.read(vertex)
        number = self.number(template)
        assert isinstance(number, int), "what is left open was left above"
        return Number(number)

    def call(self, template: Call) -> Call:
        nests = any(
            not isinstance(param, Number) and (isinstance(param, Call) or self.is_filled(param))
            for param in template.params
        )
        if nests and not self.walk.deeper(self.vertex):
            return Call("", "")
        call = Call(template.object, template.method, [self.param(param) for param in template.params])
        self.walk.depth -= nests
        return call

    def is_filled(self, hole: Hole) -> bool:
        return (self.vertex.id, hole.name) in self.walk.wiring.fills

    def action(self, template: Call | Hole) -> Call | Hole:
        made: Call | Hole = self.filled(template, self.walk.read)
        return made

    def body(self, template: Seq, port: str = "") -> Seq:
        """A body one level down, its hole filled by what follows a port (if none is given, that of its name)."""
        if not self.walk.deeper(self.vertex):
            return Seq()
        if template.hole is not None and not template.items:
            left = self.left(template.hole)
            seq = self.walk.body(self.vertex, port or template.hole.name) if left is None else Seq(hole=left)
        else:
            seq = self.items(template, port)
        self.walk.depth -= 1
        return seq

    def items(self, template: Seq, port: str = "") -> Seq:
        """The instructions of a template, and in the place of its hole those that follow a port."""
        seq = Seq(below=list(template.below))
        for index, item in enumerate([*template.items, None]):
            if template.hole is not None and index == template.hole_at:
                left = self.left(template.hole)
                hole = self.walk.body(self.vertex, port or template.hole.name) if left is None else Seq(hole=left)
                self.walk.put(self.vertex, seq, hole)
            if item is not None:
                seq.items.append(self.node(item))
        return seq

    def joined(self, made: Callable[..., Any], *templates: Any) -> Condition:
        """And, Or, Not: one level down."""
        if not self.walk.deeper(self.vertex):
            return Call("", "")
        joined: Condition = made(*map(self.condition, templates))
        self.walk.depth -= 1
        return joined

    def branches(self, templates: list[Seq]) -> list[Seq]:
        branches: list[Seq] = []
        if not self.walk.deeper(self.vertex):  # also where no branch is left: the parentheses are a level
            return branches
        self.walk.depth -= 1
        for template in templates:
            if template.hole is None or not self.slot(template.hole).repeat:
                branches.append(self.body(template))
                continue
            left = self.left(template.hole)
            if left is not None:
                branches.append(Seq(hole=left))
                continue
            base = template.hole.name + "."
            ports = sorted(
                (port for port in self.walk.wiring.ports.get(self.vertex.id, ()) if port.startswith(base)),
                key=lambda port: int(port[len(base) :]),
            )
            for port in ports:
                body = self.body(template, port)
                if body.items or body.hole is not None:
                    branches.append(body)
                else:
                    self.walk.notes += body.below
        return branches


_BUILDERS: dict[type[Node], Callable[[_TemplateExpander, Any], Any]] = {
    Seq: lambda f, t: f.items(t),
    Call: lambda f, t: f.call(t),
    Interrupt: lambda f, t: Interrupt(f.action(t.call)),
    Repeat: lambda f, t: Repeat(f.number(t.count), f.body(t.body)),
    While: lambda f, t: While(None if t.condition is None else f.condition(t.condition), f.body(t.body)),
    Conditional: lambda f, t: Conditional(
        f.condition(t.condition), f.body(t.then), None if t.orelse is None else f.body(t.orelse)
    ),
    Event: lambda f, t: Event(f.condition(t.condition), f.body(t.body)),
    Parallel: lambda f, t: Parallel(f.branches(t.branches)),
    Wait: lambda f, t: Wait(f.number(t.duration)),
    Break: lambda f, t: Break(),
    SeqOfPar: lambda f, t: SeqOfPar(f.members(t.members), f.body(t.body)),
    ParOfSeq: lambda f, t: ParOfSeq(f.members(t.members), f.body(t.body)),
    Where: lambda f, t: Where(
        *(f.members(t.members), f.condition(t.condition), f.body(t.then)),
        None if t.orelse is None else f.body(t.orelse),
    ),
    ProgramCall: lambda f, t: ProgramCall(f.name(t.name)),
    Move: lambda f, t: Move(f.number(t.count), f.name(t.source), f.name(t.target)),
    Joint: lambda f, t: f.joint(t),
    And: lambda f, t: f.joined(And, t.left, t.right),
    Or: lambda f, t: f.joined(Or, t.left, t.right),
    Not: lambda f, t: f.joined(Not, t.condition),
    Hole: lambda f, t: f.condition(t),
}
