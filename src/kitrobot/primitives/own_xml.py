"""Parts that a mission brings along, both ways: a `<constructor>` and a `<variable robot="…">` in a `.krt`.

They are what they are in constructors XML and robot XML, one element each, directly in the mission. Writing is
canonical: attributes and what is inside in one order, left out when they say the usual, so the same part gives the same
bytes. Reading what was written gives the same part. One that is wrong is reported and kept word for word by the element
around it, so that saving loses nothing.

Left to others: who holds them (mission), and what they mean (catalogue).
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import NAMED_ROBOT
from kitrobot.primitives.automatic_xml import part_texts
from kitrobot.primitives.constructors import Constructor, Slot, SlotKind
from kitrobot.primitives.constructors_xml import CONSTRUCTOR
from kitrobot.primitives.meaning_xml import meaning_attributes, meaning_elements
from kitrobot.primitives.palette_xml import word_elements
from kitrobot.primitives.robot import LAST_PLACE, RobotObject, Texts, ValueType
from kitrobot.primitives.robot_xml import VARIABLE
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import needed
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.writer import attributes, escape_text, text_element

MOST_OWN = 500
"""Constructors, and variables, that one mission may bring along."""


OWN_GROUP = "Own"
"""The heading of the palette under which the constructors of a mission are."""

OWN_ICON = "package"


def own_label() -> Texts:
    """The words of that heading."""
    return part_texts(OWN_GROUP)["label"]


@dataclass(frozen=True)
class OwnVariable:
    """A variable that a mission adds to every robot of a kind."""

    robot: str
    variable: RobotObject


def _own_constructor(element: Element) -> Constructor | None:
    assert CONSTRUCTOR.close is not None
    made = CONSTRUCTOR.close(element)
    if not isinstance(made, Constructor) or element.parent is None:
        return None
    if _is_one_too_many(element, made.name, Sentence("the constructor {constructor}", shown(made.name))):
        return None
    return replace(made, group=OWN_GROUP)


def _own_variable(element: Element) -> OwnVariable | None:
    assert VARIABLE.close is not None
    robot = element.matching("robot")
    made = VARIABLE.close(element)
    if element.faulty or not isinstance(made, RobotObject) or element.parent is None:
        return None
    if _is_one_too_many(
        element, (robot, made.name), Sentence("the variable {variable} of {robot}", shown(made.name), robot)
    ):
        return None
    return OwnVariable(robot, made)


def _is_one_too_many(element: Element, name: Hashable, what: str) -> bool:
    before = element.reader.own.setdefault(element.name, set())
    if name in before:
        element.report(xml_rules.DUPLICATE, Sentence("{what} is there already", what), "name")
    elif len(before) >= MOST_OWN:
        element.report(
            rules.TOO_MANY_OWN,
            Sentence("expected at most {most} of <{element}> in a mission, found more", MOST_OWN, element.name),
        )
    else:
        before.add(name)
        return False
    return True


OWN: dict[str, Tag] = {
    "constructor": replace(CONSTRUCTOR, close=_own_constructor, kept_whole=True, about="A part of this mission's own."),
    "variable": replace(
        VARIABLE,
        close=_own_variable,
        attributes={"robot": needed(NAMED_ROBOT), **VARIABLE.attributes},
        kept_whole=True,
        about="A variable that this mission adds to every robot of a kind.",
    ),
}
"""Goes among the children of an element with `keep`, where `found(Constructor)` and `found(OwnVariable)` give them."""


def read_own(lines: list[str], name: str) -> tuple[Constructor | OwnVariable | None, list[Diagnostic]]:
    """What `write_constructor` or `write_variable` wrote; None when there is anything wrong with it."""
    reader = Reader("\n".join(["<kitrobot>", *lines, "</kitrobot>"]).encode(), name)
    root = reader.read({"kitrobot": Tag(children=OWN)})
    found: list[Constructor | OwnVariable] = []
    if root is not None:
        found += [*root.found(Constructor), *root.found(OwnVariable)]
    return (found[0] if len(found) == 1 and not reader.diagnostics else None), reader.diagnostics


def write_constructor(constructor: Constructor, indent: str = "  ") -> list[str]:
    """The lines of a `<constructor>`, without line breaks."""
    head = attributes(
        ("name", constructor.name),
        ("icon", constructor.icon or None),
        ("colour", constructor.colour or None),
        ("level", constructor.level if constructor.level.is_team else None),
        ("order", constructor.order if constructor.order != LAST_PLACE else None),
    )
    inside = [*_texts("label", constructor.label), *_texts("help", constructor.help)]
    inside += [text_element("word", language, words) for language, words in word_elements(constructor.words)]
    inside += [_slot(slot) for slot in constructor.slots]
    if constructor.adds is not None:
        inside.append(f"<adds{attributes(('constructor', constructor.adds[0]), ('slot', constructor.adds[1]))}/>")
    else:
        inside.append(f"<code>{escape_text(constructor.code)}</code>")
    return [f"{indent}<constructor{head}>", *(f"{indent}  {line}" for line in inside), f"{indent}</constructor>"]


def write_constructors(constructors: Sequence[Constructor]) -> bytes:
    """A constructors file with these parts in one group, which any folder of parts can hold."""
    label = "".join(_texts("label", own_label()))
    head = [
        '<constructors version="1">',
        f"  <group{attributes(('name', OWN_GROUP), ('colour', 'action'), ('icon', OWN_ICON))}>{label}",
    ]
    lines = [line for constructor in constructors for line in write_constructor(constructor, "    ")]
    return ("\n".join([*head, *lines, "  </group>", "</constructors>"]) + "\n").encode()


def write_variable(own: OwnVariable, indent: str = "  ") -> list[str]:
    """The lines of a `<variable>`, without line breaks."""
    variable = own.variable
    is_boolean = variable.type is ValueType.BOOLEAN
    head = attributes(
        ("robot", own.robot),
        ("name", variable.name),
        ("type", "boolean" if is_boolean else None),
        ("min", None if is_boolean else variable.minimum),
        ("max", None if is_boolean else variable.maximum),
        ("initial", ("true" if variable.initial else "false") if is_boolean else variable.initial),
        ("shared", "yes" if variable.shared else None),
        ("icon", variable.icon or None),
    )
    inside = [*_texts("label", variable.label), *_texts("help", variable.help)]
    if not inside:
        return [f"{indent}<variable{head}/>"]
    return [f"{indent}<variable{head}>", *(f"{indent}  {line}" for line in inside), f"{indent}</variable>"]


def _texts(name: str, texts: Texts) -> list[str]:
    """One line a language, English first."""
    return [text_element(name, language, " ".join(texts[language].split())) for language in sorted(texts)]


def _slot(slot: Slot) -> str:
    is_number = slot.kind in (SlotKind.NUMBER, SlotKind.VALUE)
    head = attributes(
        ("name", slot.name),
        ("loop", "yes" if slot.loop else None),
        ("repeat", "yes" if slot.repeat else None),
        ("least", slot.least if slot.repeat and slot.least else None),
        ("min", slot.minimum),
        ("max", slot.maximum),
        ("default", slot.default or None),
        ("unit", slot.unit if slot.unit and is_number else None),
        *(meaning_attributes(slot.meaning) if is_number else ()),
    )
    inside = "".join([*_texts("label", slot.label), *(meaning_elements(slot.meaning) if is_number else ())])
    return f"<{slot.kind}{head}>{inside}</{slot.kind}>" if inside else f"<{slot.kind}{head}/>"
