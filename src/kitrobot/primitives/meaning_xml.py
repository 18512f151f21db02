"""`unit`, `scale`, `field` and `<choice>` of a number in robot XML and constructors XML → `Meaning`, and back."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import cast

from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import ROBOT_NUMBER
from kitrobot.primitives.meaning import FIELDS, MOST_CHOICES, WAIT_UNIT, Choice, Field, Meaning
from kitrobot.text.sentences import Sentence
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import ICON, Attribute, Kind, needed, one, optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.texts import TEXT, TEXTS
from kitrobot.xml.writer import attributes, text_element

LONGEST_UNIT = 20
"""Characters of a unit, at most."""

_SCALE = re.compile(r"[0-9]{1,5}(\.[0-9]{1,4})?")
_LIGHTS = re.compile(r"[0-9]{5}( [0-9]{5}){4}")
_COLOUR = re.compile(r"#[0-9a-f]{6}")


def _is_scale(text: str) -> bool:
    return text == WAIT_UNIT or (_SCALE.fullmatch(text) is not None and float(text) > 0)


SCALE = Kind(
    pattern=rf"{_SCALE.pattern}|{WAIT_UNIT}",
    fits=_is_scale,
    words=Sentence("a number above 0, such as 3.6, or wait-unit"),
    name="scale",
    about="How many units one is; wait-unit: as many seconds as the robot's unit of WAIT.",
)
LIGHTS = Kind(
    pattern=_LIGHTS.pattern,
    fits=_LIGHTS.fullmatch,
    words=Sentence("five rows of five digits, such as 00900 09990 99999 09990 00900,"),
    about="Five by five lights, each dark (0) to bright (9).",
)
RGB = Kind(
    pattern=_COLOUR.pattern,
    fits=_COLOUR.fullmatch,
    words=Sentence("a colour such as #1c8548"),
    about="Red, green and blue, two small hexadecimal digits each.",
)
UNIT = Kind(longest=LONGEST_UNIT)

MEANING_ATTRIBUTES: dict[str, Attribute] = {
    "unit": optional(UNIT, about="What stands behind the number."),
    "scale": optional(SCALE, "1"),
    "field": optional(one(*FIELDS, name="field"), about="What the number is set with."),
}
"""The attributes of a number that means something."""


def _choice(element: Element) -> Choice:
    pictures = [name for name in ("icon", "lights", "colour") if name in element.attributes]
    if len(pictures) > 1:
        message = Sentence("a choice has one picture, found {first} and {second}", pictures[0], pictures[1])
        element.report(rules.MEANING, message, pictures[1])
    label = element.texts.get("label", {})
    if "" not in label:
        element.report(rules.MEANING, Sentence("expected a <label> in the choice, found none"))
    return Choice(
        element.integer("value"),
        label,
        element.matching("icon", ""),
        element.matching("lights", ""),
        element.matching("colour", ""),
    )


CHOICE = Tag(
    _choice,
    {
        "value": needed(ROBOT_NUMBER),
        "icon": optional(ICON),
        "lights": optional(LIGHTS),
        "colour": optional(RGB),
    },
    {"label": TEXTS["label"]},
    about="A value with a name, and one picture at most.",
)

MEANING_PARTS: dict[str, Tag] = {
    "unit": replace(TEXT, about="The unit in another language than English."),
    "choice": CHOICE,
}
"""What may stand inside an element with `MEANING_ATTRIBUTES`."""

_NEEDS_PICTURES = {"lights": "lights", "colour": "colour"}


def read_meaning(element: Element, least: int, most: int) -> tuple[str, Meaning | None]:
    """The unit of an element's number and what else it says; None where it says nothing else."""
    unit = element.optional("unit")
    if len(unit) > LONGEST_UNIT:
        element.bad_value("unit", Sentence("at most {longest} characters", LONGEST_UNIT))
    units = {language: text for language, text in element.texts.get("unit", {}).items() if language}
    scale = element.matching("scale", "1")
    field = element.choice("field", "")
    choices = _distinct_choices(element, least, most)
    picture = _NEEDS_PICTURES.get(field)
    if picture is not None and not (choices and all(getattr(choice, picture) for choice in choices)):
        message = Sentence("the field {field} needs choices with {picture}", field, picture)
        element.report(rules.MEANING, message, "field")
    if field == "choices" and not choices:
        element.report(rules.MEANING, Sentence("expected a <choice> for the field choices, found none"), "field")
    meaning = Meaning(scale, units, cast(Field, field), choices)
    return unit, None if meaning == Meaning() else meaning


def _distinct_choices(element: Element, least: int, most: int) -> tuple[Choice, ...]:
    found: dict[int, Choice] = {}
    given = element.found_at(Choice)
    for choice, around in given[:MOST_CHOICES]:
        if not least <= choice.value <= most:
            message = Sentence(
                "expected a number from {minimum} to {maximum} in {attribute}, found {found}",
                least,
                most,
                "value",
                choice.value,
            )
            around.report(rules.RANGE, message, "value")
        elif choice.value in found:
            around.report(
                xml_rules.DUPLICATE, Sentence("there is a choice with the value {value} already", choice.value), "value"
            )
        else:
            found[choice.value] = choice
    if len(given) > MOST_CHOICES:
        given[MOST_CHOICES][1].report(
            rules.MEANING, Sentence("expected at most {most} choices, found {count}", MOST_CHOICES, len(given))
        )
    return tuple(found.values())


def meaning_attributes(meaning: Meaning | None) -> list[tuple[str, str | None]]:
    """The attributes beside `unit`, as they are written."""
    if meaning is None:
        return []
    return [("scale", meaning.scale if meaning.scale != "1" else None), ("field", meaning.field or None)]


def meaning_elements(meaning: Meaning | None) -> list[str]:
    """What is written inside, a line each."""
    if meaning is None:
        return []
    lines = [text_element("unit", language, meaning.units[language]) for language in sorted(meaning.units)]
    for choice in meaning.choices:
        head = attributes(
            ("value", choice.value),
            ("icon", choice.icon or None),
            ("lights", choice.lights or None),
            ("colour", choice.colour or None),
        )
        labels = "".join(text_element("label", language, choice.label[language]) for language in sorted(choice.label))
        lines.append(f"<choice{head}>{labels}</choice>")
    return lines
