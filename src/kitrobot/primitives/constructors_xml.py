"""Constructors XML → groups of constructors.

A constructor's meaning is its `<code>`: LLL with a hole for every slot, parsed here, so that a template that does not
fit its slots is an error of the XML file, at that line. A constructor with an error is left out; the others of the
file stay.

Left to others: constructors of several files together, and whether `<adds>` names something that exists (catalogue).
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import NamedTuple

from kitrobot.diagnostics import Diagnostic
from kitrobot.lll import And, Call, Not, Or, Seq, is_name, print_template, without_comments
from kitrobot.primitives import rules
from kitrobot.primitives.constructors import Constructor, Group, Role, Slot, SlotKind
from kitrobot.primitives.robot import LARGEST_VALUE
from kitrobot.primitives.template_xml import LONGEST_CODE, Template, read_template
from kitrobot.primitives.templates import holes
from kitrobot.primitives.xml import TEXTS, Reader
from kitrobot.primitives.xml_element import Element, Tag, one_of, shown

VERSION = 1
"""The newest version of the format that is read."""

COLOURS = ("loop", "choice", "parallel", "action", "test", "team")
"""The categories of the studio's colours."""

MOST_BRANCHES = 16
"""How many bodies a repeated slot may ask a new vertex to come with."""

NAME_IN_WORDS = "a name of letters, digits and _ (not WAIT or BREAK)"
"""What messages say of a name of the language."""

_TAKEN_PORTS = ("in", "next", "return")
_TAKEN_ELEMENTS = ("Start", "Stop")
_ICON = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


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
    root = reader.read({"constructors": _CONSTRUCTORS})
    groups = _distinct(root) if root is not None else []
    return groups, reader.diagnostics


def icon(element: Element) -> str:
    """The name of a picture of the Lucide set, or ""."""
    return element.matching("icon", _ICON.fullmatch, "the name of a Lucide icon, such as arrow-up,", "")


def _slot(element: Element) -> Slot:
    kind = SlotKind(element.name)
    name = element.matching("name", is_name, NAME_IN_WORDS)
    if name in _TAKEN_PORTS:
        element.report(rules.SLOT, f"a slot cannot be named {name}, a port of every vertex", "name")
    slot = Slot(name, kind, label=element.texts.get("label", {}))
    if kind is SlotKind.FLOW:
        repeat = element.flag("repeat")
        if not repeat and "least" in element.attributes:
            element.report(rules.SLOT, 'expected repeat="yes" beside least, found none', "least")
        return replace(
            slot, loop=element.flag("loop"), repeat=repeat, least=element.integer("least", 0, MOST_BRANCHES, 0)
        )
    if kind in (SlotKind.NUMBER, SlotKind.VALUE):
        least = element.integer("min", -LARGEST_VALUE, LARGEST_VALUE, 0) if "min" in element.attributes else None
        most = element.integer("max", -LARGEST_VALUE, LARGEST_VALUE, 0) if "max" in element.attributes else None
        if least is not None and most is not None and least > most:
            element.report(rules.RANGE, f"expected min at most max, found {least} and {most}", "min")
        default = element.optional("default")
        if default:
            low = least if least is not None else -LARGEST_VALUE
            high = most if most is not None else LARGEST_VALUE
            element.integer("default", low, max(low, high))
        return replace(slot, minimum=least, maximum=most, default=default, unit=element.optional("unit"))
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
        element.report(rules.TEMPLATE, "expected one construct to read, found several instructions or a call")
    return _Reads(template)


def _check_holes(constructor: Element, element: Element, template: Template) -> None:
    """Each slot of the constructor has one hole, each hole one slot, of a kind that fits."""
    offsets = element.reader.offsets_of_text(element)
    slots = {slot.name: slot for slot in constructor.found(Slot)}
    filled: set[str] = set()
    for hole, fitting, repeats in holes(template):
        slot = slots.get(hole.name)
        message, help = "", ""
        if slot is None:
            message, help = f"the hole {{{hole.name}}} has no slot", element.did_you_mean(hole.name, slots)
        elif hole.name in filled and slot.kind not in (SlotKind.NUMBER, SlotKind.TEXT):
            message, help = f"the hole {{{hole.name}}} stands there twice", "only what is typed in can be used twice"
        elif slot.kind not in fitting:
            wanted = one_of(f"<{kind}>" for kind in fitting)
            message = f"expected a slot {wanted} for {{{hole.name}}}, found <{slot.kind}>"
        elif slot.repeat and not repeats:
            message, help = f"the repeated slot {hole.name} can only be a branch of a parallel", "write //({branch})"
        filled.add(hole.name)
        if message:
            place = element.reader.span(offsets[hole.start], offsets[hole.end])
            element.add(rules.TEMPLATE(message, place, help=help))
    for name in slots.keys() - filled:
        element.report(rules.TEMPLATE, f"expected a hole {{{name}}} for the slot {name}, found none")


def _adds(element: Element) -> _Adds:
    return _Adds(element.required("constructor"), element.required("slot"))


def _element_name(name: str) -> bool:
    return name == " ".join(name.split()) and "." not in name and name not in _TAKEN_ELEMENTS


def _constructor(element: Element) -> Constructor | None:
    group = element.parent
    assert group is not None
    name = element.matching("name", _element_name, "a name that is not Start or Stop and has no dot")
    colour = element.choice("colour", COLOURS, group.attributes.get("colour", COLOURS[0]))
    slots = element.distinct(Slot, lambda slot: slot.name, "slot")
    codes, added = element.found(_Code), element.found(_Adds)
    if len(codes) + len(added) != 1:
        element.report(
            rules.MISSING, f"expected one <code> or one <adds> in the constructor, found {len(codes) + len(added)}"
        )
    if added and slots:
        element.report(
            rules.SLOT, "expected no slots beside <adds>, found some", None, "a branch is a slot of what it adds to"
        )
    for code, around in element.found_at(_Code):
        if code.template is not None and not element.faulty:
            _check_holes(element, around, code.template)
    reads = [template for (template,) in element.found(_Reads) if template is not None]
    for also, around in element.found_at(_Reads):
        if also.template is not None and not element.faulty:
            _check_holes(element, around, also.template)
    picture = icon(element)
    if element.faulty:
        return None
    template = codes[0].template if codes else None
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
        icon=picture,
        label=element.texts.get("label", {}),
        help=element.texts.get("help", {}),
    )


def _role(template: Template | None) -> Role:
    """A template that is a lone call could be either; it is an instruction."""
    if template is None:
        return Role.BRANCH
    return Role.CONDITION if isinstance(template, And | Or | Not) else Role.INSTRUCTION


def _group(element: Element) -> Group:
    name = element.required("name")
    colour = element.choice("colour", COLOURS)
    return Group(name, colour, tuple(element.found(Constructor)), element.texts.get("label", {}))


def _distinct(root: Element) -> list[Group]:
    """The groups, without constructors whose name came before; these are reported."""
    groups: list[Group] = []
    seen: set[str] = set()
    for group, around in root.found_at(Group):
        kept: list[Constructor] = []
        for constructor, place in around.found_at(Constructor):
            if constructor.name in seen:
                place.report(rules.DUPLICATE, f"the constructor {shown(constructor.name)} is there already", "name")
            else:
                kept.append(constructor)
            seen.add(constructor.name)
        groups.append(replace(group, constructors=tuple(kept)))
    return groups


_LABEL = {"label": TEXTS["label"]}
_SLOTS = {
    "flow": Tag(_slot, ("name", "loop", "repeat", "least"), _LABEL),
    "condition": Tag(_slot, ("name",), _LABEL),
    "value": Tag(_slot, ("name", "min", "max", "default", "unit"), _LABEL),
    "number": Tag(_slot, ("name", "min", "max", "default", "unit"), _LABEL),
    "text": Tag(_slot, ("name", "default"), _LABEL),
    "action": Tag(_slot, ("name",), _LABEL),
}
CONSTRUCTOR = Tag(
    _constructor,
    ("name", "icon", "colour"),
    {**TEXTS, **_SLOTS, "code": Tag(_code, text=True), "adds": Tag(_adds, ("constructor", "slot"))},
)
"""One constructor; its group is the element around it."""

_IN_FILE = replace(CONSTRUCTOR, children={**CONSTRUCTOR.children, "reads": Tag(_reads, text=True)})
_GROUP = Tag(_group, ("name", "colour"), {**TEXTS, "constructor": _IN_FILE})
_CONSTRUCTORS = Tag(None, ("version",), {"group": _GROUP}, open=lambda element: element.version(VERSION))
