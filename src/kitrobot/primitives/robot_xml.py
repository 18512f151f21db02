"""Robot XML → `Robot`.

The order of the file is kept, because it has meaning. What every robot has (methods of variables, `Fault`) is added
here. A robot with any error is not given at all: with an actuator or a method missing, its programs would mean
something else.

Left to others: what a device does with its settings (sim, drivers).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

from kitrobot.diagnostics import Diagnostic
from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import (
    FIGURE,
    IDENTIFIER,
    RANGE,
    ROBOT_NAME,
    ROBOT_NUMBER,
    USUAL_MAXIMUM,
    VALUE,
    VALUE_TYPE,
)
from kitrobot.primitives.automatic import FAULT, boolean_methods, comparison, fault_object, integer_methods
from kitrobot.primitives.board_xml import BOARD
from kitrobot.primitives.constructors_xml import icon
from kitrobot.primitives.robot import (
    Board,
    Category,
    Kind,
    Method,
    Parameter,
    Robot,
    RobotObject,
    Texts,
    ValueType,
)
from kitrobot.text import Sentence, Word, shown
from kitrobot.xml import ICON, TEXT, TEXTS, YES_NO, Element, Reader, Tag, needed, one, optional, version, whole
from kitrobot.xml import rules as xml_rules

VERSION = 1
"""The newest version of the format that is read."""

TICK_MS = 20
"""The period of a reaction when the file gives none."""

LONGEST_TICK_MS = 1000
"""The longest period of a reaction."""

WAIT_UNIT_MS = 100
"""The unit of WAIT when the file gives none."""

LONGEST_WAIT_UNIT_MS = 10_000
"""The longest unit of WAIT."""

_HOLE = re.compile(r"\{([^}]*)\}")
_WORD = re.compile(r"[A-Z]?[^A-Z]+|[A-Z]+(?![^A-Z])")


def read_robot(data: bytes, name: str) -> tuple[Robot | None, list[Diagnostic]]:
    """Reads a robot's file; None when it has an error."""
    reader = Reader(data, name)
    root = reader.read(ROBOT)
    robots = root.found(Robot) if root is not None and not root.faulty else []
    return (robots[0] if robots else None), reader.diagnostics


def _range(element: Element, least: int = 0, most: int = USUAL_MAXIMUM) -> tuple[int, int]:
    minimum = element.integer("min", least)
    maximum = element.integer("max", most)
    if minimum > maximum:
        where = "min" if "min" in element.attributes else "max"
        message = Sentence("expected min at most max, found {least} and {most}", minimum, maximum)
        element.report(rules.RANGE, message, where)
        return maximum, minimum
    return minimum, maximum


def _inside(element: Element, name: str, minimum: int, maximum: int, usual: int) -> int:
    value = element.integer(name, usual)
    if not minimum <= value <= maximum:
        message = Sentence(
            "expected a number from {minimum} to {maximum} in {attribute}, found {found}", minimum, maximum, name, value
        )
        element.report(rules.RANGE, message, name)
    return value


def _truth(element: Element, name: str) -> int:
    return int(element.choice(name, "false") in ("true", "1"))


def _text(element: Element, kind: str) -> Texts:
    return element.texts.get(kind, {})


def _parameter(element: Element) -> Parameter:
    name = element.matching("name")
    if name in ("in", "next", "return"):
        message = Sentence("a parameter cannot be named {name}, a port of every vertex", name)
        element.report(xml_rules.BAD_VALUE, message, "name")
    made = Parameter(
        name, 0, 1, 0, unit=element.optional("unit"), label=_text(element, "label"), help=_text(element, "help")
    )
    if element.choice("type") == "boolean":
        return replace(made, default=_truth(element, "default"), type=ValueType.BOOLEAN)
    operation = element.parent
    sensor = operation.parent if operation is not None and operation.name == "operation" else None
    minimum, maximum = _range(element, *(_sensor_range(sensor) if sensor is not None else ()))
    default = _inside(element, "default", minimum, maximum, max(minimum, min(0, maximum)))
    return replace(made, minimum=minimum, maximum=maximum, default=default)


def _method(element: Element, kind: Kind, phrase: Texts) -> Method:
    """What procedures and operations have in common."""
    name = element.matching("name")
    parameters = element.distinct(Parameter, lambda parameter: parameter.name, "parameter")
    given = _text(element, "phrase")
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
        label=_text(element, "label"),
        help=_text(element, "help"),
        phrase=given or phrase,
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
    to = _inside(element, "to", least, most, least)
    words = " ".join(_WORD.findall(element.optional("name"))).lower()
    return replace(_method(element, Kind.TEST, {"": f"{{object}} {words}"}), test=test, to=to)


def _sensor_range(sensor: Element) -> tuple[int, int]:
    """The range of the sensor around an operation, silently: the sensor itself reports what is wrong with it."""
    if sensor.attributes.get("type") == "boolean":
        return 0, 1
    ends = [sensor.attributes.get("min", "0"), sensor.attributes.get("max", str(USUAL_MAXIMUM))]
    numbers = [int(end) if re.fullmatch(r"[+-]?[0-9]{1,9}", end) else 0 for end in ends]
    return min(numbers), max(numbers)


def _device(element: Element, category: Category) -> RobotObject:
    """What actuators and sensors have in common; attributes that are not ours are settings of the device."""
    methods = element.distinct(Method, lambda method: method.name, "method")
    device = element.optional("device")
    first, *more = [*element.found_at(Board), (Board(), element)]
    for _, around in more[:-1]:
        around.report(xml_rules.DUPLICATE, Sentence("<{element}> holds a <board> already", element.name))
    settings = {name: value for name, value in element.attributes.items() if name not in element.tag.attributes}
    simulated = element.found_at(Simulated)
    for _, around in simulated[1:]:
        around.report(xml_rules.DUPLICATE, Sentence("<{element}> holds a <simulate> already", element.name))
    return RobotObject(
        _object_name(element),
        category,
        tuple(methods),
        device=device,
        model=simulated[0][0].model if simulated else device,
        board=replace(first[0], driver=first[0].driver or device),
        settings={**settings, **simulated[0][0].settings} if simulated else settings,
        icon=icon(element),
        label=_text(element, "label"),
        help=_text(element, "help"),
        place=element.place("device"),
    )


@dataclass(frozen=True)
class Simulated:
    """Which device of the simulator stands for a part, and its settings."""

    model: str
    settings: Mapping[str, str]


def _simulated(element: Element) -> Simulated:
    settings = {name: value for name, value in element.attributes.items() if name != "as"}
    return Simulated(element.required("as"), settings)


def _object_name(element: Element) -> str:
    name = element.matching("name")
    if name == FAULT:
        message = Sentence("every robot has a {part} already", FAULT)
        element.report(xml_rules.DUPLICATE, message, "name", Sentence("choose another name"))
    return name


def _actuator(element: Element) -> RobotObject:
    made = _device(element, Category.ACTUATOR)
    plain = {method.name for method in made.methods if not method.parameters}
    for method, around in element.found_at(Method):
        if method.stop is not None and method.stop not in plain:
            message = Sentence(
                "expected in stop a procedure of {part} without parameters, found {found}",
                made.name,
                shown(method.stop),
            )
            around.report(rules.STOP, message, "stop", around.did_you_mean(method.stop, plain))
    return made


def _sensor(element: Element) -> RobotObject:
    made = _device(element, Category.SENSOR)
    if element.choice("type") == "boolean":
        return replace(made, type=ValueType.BOOLEAN, minimum=0, maximum=1)
    minimum, maximum = _range(element)
    return replace(made, minimum=minimum, maximum=maximum)


def _variable(element: Element) -> RobotObject:
    name = _object_name(element)
    made = RobotObject(
        name,
        Category.VARIABLE,
        (),
        shared=element.flag("shared"),
        icon=icon(element),
        label=_text(element, "label"),
        help=_text(element, "help"),
    )
    if element.choice("type") == "boolean":
        initial = _truth(element, "initial")
        return replace(made, methods=boolean_methods(initial), type=ValueType.BOOLEAN, maximum=1, initial=initial)
    minimum, maximum = _range(element)
    initial = _inside(element, "initial", minimum, maximum, max(minimum, min(0, maximum)))
    methods = integer_methods(minimum, maximum, initial)
    return replace(made, methods=methods, minimum=minimum, maximum=maximum, initial=initial)


def _robot(element: Element) -> Robot:
    groups: dict[Category, list[RobotObject]] = {category: [] for category in Category}
    names: set[tuple[Category, str]] = set()
    calls: dict[tuple[str, str], str] = {}
    for part, around in element.found_at(RobotObject):
        if (part.category, part.name) in names:
            message = Sentence("the {category} {part} is there already", Word(part.category), shown(part.name))
            around.report(xml_rules.DUPLICATE, message, "name")
            continue
        names.add((part.category, part.name))
        groups[part.category].append(part)
        for method in part.methods:
            other = calls.setdefault((part.name, method.name), part.category.value)
            if other != part.category:
                message = Sentence(
                    "{part}.{method} is a method of the {category} {part} already", part.name, method.name, Word(other)
                )
                help = Sentence("an actuator and a sensor may share a name, not a method")
                around.report(xml_rules.DUPLICATE, message, "name", help)
    return Robot(
        element.matching("name"),
        tuple(groups[Category.ACTUATOR]),
        tuple(groups[Category.SENSOR]),
        tuple(groups[Category.VARIABLE]),
        (fault_object(),),
        tick_ms=element.integer("tick"),
        wait_unit_ms=element.integer("wait-unit"),
        label=_text(element, "label"),
        help=_text(element, "help"),
        figure=element.matching("figure", ""),
    )


_NAMED = {"name": needed(IDENTIFIER)}
_PICTURE = {"icon": optional(ICON)}
_TYPE = {"type": optional(VALUE_TYPE, "integer")}
_PARAMETER = Tag(
    _parameter,
    {
        **_NAMED,
        **_TYPE,
        "min": optional(ROBOT_NUMBER),
        "max": optional(ROBOT_NUMBER),
        "default": optional(VALUE),
        "unit": optional(),
    },
    TEXTS,
)
_METHOD_PARTS = {
    **TEXTS,
    "phrase": replace(TEXT, about="Words for a chip, with {object} and {PARAMETER} as holes."),
    "parameter": _PARAMETER,
}
_COMPLETES = optional(
    one("now", "later"), "now", about="now: the program goes on at once. later: when the device says done."
)
_STOP = optional(IDENTIFIER, about="The procedure of the same actuator, without parameters, that ends the effect.")
_PROCEDURE = Tag(_procedure, {**_NAMED, "completes": _COMPLETES, "stop": _STOP, **_PICTURE}, _METHOD_PARTS)
_OPERATION = Tag(
    _operation,
    {
        **_NAMED,
        "value": optional(YES_NO, "no"),
        "test": optional(one("equal", "less", "greater")),
        "to": optional(ROBOT_NUMBER),
        **_PICTURE,
    },
    _METHOD_PARTS,
    about="A value, or a test with either to or one parameter.",
)
VARIABLE = Tag(
    _variable,
    {
        **_NAMED,
        **_TYPE,
        **RANGE,
        "initial": optional(VALUE),
        "shared": optional(YES_NO, "no", about="Whether the whole team sees it."),
        **_PICTURE,
    },
    TEXTS,
    about="Its methods come by themselves.",
)
"""One variable of a robot."""

_DEVICE = {**_NAMED, "device": optional(about="The simulator's model and the robot's driver."), **_PICTURE}
_SIMULATE = Tag(
    _simulated,
    {"as": needed(about="A device of the simulator.")},
    free_attributes=True,
    about="At most one: what stands for the part in the simulator. Attributes beside as are settings of that device.",
)
_DEVICE_PARTS = {**TEXTS, "board": BOARD, "simulate": _SIMULATE}
_ACTUATOR = Tag(
    _actuator,
    _DEVICE,
    {**_DEVICE_PARTS, "procedure": _PROCEDURE},
    free_attributes=True,
    about="Acts upon the world. Attributes beside name, device and icon are settings of the device.",
)
_SENSOR = Tag(
    _sensor,
    {**_DEVICE, **_TYPE, **RANGE},
    {**_DEVICE_PARTS, "operation": _OPERATION},
    free_attributes=True,
    about="Senses a number min to max, or with type boolean 0 or 1.",
)
ROBOT = {
    "robot": Tag(
        _robot,
        {
            "name": needed(ROBOT_NAME),
            "version": version(VERSION),
            "tick": optional(whole(1, LONGEST_TICK_MS), str(TICK_MS), about="Milliseconds between two reactions."),
            "wait-unit": optional(
                whole(1, LONGEST_WAIT_UNIT_MS), str(WAIT_UNIT_MS), about="Milliseconds in the unit of WAIT."
            ),
            "figure": optional(FIGURE, about="How the page draws the robot."),
        },
        {**TEXTS, "actuator": _ACTUATOR, "sensor": _SENSOR, "variable": VARIABLE},
        open=lambda element: element.version(VERSION),
        unique=("actuator", "sensor", "variable"),
        about="A kind of robot: its actuators, sensors and variables. Order has meaning.",
    )
}
"""The first element of a robot's file."""
