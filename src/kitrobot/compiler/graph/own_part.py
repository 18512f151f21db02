"""A selection becomes a constructor of the mission, and a vertex of it takes the selection's place.

`offer_part` says what could be left open in it: numbers typed in, what fills slots, what stands in bodies. `make_part`
makes the template, by translating the selection with holes where they were chosen, and has it read as XML would be, so
what it makes is what a file could bring.

Left to others: what is selected (selection), what there is to leave open (part_offers), the vertex in the selection's
place (part_placement).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from kitrobot.compiler.graph import rules
from kitrobot.compiler.graph.graph_to_lll import SlotName, condition_to_lll, graph_to_lll
from kitrobot.compiler.graph.part_offers import TAKEN_PORTS, TYPED, Offer, offers_of
from kitrobot.compiler.graph.part_placement import contents, put_part
from kitrobot.compiler.graph.selection import Selection, select
from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.compiler.target import target_of
from kitrobot.diagnostics.model import Diagnostic, KitRobotError
from kitrobot.graph.model import NEXT, START, STOP, Arc, Program, Vertex
from kitrobot.lll.printer import print_template
from kitrobot.lll.tokens import is_name
from kitrobot.lll.tree import Break, Condition, Joint, Node, Parallel, Repeat, Seq, TeamInstr, While
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, Role, Slot, SlotKind
from kitrobot.primitives.levels import Level
from kitrobot.primitives.own_xml import OWN_GROUP, read_own, write_constructor
from kitrobot.primitives.robot import Texts
from kitrobot.text.sentences import COMMA, Sentence, Series

_NOT_IN_NAMES = re.compile(r"[^A-Za-z0-9_]+")


class PartError(KitRobotError):
    """The selection cannot become a part."""


@dataclass(frozen=True)
class ChosenSlot:
    """An offer that is to be a slot, under a name for people. Numbers with one name become one slot."""

    vertex: str
    slot: str
    name: str
    minimum: int | None = field(default=None, metadata={"alias": "min"})
    maximum: int | None = field(default=None, metadata={"alias": "max"})
    default: str | None = None
    unit: str | None = None


@dataclass(frozen=True)
class PartOffer:
    """What a selection offers, what it would be, and what keeps it from becoming a part while nothing is left open."""

    selection: Selection
    role: Role
    offers: list[Offer]
    diagnostics: list[Diagnostic]


@dataclass(frozen=True)
class Appearance:
    """How a part is called and drawn."""

    name: str
    icon: str = ""
    colour: str = "action"
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)


@dataclass(frozen=True)
class Part:
    """A constructor made from a selection, and the program with a vertex of it in the selection's place."""

    constructor: Constructor
    program: Program
    vertex: str


def offer_part(program: Program, vertices: Sequence[str], catalogue: Catalogue) -> PartOffer:
    """What the selection offers to be left open.

    Raises:
        SelectionError: it is not one stretch, and not one condition.
    """
    wiring = Wiring(program, target_of(program, catalogue), catalogue)
    selection = select(wiring, vertices)
    offers = offers_of(wiring, selection)
    holes = {place: offer.name for place, offer, _ in _places(offers, ())}
    _, diagnostics = _translate(program, selection, catalogue, wiring, holes)
    role = Role.CONDITION if selection.is_condition else Role.INSTRUCTION
    return PartOffer(selection, role, offers, diagnostics)


def make_part(
    program: Program, vertices: Sequence[str], look: Appearance, chosen: Sequence[ChosenSlot], catalogue: Catalogue
) -> Part:
    """The constructor of a selection, and the program with it in place.

    Args:
        program: the program that the selection is of.
        vertices: the selection.
        look: name, picture and words.
        chosen: what is left open.
        catalogue: what there is; the name must be none of it.

    Raises:
        SelectionError: it is not one stretch, and not one condition.
        PartError: the name is taken, or what is chosen makes no template; `diagnostics` has the places.
    """
    wiring = Wiring(program, target_of(program, catalogue), catalogue)
    selection = select(wiring, vertices)
    check_name(look.name, catalogue)
    slots = _slots(_places(offers_of(wiring, selection), chosen))
    holes = {place: slot.name for slot, placed in slots for place, _, _ in placed}
    template, errors = _translate(program, selection, catalogue, wiring, holes)
    if errors:
        raise PartError(errors[0].message, errors[0].help, tuple(errors))
    wanted = Constructor(
        look.name,
        OWN_GROUP,
        look.colour,
        tuple(slot for slot, _ in slots),
        " ".join(print_template(template).split()),
        None,
        Role.CONDITION if selection.is_condition else Role.INSTRUCTION,
        icon=look.icon,
        label=look.label,
        help=look.help,
        level=program.level if any(isinstance(node, TeamInstr | Joint) for node in nodes(template)) else Level.AGENT,
    )
    constructor = judged(wanted)
    if (constructor.role is Role.CONDITION) is not selection.is_condition:
        raise PartError(Sentence("this is no condition once its holes are open"), Sentence("leave less of it open"))
    return Part(constructor, *put_part(wiring, selection, constructor, holes))


def check_name(name: str, catalogue: Catalogue) -> None:
    """Raises PartError when a part cannot be called that beside those that there are."""
    if name in catalogue.constructors:
        raise PartError(Sentence("there is a part `{name}` already", name), Sentence("choose another name"))
    if not name or name != " ".join(name.split()):
        raise PartError(Sentence("a part needs a name"), Sentence("write a name without spaces at its ends"))


def judged(wanted: Constructor) -> Constructor:
    """The same constructor as the reader of XML gives it.

    Raises:
        PartError: the reader finds a mistake in it.
    """
    found, problems = read_own(write_constructor(wanted), "part.xml")
    if not isinstance(found, Constructor):
        first = problems[0]
        told = tuple(replace(problem, place=None) for problem in problems)
        raise PartError(first.message, first.help, told)
    return found


# -- what is chosen


_Placed = tuple[SlotName, Offer, ChosenSlot]


def _places(offered: Sequence[Offer], chosen: Sequence[ChosenSlot]) -> list[_Placed]:
    """What is chosen, without what lies inside something else that is chosen; open slots are always in."""
    offers = {(one.vertex, one.slot): one for one in offered}
    wanted: dict[SlotName, ChosenSlot] = {}
    for one in chosen:
        place = (one.vertex, one.slot)
        if place not in offers:
            raise PartError(
                Sentence("`{vertex}` has nothing named `{slot}` to leave open", one.vertex, one.slot),
                Sentence("select the parts anew"),
            )
        wanted[place] = one
    for place, offer in offers.items():
        if offer.is_open and place not in wanted:
            wanted[place] = ChosenSlot(offer.vertex, offer.slot, offer.name)

    def outside(place: SlotName) -> SlotName | None:
        """What a place is inside of; a slot that is not offered itself is inside what its vertex is."""
        if place in offers:
            return offers[place].inside
        vertex, slot = place
        if slot and (vertex, "") in offers:
            return vertex, ""
        return next((one.inside for one in offered if one.vertex == vertex and one.inside != (vertex, "")), None)

    def is_inside(place: SlotName) -> bool:
        around = outside(place)
        while around is not None:
            if around in wanted:
                return True
            around = outside(around)
        return False

    return [
        (place, offer, wanted[place]) for place, offer in offers.items() if place in wanted and not is_inside(place)
    ]


def _slots(places: list[_Placed]) -> list[tuple[Slot, list[_Placed]]]:
    """The slots of the part with the places of each."""
    named: dict[str, list[_Placed]] = {}
    for placed in places:
        label = " ".join(placed[2].name.split()) or placed[1].name
        named.setdefault(label, []).append(placed)
    taken: set[str] = set()
    return [(_slot(label, placed, taken), placed) for label, placed in named.items()]


def _slot(label: str, placed: list[_Placed], taken: set[str]) -> Slot:
    _, offer, chosen = placed[0]
    name = _identifier(label, offer, taken)
    texts: Texts = {} if name == label else {"": label}
    if offer.kind not in TYPED:
        for _, other, _ in placed[1:]:
            if (other.kind, other.slot) != (SlotKind.FLOW, "") or offer.slot:
                raise PartError(
                    Sentence("two different things are called `{label}`", label), Sentence("give each its own name")
                )
        least = min(offer.least, 16)
        return Slot(name, offer.kind, offer.loop, offer.repeat, least if offer.repeat else 0, label=texts)
    kind = offer.kind
    if len(placed) > 1:
        values = {other.value for _, other, _ in placed}
        if any(other.kind not in TYPED for _, other, _ in placed):
            raise PartError(
                Sentence("two different things are called `{label}`", label), Sentence("give each its own name")
            )
        if len(values) > 1 or "" in values:
            told = Series(COMMA, sorted(value or Sentence("something plugged in") for value in values))
            raise PartError(
                Sentence("`{label}` stands for different things: {told}", label, told),
                Sentence("one name can only stand for the same number"),
            )
        kind = SlotKind.NUMBER
    if any(other.kind is SlotKind.TEXT for _, other, _ in placed):
        if any(other.kind is not SlotKind.TEXT for _, other, _ in placed):
            raise PartError(
                Sentence("two different things are called `{label}`", label), Sentence("give each its own name")
            )
        return Slot(name, SlotKind.TEXT, default=offer.value, label=texts)
    low = max(other.minimum for _, other, _ in placed)
    high = min(other.maximum for _, other, _ in placed)
    low = low if chosen.minimum is None else chosen.minimum
    high = high if chosen.maximum is None else chosen.maximum
    default = chosen.default if chosen.default is not None else offer.value
    if chosen.default is None:
        default = str(min(max(_whole(default, low), low), max(low, high)))
    unit = offer.unit if chosen.unit is None else chosen.unit
    meaning = offer.meaning if unit == offer.unit else None
    if meaning is not None:
        left = tuple(one for one in meaning.choices if low <= one.value <= high)
        meaning = replace(meaning, choices=left, field=meaning.field if left or not meaning.choices else "")
    return Slot(name, kind, minimum=low, maximum=high, default=default, unit=unit, label=texts, meaning=meaning)


def _whole(text: str, fallback: int) -> int:
    digits = text.strip()
    return int(digits) if digits.isascii() and digits.isdigit() and len(digits) < 10 else fallback


def _identifier(label: str, offer: Offer, taken: set[str]) -> str:
    """A name of the language for what people call it."""
    base = _NOT_IN_NAMES.sub("_", label).strip("_")[:40]
    if not is_name(base) or base in TAKEN_PORTS:
        base = offer.slot if is_name(offer.slot) and offer.slot not in TAKEN_PORTS else str(offer.kind)
    name, number = base, 1
    while name in taken:
        number += 1
        name = f"{base}{number}"
    taken.add(name)
    return name


# -- the template


def _translate(
    program: Program, selection: Selection, catalogue: Catalogue, wiring: Wiring, holes: dict[SlotName, str]
) -> tuple[Seq | Condition, list[Diagnostic]]:
    """The selection as LLL with holes, without notes; and what is wrong in it, outside of its holes."""
    piece = _piece(program, selection, wiring)
    template: Seq | Condition
    if selection.is_condition:
        template, found = condition_to_lll(piece, selection.chain[0], catalogue, holes)
    else:
        translation = graph_to_lll(piece, catalogue, holes)
        template, found = translation.program, translation.diagnostics
    left = contents(wiring, holes)
    errors = [item for item in found if item.is_error and not _is_elsewhere(item, left)]
    return template, errors + _open_breaks(template, program)


def _is_elsewhere(item: Diagnostic, left: set[str]) -> bool:
    """Whether a diagnostic is about what is left out, or about Start and Stop, which a condition does not have."""
    if item.code == rules.TWO_HOLES.code:
        return False
    return item.code == rules.START_STOP.code or (bool(item.vertices) and left.issuperset(item.vertices))


def _piece(program: Program, selection: Selection, wiring: Wiring) -> Program:
    """The selection as a program of its own."""
    held = set(selection.held)
    start, stop = _unused(held, "start"), _unused(held, "stop")
    vertices = [replace(wiring.vertices[name], notes=[]) for name in selection.held]
    arcs = [arc for arc in program.arcs if arc.source in held and arc.target in held]
    if selection.is_condition:
        return replace(program, vertices=vertices, arcs=arcs)
    first, last = selection.chain[0], selection.chain[-1]
    arcs = [arc for arc in arcs if (arc.source, arc.out) != (last, NEXT)]
    ends = [Vertex(start, START), Vertex(stop, STOP)]
    return replace(program, vertices=[*vertices, *ends], arcs=[*arcs, Arc(start, first), Arc(last, stop)])


def _unused(held: set[str], name: str) -> str:
    while name in held:
        name += "-"
    return name


def _open_breaks(template: Seq | Condition, program: Program) -> list[Diagnostic]:
    """Each BREAK that needs a loop outside the template: elsewhere it would leave whatever is around it."""
    found: list[Diagnostic] = []
    waiting: list[tuple[Node, bool]] = [(template, False)]
    while waiting:
        node, is_safe = waiting.pop()
        if isinstance(node, Break) and not is_safe:
            message = Sentence("a Break in the selection leaves a loop that is not selected")
            help = Sentence("select the loop too, or take the Break out of the selection")
            where = (node.vertex,) if node.vertex else ()
            found.append(rules.OPEN_BREAK(message, help=help, program=program.name, vertices=where))
        inside = isinstance(node, (Repeat, While, Parallel)) or is_safe
        waiting += [(child, inside) for child in reversed(children(node))]
    return found
