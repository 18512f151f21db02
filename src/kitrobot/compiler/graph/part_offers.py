"""What a selection offers to be left open when it becomes a part: numbers, what fills slots, bodies, actions.

Each offer comes with a name that is free, the range of the slot or parameter, and what stands there. The same number
for the same parameter of the same element has one name, so it is one slot unless it is given two.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from kitrobot.compiler.graph.graph_to_lll import SlotName
from kitrobot.compiler.graph.selection import Selection, chain_behind
from kitrobot.compiler.graph.typed_numbers import typed_number
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.graph.model import NEXT, Vertex
from kitrobot.lll.tokens import is_name
from kitrobot.lll.tree import MAX_NUMBER
from kitrobot.primitives.constructors import Slot, SlotKind
from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.robot import Kind, Texts, ValueType

TAKEN_PORTS = ("in", "next", "return")
TYPED = (SlotKind.NUMBER, SlotKind.VALUE, SlotKind.TEXT)
"""Kinds of slot that a number is typed into."""


@dataclass(frozen=True)
class Offer:
    """One thing that could be left open: a slot or parameter of a vertex, or (`slot` "") the vertex itself, an action.

    `inside`: the offer that holds this one; where that is chosen, this one falls away. `is_open`: nothing fills it, so
    it has to be chosen. `value` is the number that is typed in, "" where there is none.
    """

    vertex: str
    slot: str
    kind: SlotKind
    name: str
    label: Texts = field(default_factory=dict)
    inside: SlotName | None = None
    is_open: bool = False
    value: str = ""
    minimum: int = 0
    maximum: int = MAX_NUMBER
    unit: str = ""
    meaning: Meaning | None = None
    loop: bool = False
    repeat: bool = False
    least: int = 0


def offers_of(wiring: Wiring, selection: Selection) -> list[Offer]:
    """The offers of a selection, in reading order."""
    return list(_Offers(wiring).of(selection))


class _Offers:
    """Names that are given, and to what."""

    def __init__(self, wiring: Wiring) -> None:
        self.wiring = wiring
        self.names: set[str] = set()
        self.given: dict[tuple[object, ...], str] = {}
        self.count: dict[str, int] = {}

    def of(self, selection: Selection) -> Iterator[Offer]:
        inside: dict[str, SlotName] = {}
        held = set(selection.held)
        around = _around(self.wiring, held)
        for name in selection.held:
            vertex = self.wiring.vertices[name]
            owner, slot, in_chain = around.get(name, (None, "", True))
            if owner is not None:
                inside[name] = (owner, slot)
            within = inside.get(name)
            if in_chain and not selection.is_condition:
                own = self.action(vertex, within)
                if own is not None:
                    yield own
                    within = (name, "")
            yield from self.slots(vertex, within)

    def name(self, base: str, same: tuple[object, ...]) -> str:
        """A name that only the same number has."""
        base = base if is_name(base) and base not in TAKEN_PORTS else "value"
        if (base, *same) not in self.given:
            name = base
            while name in self.names:
                self.count[base] = self.count.get(base, 1) + 1
                name = f"{base}{self.count[base]}"
            self.names.add(name)
            self.given[base, *same] = name
        return self.given[base, *same]

    def action(self, vertex: Vertex, inside: SlotName | None) -> Offer | None:
        owner, _, method = vertex.element.partition(".")
        meaning = self.wiring.robot.calls.get((owner, method))
        if meaning is None or meaning[1].kind is not Kind.PROCEDURE:
            return None
        name = self.name("action", (vertex.id,))
        return Offer(vertex.id, "", SlotKind.FLOW, name, inside=inside)

    def slots(self, vertex: Vertex, inside: SlotName | None) -> Iterator[Offer]:
        constructor = self.wiring.constructor(vertex)
        if constructor is not None:
            for slot in constructor.slots:
                yield self.slot(vertex, slot, inside)
            return
        owner, _, name = vertex.element.partition(".")
        meaning = self.wiring.robot.calls.get((owner, name))
        if meaning is None:
            return
        method = meaning[1]
        for parameter in method.parameters:
            is_boolean = parameter.type is ValueType.BOOLEAN
            filled = (vertex.id, parameter.name) in self.wiring.fills
            if filled and is_boolean:
                continue  # a test there has no kind of slot
            typed = vertex.settings.get(parameter.name, str(max(0, parameter.default)))
            low, high = max(0, parameter.minimum), max(0, min(parameter.maximum, MAX_NUMBER))
            given = None if method.is_limited or filled else typed_number(typed, 0, MAX_NUMBER)
            if given is not None:
                # A test may compare with what its sensor never reads.
                low, high = min(low, given), max(high, given)
            slot = Slot(
                parameter.name,
                SlotKind.NUMBER if is_boolean else SlotKind.VALUE,
                minimum=low,
                maximum=high,
                default=str(min(max(parameter.default, low), high)),
                unit=parameter.unit,
                label=parameter.label,
                meaning=parameter.meaning,
            )
            yield self.number(vertex, slot, "" if filled else typed, inside)

    def slot(self, vertex: Vertex, slot: Slot, inside: SlotName | None) -> Offer:
        if slot.kind in TYPED:
            filled = (vertex.id, slot.name) in self.wiring.fills
            usual = "" if slot.kind is SlotKind.TEXT else str(slot.minimum or 0)
            typed = vertex.settings.get(slot.name, slot.default or usual)
            return self.number(vertex, slot, "" if filled else typed, inside)
        return Offer(
            vertex.id,
            slot.name,
            slot.kind,
            self.name(slot.name, (vertex.id, slot.name)),
            slot.label,
            inside,
            is_open=slot.kind is not SlotKind.FLOW and (vertex.id, slot.name) not in self.wiring.fills,
            loop=slot.loop,
            repeat=slot.repeat,
            least=len(ports_of(self.wiring, vertex.id, slot.name)) if slot.repeat else 0,
        )

    def number(self, vertex: Vertex, slot: Slot, typed: str, inside: SlotName | None) -> Offer:
        low = max(0, slot.minimum or 0)
        high = MAX_NUMBER if slot.maximum is None else max(low, min(slot.maximum, MAX_NUMBER))
        same = (vertex.element, slot.name, typed) if typed else (vertex.id, slot.name)
        return Offer(
            vertex.id,
            slot.name,
            slot.kind,
            self.name(slot.name, same),
            slot.label,
            inside,
            value=typed,
            minimum=low,
            maximum=high,
            unit=slot.unit,
            meaning=slot.meaning,
        )


def _around(wiring: Wiring, held: set[str]) -> dict[str, tuple[str | None, str, bool]]:
    """For each vertex inside another: whose slot it stands in, and whether in a chain there."""
    around: dict[str, tuple[str | None, str, bool]] = {}
    for (owner, slot), filler in wiring.fills.items():
        around[filler] = (owner, slot, False)
    for owner in held:
        constructor = wiring.constructor(wiring.vertices[owner])
        for port in wiring.ports.get(owner, ()):
            if port == NEXT or constructor is None:
                continue
            slot = port if constructor.slot(port) is not None else port.rpartition(".")[0]
            for vertex in chain_behind(wiring, owner, port):
                around[vertex] = (owner, slot, True)
    return around


def ports_of(wiring: Wiring, vertex: str, slot: str) -> list[str]:
    """The ports of a repeated slot that are used, in order."""
    base = slot + "."
    ports = [port for port in wiring.ports.get(vertex, ()) if port.startswith(base)]
    return sorted(ports, key=lambda port: int(port[len(base) :]))
