"""Constructors XML → groups of constructors.

A constructor's meaning is its `<code>`: LLL with a hole for every slot, parsed here, so that a template that does not
fit its slots is an error of the XML file, at that line. A constructor with an error is left out; the others of the
file stay.

Left to others: constructors of several files together, and whether `<adds>` names something that exists (catalogue).
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.printer import print_template
from kitrobot.lll.tree import And, Call, Joint, Not, Or, Seq, TeamInstr
from kitrobot.lll.walk import nodes, without_comments
from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import COLOUR, COLOURS, HOLDS, IDENTIFIER, LEVEL, ROBOT_NUMBER
from kitrobot.primitives.constructors import Constructor, Group, Role, Slot, SlotKind
from kitrobot.primitives.levels import Level
from kitrobot.primitives.meaning_xml import MEANING_ATTRIBUTES, MEANING_PARTS, read_meaning
from kitrobot.primitives.palette_xml import ORDER, WORD, search_words
from kitrobot.primitives.robot import LARGEST_VALUE, LAST_PLACE
from kitrobot.primitives.template_xml import LONGEST_CODE, Template, read_template
from kitrobot.primitives.templates import holes, named_by
from kitrobot.text.phrases import one_of, shown
from kitrobot.text.sentences import Help, Sentence
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import ICON, NAME, YES_NO, Kind, needed, optional, version, whole
from kitrobot.xml.element import LONGEST_NAME, Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

VERSION = 1
"""The newest version of the format that is read."""

MOST_BRANCHES = 16
"""How many bodies a repeated slot may ask a new vertex to come with."""

_TAKEN_PORTS = ("in", "next", "return")
_TAKEN_ELEMENTS = ("Start", "Stop")


class _Code(NamedTuple):
    """What `<code>` gave; the template is None when it is not LLL."""

    text: str
    template: Template | None


class _Reads(NamedTuple):
    """What `<reads>` gave; the template is None when it is not LLL."""

    template: Template | None


class _Adds(NamedTuple):
    """What `<adds>` gave."""

    constructor: str
    slot: str


def read_constructors(data: bytes, name: str) -> tuple[list[Group], list[Diagnostic]]:
    """Reads a constructors file; a constructor with an error is left out, a file that is not XML gives no groups."""
    reader = Reader(data, name)
    root = reader.read(CONSTRUCTORS)
    groups = _distinct(root) if root is not None else []
    return groups, reader.diagnostics


def icon(element: Element) -> str:
    """The name of a picture of the Lucide set, or ""."""
    return element.matching("icon", "")


def _slot(element: Element) -> Slot:
    kind = SlotKind(element.name)
    name = element.matching("name")
    if name in _TAKEN_PORTS:
        element.report(rules.SLOT, Sentence("a slot cannot be named {name}, a port of every vertex", name), "name")
    slot = Slot(name, kind, label=element.texts.get("label", {}))
    if kind is SlotKind.FLOW:
        repeat = element.flag("repeat")
        if not repeat and "least" in element.attributes:
            element.report(rules.SLOT, Sentence('expected repeat="yes" beside least, found none'), "least")
        return replace(slot, loop=element.flag("loop"), repeat=repeat, least=element.integer("least"))
    if kind in (SlotKind.NUMBER, SlotKind.VALUE):
        least = element.integer("min", 0) if "min" in element.attributes else None
        most = element.integer("max", 0) if "max" in element.attributes else None
        if least is not None and most is not None and least > most:
            element.report(
                rules.RANGE, Sentence("expected min at most max, found {least} and {most}", least, most), "min"
            )
        default = element.optional("default")
        low = least if least is not None else -LARGEST_VALUE
        high = most if most is not None else LARGEST_VALUE
        if default:
            element.between("default", low, max(low, high))
        unit, meaning = read_meaning(element, low, high)
        return replace(slot, minimum=least, maximum=most, default=default, unit=unit, meaning=meaning)
    return replace(slot, default=element.optional("default"))


def _code(element: Element) -> _Code:
    template = read_template(element)
    text = element.text if len(element.text) <= LONGEST_CODE else ""
    if "#" in text and template is not None:  # a comment would swallow what comes after it on one line
        text = print_template(without_comments(template))
    return _Code(" ".join(text.split()), template)


def _reads(element: Element) -> _Reads:
    template = read_template(element)
    if isinstance(template, Seq | Call):
        element.report(rules.TEMPLATE, Sentence("expected one construct to read, found several instructions or a call"))
    return _Reads(template)


def _check_holes(constructor: Element, element: Element, template: Template) -> None:
    """Each slot of the constructor has one hole, each hole one slot, of a kind that fits."""
    offsets = element.reader.offsets_of_text(element)
    slots = {slot.name: slot for slot in constructor.found(Slot)}
    filled: set[str] = set()
    for hole, fitting, repeats in holes(template):
        slot = slots.get(hole.name)
        message = Sentence("")
        help: Help = ""
        if slot is None:
            message, help = Sentence("the hole {{hole}} has no slot", hole.name), element.did_you_mean(hole.name, slots)
        elif hole.name in filled and slot.kind not in (SlotKind.NUMBER, SlotKind.TEXT):
            message, help = (
                Sentence("the hole {{hole}} stands there twice", hole.name),
                Sentence("only what is typed in can be used twice"),
            )
        elif slot.kind not in fitting:
            wanted = one_of(f"<{kind}>" for kind in fitting)
            message = Sentence("expected a slot {wanted} for {{hole}}, found <{kind}>", wanted, hole.name, slot.kind)
        elif slot.repeat and not repeats:
            message, help = (
                Sentence("the repeated slot {hole} can only be a branch of a parallel", hole.name),
                Sentence("write //({branch})"),
            )
        filled.add(hole.name)
        if message:
            place = element.reader.span(offsets[hole.start], offsets[hole.end])
            element.add(rules.TEMPLATE(message, place, help=help))
    for name in slots.keys() - filled:
        element.report(rules.TEMPLATE, Sentence("expected a hole {{name}} for the slot {name}, found none", name))


def _adds(element: Element) -> _Adds:
    return _Adds(element.required("constructor"), element.required("slot"))


def _element_name(name: str) -> bool:
    return name == " ".join(name.split()) and "." not in name and name not in _TAKEN_ELEMENTS


def _constructor(element: Element) -> Constructor | None:
    group = element.parent
    assert group is not None
    name = element.matching("name")
    colour = element.choice("colour", group.attributes.get("colour", COLOURS[0]))
    slots = element.distinct(Slot, lambda slot: slot.name, "slot")
    codes, added = element.found(_Code), element.found(_Adds)
    if len(codes) + len(added) != 1:
        element.report(
            xml_rules.MISSING,
            Sentence("expected one <code> or one <adds> in the constructor, found {count}", len(codes) + len(added)),
        )
    if added and slots:
        element.report(
            rules.SLOT,
            Sentence("expected no slots beside <adds>, found some"),
            None,
            Sentence("a branch is a slot of what it adds to"),
        )
    for code, around in element.found_at(_Code):
        if code.template is not None and not element.faulty:
            _check_holes(element, around, code.template)
    reads = [template for (template,) in element.found(_Reads) if template is not None]
    for also, around in element.found_at(_Reads):
        if also.template is not None and not element.faulty:
            _check_holes(element, around, also.template)
    picture = icon(element)
    words = search_words(element)
    template = codes[0].template if codes else None
    level = Level(element.choice("level"))
    if level is Level.AGENT and template is not None and not element.faulty:
        _check_level(element, template)
    if element.faulty:
        return None
    if template is not None:
        named = named_by(template)
        slots = [replace(slot, names=named.get(slot.name, "")) for slot in slots]
    return Constructor(
        name=name,
        group=group.attributes.get("name", ""),
        colour=colour,
        slots=tuple(slots),
        code=codes[0].text if codes else "",
        template=template,
        role=_role(template),
        adds=(added[0].constructor, added[0].slot) if added else None,
        reads=tuple(template for template in reads if not isinstance(template, Seq)),
        level=level,
        icon=picture,
        label=element.texts.get("label", {}),
        help=element.texts.get("help", {}),
        order=element.integer("order", LAST_PLACE),
        words=words,
    )


def _check_level(element: Element, template: Template) -> None:
    """The code of what stands in programs of one robot speaks of one robot."""
    if any(isinstance(node, TeamInstr | Joint) for node in nodes(template)):
        element.report(
            rules.TEMPLATE,
            Sentence("its code speaks of several robots, so it stands in programs of a team"),
            "level",
            Sentence('write level="group" on the constructor'),
        )


def _role(template: Template | None) -> Role:
    """A template that is a lone call could be either; it is an instruction."""
    if template is None:
        return Role.BRANCH
    return Role.CONDITION if isinstance(template, And | Or | Not | Joint) else Role.INSTRUCTION


def _group(element: Element) -> Group:
    name = element.required("name")
    colour = element.choice("colour")
    label, holds = element.texts.get("label", {}), element.choice("holds", "")
    return Group(name, colour, tuple(element.found(Constructor)), label, icon(element), holds)


def _distinct(root: Element) -> list[Group]:
    """The groups, without constructors whose name came before; these are reported."""
    groups: list[Group] = []
    seen: set[str] = set()
    for group, around in root.found_at(Group):
        kept: list[Constructor] = []
        for constructor, place in around.found_at(Constructor):
            if constructor.name in seen:
                place.report(
                    xml_rules.DUPLICATE,
                    Sentence("the constructor {constructor} is there already", shown(constructor.name)),
                    "name",
                )
            else:
                kept.append(constructor)
            seen.add(constructor.name)
        groups.append(replace(group, constructors=tuple(kept)))
    return groups


_LABEL = {"label": TEXTS["label"]}
_NAMED = {"name": needed(IDENTIFIER)}
_NUMBERS = {
    **_NAMED,
    "min": optional(ROBOT_NUMBER),
    "max": optional(ROBOT_NUMBER),
    "default": optional(ROBOT_NUMBER),
    **MEANING_ATTRIBUTES,
}
_NUMBER_PARTS = {**_LABEL, **MEANING_PARTS}
_FLOW = {
    **_NAMED,
    "loop": optional(YES_NO, "no", about="Whether the body is done again and again."),
    "repeat": optional(
        YES_NO, "no", about="Whether there may be any number of such bodies, as the branches of a parallel."
    ),
    "least": optional(whole(0, MOST_BRANCHES), "0", about="How many of them a new vertex comes with."),
}
_SLOTS = {
    "flow": Tag(_slot, _FLOW, _LABEL, about="A chain of vertices."),
    "condition": Tag(_slot, _NAMED, _LABEL, about="One test."),
    "value": Tag(_slot, _NUMBERS, _NUMBER_PARTS, about="A number, or a vertex that gives one."),
    "number": Tag(_slot, _NUMBERS, _NUMBER_PARTS, about="A number that is typed in."),
    "text": Tag(_slot, {**_NAMED, "default": optional()}, _LABEL, about="Something that is typed in."),
    "action": Tag(_slot, _NAMED, _LABEL, about="One call of a procedure."),
}
_CONSTRUCTOR_NAME = Kind(
    longest=LONGEST_NAME,
    pattern=r"[^.\s]+( [^.\s]+)*",
    fits=_element_name,
    words=Sentence("a name that is not Start or Stop and has no dot"),
)
CONSTRUCTOR = Tag(
    _constructor,
    {
        "name": needed(_CONSTRUCTOR_NAME),
        "icon": optional(ICON),
        "colour": optional(COLOUR, about="When it is not the colour of the group."),
        "level": optional(LEVEL, Level.AGENT, about="Of the programs it stands in, the narrowest level."),
        **ORDER,
    },
    {
        **TEXTS,
        **WORD,
        **_SLOTS,
        "code": Tag(_code, text=True, about="LLL with a hole {name} for each slot."),
        "adds": Tag(
            _adds,
            {"constructor": needed(), "slot": needed(IDENTIFIER)},
            about="Instead of code: dropped on that constructor, it adds one more to that repeated slot.",
        ),
    },
    least=1,
    about="A building block: slots, and either code or adds.",
)
"""One constructor; its group is the element around it."""

_READS = Tag(
    _reads,
    text=True,
    about="Other LLL with the same holes that is drawn as this constructor; it is never written.",
)
_GROUP = Tag(
    _group,
    {
        "name": needed(NAME),
        "colour": needed(COLOUR),
        "icon": optional(ICON),
        "holds": optional(HOLDS, about="Which parts of a robot stand in it that say no group."),
    },
    {**TEXTS, "constructor": replace(CONSTRUCTOR, children={**CONSTRUCTOR.children, "reads": _READS})},
    about="A tab of the palette. Groups of the same name in several files become one.",
)
CONSTRUCTORS = {
    "constructors": Tag(
        None,
        {"version": version(VERSION)},
        {"group": _GROUP},
        open=lambda element: element.version(VERSION),
        unique=("group/constructor",),
        about="Constructors: what programs are built of, the same for all robots.",
    )
}
"""The first element of a constructors file."""
