"""Whether a condition holds whatever the robot senses, as far as that can be seen.

A test that compares with a number is looked at beside the range of what it looks at. The others may be true or false,
each the same wherever it stands in the condition; all combinations of up to `MOST_TESTS` of them are tried.
"""

from __future__ import annotations

from itertools import product

from kitrobot.lll.tree import And, Call, Condition, Hole, Joint, Not, Number, Or
from kitrobot.primitives.robot import Robot

MOST_TESTS = 6
"""Different tests in a condition, of which every combination is tried; a condition with more is not known."""


def always_holds(condition: Condition | None, robot: Robot) -> bool:
    """Whether a condition surely holds; one that is not there does."""
    tests: list[Call] = []
    if condition is None:
        return True
    if not _collect(condition, tests, robot):
        return False
    return all(_holds(condition, tests, values, robot) for values in product((False, True), repeat=len(tests)))


def _collect(condition: Condition, tests: list[Call], robot: Robot) -> bool:
    """Adds the tests of a condition whose truth is open; False where there are too many, or one cannot be read."""
    match condition:
        case And() | Or():
            return _collect(condition.left, tests, robot) and _collect(condition.right, tests, robot)
        case Not():
            return _collect(condition.condition, tests, robot)
        case Hole() | Joint():
            return False
        case Call():
            if _known(condition, robot) is None and condition not in tests:
                tests.append(condition)
            return bool(condition.object) and len(tests) <= MOST_TESTS


def _holds(condition: Condition, tests: list[Call], values: tuple[bool, ...], robot: Robot) -> bool:
    match condition:
        case And():
            return _holds(condition.left, tests, values, robot) and _holds(condition.right, tests, values, robot)
        case Or():
            return _holds(condition.left, tests, values, robot) or _holds(condition.right, tests, values, robot)
        case Not():
            return not _holds(condition.condition, tests, values, robot)
        case Call():
            known = _known(condition, robot)
            return values[tests.index(condition)] if known is None else known
        case Hole() | Joint():
            return False


def _known(call: Call, robot: Robot) -> bool | None:
    """What a comparison with a number gives for all of its object's range, or None where that differs."""
    meaning = robot.calls.get((call.object, call.method))
    if meaning is None or not meaning[1].test:
        return None
    part, method = meaning
    param = call.params[0] if call.params else None
    to = method.to if method.to is not None else param.value if isinstance(param, Number) else None
    if to is None:
        return None
    match method.test:
        case "equal":
            ends = {part.minimum == to == part.maximum, part.minimum <= to <= part.maximum}
        case "less":
            ends = {part.minimum < to, part.maximum < to}
        case _:
            ends = {part.minimum > to, part.maximum > to}
    return ends.pop() if len(ends) == 1 else None
