"""Procedures and operations of a robot's parts, with their parameters, from robot XML.

Left to others: the parts around them (robot_xml), what their numbers mean (meaning_xml).
"""

from __future__ import annotations

import re
from dataclasses import replace

from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import IDENTIFIER, ROBOT_NUMBER, USUAL_MAXIMUM, VALUE, VALUE_TYPE
from kitrobot.primitives.automatic import comparison
from kitrobot.primitives.constructors_xml import icon
from kitrobot.primitives.meaning_xml import MEANING_ATTRIBUTES, MEANING_PARTS, read_meaning
from kitrobot.primitives.palette_xml import GROUP, ORDER, WORD, search_words
from kitrobot.primitives.robot import LAST_PLACE, Kind, Method, Parameter, Texts, ValueType
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import ICON, YES_NO, needed, one, optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.texts import TEXT, TEXTS

_HOLE = re.compile(r"\{([^}]*)\}")
_WORD = re.compile(r"[A-Z]?[^A-Z]+|[A-Z]+(?![^A-Z])")


def range_of(element: Element, least: int = 0, most: int = USUAL_MAXIMUM) -> tuple[int, int]:
    """The ends of an element's range; those that contradict one another are reported."""
    minimum = element.integer("min", least)
    maximum = element.integer("max", most)
    if minimum > maximum:
        where = "min" if "min" in element.attributes else "max"
        message = Sentence("expected min at most max, found {least} and {most}", minimum, maximum)
        element.report(rules.RANGE, message, where)
        return maximum, minimum
    return minimum, maximum


def inside(element: Element, name: str, minimum: int, maximum: int, usual: int) -> int:
    """A number that lies in a range; one that does not is reported."""
    value = element.integer(name, usual)
    if not minimum <= value <= maximum:
        message = Sentence(
            "expected a number from {minimum} to {maximum} in {attribute}, found {found}", minimum, maximum, name, value
        )
        element.report(rules.RANGE, message, name)
    return value


def truth(element: Element, name: str) -> int:
    """A boolean value as 0 or 1."""
    return int(element.choice(name, "false") in ("true", "1"))


def texts(element: Element, kind: str) -> Texts:
    """The texts of one kind in an element, by language."""
    return element.texts.get(kind, {})


def _parameter(element: Element) -> Parameter:
    name = element.matching("name")
    if name in ("in", "next", "return"):
        message = Sentence("a parameter cannot be named {name}, a port of every vertex", name)
        element.report(xml_rules.BAD_VALUE, message, "name")
    made = Parameter(name, 0, 1, 0, label=texts(element, "label"), help=texts(element, "help"))
    if element.choice("type") == "boolean":
        unit, meaning = read_meaning(element, 0, 1)
        default = truth(element, "default")
        return replace(made, default=default, type=ValueType.BOOLEAN, unit=unit, meaning=meaning)
    operation = element.parent
    sensor = operation.parent if operation is not None and operation.name == "operation" else None
    minimum, maximum = range_of(element, *(_sensor_range(sensor) if sensor is not None else ()))
    default = inside(element, "default", minimum, maximum, max(minimum, min(0, maximum)))
    unit, meaning = read_meaning(element, minimum, maximum)
    return replace(made, minimum=minimum, maximum=maximum, default=default, unit=unit, meaning=meaning)


def _method(element: Element, kind: Kind, phrase: Texts) -> Method:
    """What procedures and operations have in common."""
    name = element.matching("name")
    parameters = element.distinct(Parameter, lambda parameter: parameter.name, "parameter")
    given = texts(element, "phrase")
    holes = {"object", *(parameter.name for parameter in parameters)}
    for text in given.values():
        for hole in _HOLE.findall(text):
            if hole not in holes:
                help = element.did_you_mean(hole, holes)
                message = Sentence("the phrase {phrase} has a hole {{hole}} that nothing fills", shown(text), hole)
                element.report(rules.PHRASE, message, None, help)
    return Method(
        name,
        kind,
        tuple(parameters),
        icon=icon(element),
        label=texts(element, "label"),
        help=texts(element, "help"),
        phrase=given or phrase,
        alone=element.flag("alone"),
        group=element.optional("group"),
        order=element.integer("order", LAST_PLACE),
        words=search_words(element),
        place=element.place("name"),
    )


def _procedure(element: Element) -> Method:
    later = element.choice("completes") == "later"
    return replace(_method(element, Kind.PROCEDURE, {}), completes_later=later, stop=element.attributes.get("stop"))


def _operation(element: Element) -> Method:
    count = len(element.found(Parameter))
    if element.flag("value"):
        for extra in ("test", "to"):
            if extra in element.attributes:
                message = Sentence('expected no {attribute} beside value="yes", found one', extra)
                element.report(rules.METHOD, message, extra)
        if count:
            element.report(rules.METHOD, Sentence("expected no parameter on a value, found {count}", count))
        return _method(element, Kind.VALUE, {"": "{object}"})
    if "test" not in element.attributes:
        element.report(rules.METHOD, Sentence('expected test="…" or value="yes" on <operation>, found neither'))
        return _method(element, Kind.TEST, {})
    test = element.choice("test")
    if ("to" in element.attributes) == bool(count) or count > 1:
        parameters = Sentence.counted("{count} parameter", "{count} parameters", count)
        found = Sentence("to and {parameters}", parameters) if "to" in element.attributes else parameters
        message = Sentence('expected either to="…" or one parameter on a test, found {found}', found)
        element.report(rules.METHOD, message)
    if "to" not in element.attributes:
        parameter = next((parameter.name for parameter in element.found(Parameter)), "value")
        return replace(_method(element, Kind.TEST, comparison(test, f"{{{parameter}}}")), test=test)
    least, most = _sensor_range(element.parent) if element.parent is not None else (0, 0)
    to = inside(element, "to", least, most, least)
    words = " ".join(_WORD.findall(element.optional("name"))).lower()
    return replace(_method(element, Kind.TEST, {"": f"{{object}} {words}"}), test=test, to=to)


def _sensor_range(sensor: Element) -> tuple[int, int]:
    """The range of the sensor around an operation, silently: the sensor itself reports what is wrong with it."""
    if sensor.attributes.get("type") == "boolean":
        return 0, 1
    ends = [sensor.attributes.get("min", "0"), sensor.attributes.get("max", str(USUAL_MAXIMUM))]
    numbers = [int(end) if re.fullmatch(r"[+-]?[0-9]{1,9}", end) else 0 for end in ends]
    return min(numbers), max(numbers)


NAMED = {"name": needed(IDENTIFIER)}
PICTURE = {"icon": optional(ICON)}
TYPE = {"type": optional(VALUE_TYPE, "integer")}
_PARAMETER = Tag(
    _parameter,
    {
        **NAMED,
        **TYPE,
        "min": optional(ROBOT_NUMBER),
        "max": optional(ROBOT_NUMBER),
        "default": optional(VALUE),
        **MEANING_ATTRIBUTES,
    },
    {**TEXTS, **MEANING_PARTS},
)
_METHOD_PARTS = {
    **TEXTS,
    **WORD,
    "phrase": replace(TEXT, about="Words for a chip, with {object} and {PARAMETER} as holes."),
    "parameter": _PARAMETER,
}
_COMPLETES = optional(
    one("now", "later"), "now", about="now: the program goes on at once. later: when the device says done."
)
_STOP = optional(IDENTIFIER, about="The procedure of the same actuator, without parameters, that ends the effect.")
_SHOWN = {
    **PICTURE,
    "alone": optional(YES_NO, "no", about="Whether its label says all: the part's name is not shown beside it."),
    **GROUP,
    **ORDER,
}
PROCEDURE = Tag(_procedure, {**NAMED, "completes": _COMPLETES, "stop": _STOP, **_SHOWN}, _METHOD_PARTS)
OPERATION = Tag(
    _operation,
    {
        **NAMED,
        "value": optional(YES_NO, "no"),
        "test": optional(one("equal", "less", "greater")),
        "to": optional(ROBOT_NUMBER),
        **_SHOWN,
    },
    _METHOD_PARTS,
    about="A value, or a test with either to or one parameter.",
)
