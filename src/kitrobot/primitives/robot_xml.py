"""Robot XML → `Robot`.

The order of the file is kept, because it has meaning. What every robot has (methods of variables, `Fault`) is added
here. A robot with any error is not given at all: with an actuator or a method missing, its programs would mean
something else.

Left to others: what a device does with its settings (sim, drivers).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import (
    FIGURE,
    RANGE,
    ROBOT_NAME,
    VALUE,
)
from kitrobot.primitives.automatic import FAULT, boolean_methods, fault_object, integer_methods
from kitrobot.primitives.board_xml import BOARD
from kitrobot.primitives.constructors_xml import icon
from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.meaning_xml import MEANING_ATTRIBUTES, MEANING_PARTS, read_meaning
from kitrobot.primitives.methods_xml import NAMED, OPERATION, PICTURE, PROCEDURE, TYPE, inside, range_of, texts, truth
from kitrobot.primitives.palette_xml import GROUP, WORD, search_words
from kitrobot.primitives.robot import (
    Board,
    Category,
    Method,
    Robot,
    RobotObject,
    ValueType,
)
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence, Word
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import YES_NO, needed, optional, version, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

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


def read_robot(data: bytes, name: str) -> tuple[Robot | None, list[Diagnostic]]:
    """Reads a robot's file; None when it has an error."""
    reader = Reader(data, name)
    root = reader.read(ROBOT)
    robots = root.found(Robot) if root is not None and not root.faulty else []
    return (robots[0] if robots else None), reader.diagnostics


def _device(element: Element, category: Category) -> RobotObject:
    """What actuators and sensors have in common; attributes that are not ours are settings of the device."""
    methods = element.distinct(Method, lambda method: method.name, "method")
    device = element.optional("device")
    first, *more = [*element.found_at(Board), (Board(), element)]
    for _, around in more[:-1]:
        around.report(xml_rules.DUPLICATE, Sentence("<{element}> holds a <board> already", element.name))
    settings = {name: value for name, value in element.attributes.items() if name not in element.tag.attributes}
    simulated = element.found_at(SimulatedDevice)
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
        label=texts(element, "label"),
        help=texts(element, "help"),
        group=element.optional("group"),
        words=search_words(element),
        place=element.place("device"),
    )


@dataclass(frozen=True)
class SimulatedDevice:
    """Which device of the simulator stands for a part, and its settings."""

    model: str
    settings: Mapping[str, str]


def _simulated(element: Element) -> SimulatedDevice:
    settings = {name: value for name, value in element.attributes.items() if name != "as"}
    return SimulatedDevice(element.required("as"), settings)


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
        unit, meaning = read_meaning(element, 0, 1)
        return replace(made, type=ValueType.BOOLEAN, minimum=0, maximum=1, unit=unit, meaning=meaning)
    minimum, maximum = range_of(element)
    unit, meaning = read_meaning(element, minimum, maximum)
    methods = tuple(_meaning_as_sensor(method, unit, meaning) for method in made.methods)
    return replace(made, methods=methods, minimum=minimum, maximum=maximum, unit=unit, meaning=meaning)


def _meaning_as_sensor(method: Method, unit: str, meaning: Meaning | None) -> Method:
    """What a sensor's number means, that means what it is compared with, unless that says otherwise."""
    parameters = tuple(
        one if one.unit or one.meaning is not None else replace(one, unit=unit, meaning=meaning)
        for one in method.parameters
    )
    return replace(method, parameters=parameters)


def _variable(element: Element) -> RobotObject:
    name = _object_name(element)
    made = RobotObject(
        name,
        Category.VARIABLE,
        (),
        shared=element.flag("shared"),
        icon=icon(element),
        label=texts(element, "label"),
        help=texts(element, "help"),
    )
    if element.choice("type") == "boolean":
        initial = truth(element, "initial")
        return replace(made, methods=boolean_methods(initial), type=ValueType.BOOLEAN, maximum=1, initial=initial)
    minimum, maximum = range_of(element)
    initial = inside(element, "initial", minimum, maximum, max(minimum, min(0, maximum)))
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
        label=texts(element, "label"),
        help=texts(element, "help"),
        figure=element.matching("figure", ""),
    )


VARIABLE = Tag(
    _variable,
    {
        **NAMED,
        **TYPE,
        **RANGE,
        "initial": optional(VALUE),
        "shared": optional(YES_NO, "no", about="Whether the whole team sees it."),
        **PICTURE,
    },
    TEXTS,
    about="Its methods come by themselves.",
)
"""One variable of a robot."""

_DEVICE = {**NAMED, "device": optional(about="The simulator's model and the robot's driver."), **PICTURE, **GROUP}
_SIMULATE = Tag(
    _simulated,
    {"as": needed(about="A device of the simulator.")},
    free_attributes=True,
    about="At most one: what stands for the part in the simulator. Attributes beside as are settings of that device.",
)
_DEVICE_PARTS = {**TEXTS, **WORD, "board": BOARD, "simulate": _SIMULATE}
_ACTUATOR = Tag(
    _actuator,
    _DEVICE,
    {**_DEVICE_PARTS, "procedure": PROCEDURE},
    free_attributes=True,
    about="Acts upon the world. Attributes beside name, device, icon and group are settings of the device.",
)
_SENSOR = Tag(
    _sensor,
    {**_DEVICE, **TYPE, **RANGE, **MEANING_ATTRIBUTES},
    {**_DEVICE_PARTS, **MEANING_PARTS, "operation": OPERATION},
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
