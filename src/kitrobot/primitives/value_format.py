"""The value of a part in words ("12 cm", "true", the name of a choice), and sentences for values set by hand.

Terminals and the events of runs and of real robots use them. The page has its own (`web/src/model/meaning.ts`); both
show what the XML defines.
"""

from __future__ import annotations

from decimal import Decimal

from kitrobot.primitives.meaning import WAIT_UNIT, Meaning
from kitrobot.primitives.robot import Robot, RobotObject, ValueType
from kitrobot.text.sentences import Label, Recorded

_PLACES = Decimal("0.0001")


def format_value(part: RobotObject, value: int, wait_unit_ms: int = 100) -> str:
    """What a sensor or a variable measures; a choice is a `Label`. `wait_unit_ms`: of its robot."""
    meaning = part.meaning if part.meaning is not None else Meaning()
    for choice in meaning.choices:
        if choice.value == value and choice.label.get(""):
            return Label(str(value), choice.label)
    if part.type is ValueType.BOOLEAN:
        return "true" if value else "false"
    scale = Decimal(wait_unit_ms) / 1000 if meaning.scale == WAIT_UNIT else Decimal(meaning.scale)
    number = format((value * scale).quantize(_PLACES).normalize(), "f")
    if meaning.field == "time" and "." not in number:
        number += ".0"
    return _with_unit(number, part.unit)


def held_by_hand(robot: Robot | None, sensor: str, value: int | None) -> Recorded:
    """Somebody holds a sensor at a value; None: lets it measure again. `robot`: None where only the name is known."""
    if value is None:
        return Recorded("{name} no longer held", in_words(robot, sensor, 0)[0])
    return Recorded("{name} held by hand: {value}", *in_words(robot, sensor, value))


def set_by_hand(robot: Robot | None, variable: str, value: int) -> Recorded:
    """Somebody sets a variable. `robot`: None where only the name is known."""
    return Recorded("{name} set by hand: {value}", *in_words(robot, variable, value))


def in_words(robot: Robot | None, name: str, value: int) -> tuple[str, str]:
    """A sensor or variable as the page calls it, and its value with its unit; unchanged where the robot has
    none of that name, or is not known.
    """
    parts = (*robot.sensors, *robot.variables) if robot is not None else ()
    part = next((one for one in parts if one.name == name), None)
    if part is None or robot is None:
        return name, str(value)
    return Label(name, part.label), format_value(part, value, robot.wait_unit_ms)


def _with_unit(number: str, unit: str) -> str:
    return number + unit if unit in ("", "°") else f"{number} {unit}"
