"""What nobody writes in a robot's XML because every robot has it: the methods of variables, `Fault`, a team's work.

Values given by Set, Add and Sub are clamped to the variable's range by the compiler. The range of what is *added* is
the width of the variable's range, both ways. Left to others: their words (automatic_xml).
"""

from __future__ import annotations

from functools import cache

from kitrobot.primitives.automatic_xml import worded
from kitrobot.primitives.robot import LARGEST_VALUE, Category, Kind, Method, Parameter, RobotObject, Texts, ValueType

FAULT = "Fault"
"""The system object that says whether a number had to be clamped."""

TAKE, DONE = "Take", "Done"
"""The procedures of a team's work: a unit is this robot's, and is done."""

_NUMBER, _TRUTH, _WORK = "Number", "Truth", "Work"
"""Their names in the file of words."""

_SIGNS = {"equal": "=", "less": "<", "greater": ">"}
_TESTS = (
    ("EqualTo", "equal", "equal"),
    ("LessThan", "less", "chevron-left"),
    ("GreaterThan", "greater", "chevron-right"),
)
"""The tests of a number by name, each with what it asks and its picture."""


def comparison(test: str, right: str) -> Texts:
    """The phrase of a chip for a test against a number or a parameter (`{value}`)."""
    return {"": f"{{object}} {_SIGNS[test]} {right}"}


def _change(part: str, name: str, parameter: Parameter, icon: str, phrase: str) -> Method:
    """A procedure of a variable that changes it; its action has its name."""
    made = Method(name, Kind.PROCEDURE, (parameter,), action=name.lower(), icon=icon, phrase={"": phrase})
    return worded(part, made)


def integer_methods(minimum: int, maximum: int, initial: int) -> tuple[Method, ...]:
    """Set, Add, Sub, Value, EqualTo, LessThan, GreaterThan of a variable that holds a number."""
    span = min(maximum - minimum, LARGEST_VALUE)
    value = worded(_NUMBER, Parameter("value", minimum, maximum, initial))
    amount = worded(_NUMBER, Parameter("value", -span, span, min(1, span)))
    return (
        _change(_NUMBER, "Set", value, "pencil", "{object} := {value}"),
        _change(_NUMBER, "Add", amount, "plus", "{object} + {value}"),
        _change(_NUMBER, "Sub", amount, "minus", "{object} − {value}"),
        worded(_NUMBER, Method("Value", Kind.VALUE, icon="hash", phrase={"": "{object}"})),
        *(
            worded(
                _NUMBER,
                Method(name, Kind.TEST, (value,), test=test, icon=icon, phrase=comparison(test, "{value}")),
            )
            for name, test, icon in _TESTS
        ),
    )


def number_variable(name: str, most: int) -> RobotObject:
    """A variable of no file that holds a number from 0 to `most`."""
    return RobotObject(name, Category.VARIABLE, integer_methods(0, most, 0), maximum=most)


def boolean_methods(initial: int) -> tuple[Method, ...]:
    """Set, IsTrue, IsFalse of a variable that holds true or false."""
    value = worded(_TRUTH, Parameter("value", 0, 1, initial, type=ValueType.BOOLEAN))
    return (
        _change(_TRUTH, "Set", value, "pencil", "{object} := {value}"),
        worded(_TRUTH, Method("IsTrue", Kind.TEST, test="equal", to=1, icon="toggle-right")),
        worded(_TRUTH, Method("IsFalse", Kind.TEST, test="equal", to=0, icon="toggle-left")),
    )


@cache
def fault_object() -> RobotObject:
    """`Fault`: raised when a number was out of range and had to be clamped."""
    methods = (
        Method("IsRaised", Kind.TEST, test="equal", to=1, icon="triangle-alert"),
        Method("Clear", Kind.PROCEDURE, action="clear", icon="eraser"),
    )
    made = RobotObject(
        FAULT,
        Category.SYSTEM,
        tuple(worded(FAULT, method) for method in methods),
        type=ValueType.BOOLEAN,
        maximum=1,
        icon="triangle-alert",
    )
    return worded(FAULT, made)


def work_object(name: str, units: int) -> RobotObject:
    """A work of the team: units that its members share out among themselves."""
    methods = (
        Method(TAKE, Kind.PROCEDURE, completes_later=True, icon="hand"),
        Method(DONE, Kind.PROCEDURE, completes_later=True, icon="check"),
        Method("IsEmpty", Kind.TEST, test="equal", to=0, icon="package-open"),
        Method("Left", Kind.VALUE, icon="hash"),
    )
    made = RobotObject(
        name,
        Category.SYSTEM,
        tuple(worded(_WORK, method) for method in methods),
        maximum=units,
        initial=units,
        shared=True,
        icon="package",
    )
    return worded(_WORK, made)
