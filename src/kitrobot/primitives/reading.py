"""The value of a part in words, as terminals and events show it: "12 cm", "true", the name of a choice.

The page has its own (`web/src/model/meaning.ts`); what both show is what the XML says.
"""

from __future__ import annotations

from decimal import Decimal

from kitrobot.primitives.meaning import WAIT_UNIT, Meaning
from kitrobot.primitives.robot import Robot, RobotObject, ValueType
from kitrobot.text import Label

_PLACES = Decimal("0.0001")


def reading(part: RobotObject, value: int, wait_unit_ms: int = 100) -> str:
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


def in_words(robot: Robot, name: str, value: int) -> tuple[str, str]:
    """A sensor or variable of a robot as the page calls it, and its value with its unit; unchanged where it has none of
    that name.
    """
    part = next((one for one in (*robot.sensors, *robot.variables) if one.name == name), None)
    if part is None:
        return name, str(value)
    return Label(name, part.label), reading(part, value, robot.wait_unit_ms)


def _with_unit(number: str, unit: str) -> str:
    return number + unit if unit in ("", "°") else f"{number} {unit}"
