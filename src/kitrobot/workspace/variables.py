"""Variables that a user gives a robot: checks of their names and numbers, with messages for the user who just typed
them.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.lll.tokens import is_name
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.own_xml import MOST_OWN, OwnVariable, read_own, write_variable
from kitrobot.primitives.robot import LARGEST_VALUE, Category, Robot, RobotObject, ValueType
from kitrobot.text.sentences import Sentence

LONGEST_NAME = 100

_KINDS = {
    Category.ACTUATOR: Sentence("an actuator"),
    Category.SENSOR: Sentence("a sensor"),
    Category.VARIABLE: Sentence("a variable"),
    Category.SYSTEM: Sentence("a part"),
}


class VariableError(KitRobotError):
    """A variable cannot be as it is wanted."""


@dataclass(frozen=True)
class WantedVariable:
    """What a person typed; of a truth only `initial` counts, as 0 or not."""

    name: str
    type: ValueType
    minimum: int
    maximum: int
    initial: int
    shared: bool


def make_variable(
    catalogue: Catalogue, own: Sequence[OwnVariable], robot: str, wanted: WantedVariable, was: str = ""
) -> OwnVariable:
    """The variable that was wanted, with its methods.

    Args:
        catalogue: what the files hold.
        own: the variables that the mission has already.
        robot: the kind of robot that it is for.
        wanted: what it is to be.
        was: the variable in whose place it comes, "" for a new one.

    Raises:
        KitRobotError: there is no such robot.
        VariableError: it cannot be; the message says why.
    """
    kind = catalogue.robot(robot)
    before = (
        next((one.variable for one in own if (one.robot, one.variable.name) == (robot, was)), None) if was else None
    )
    if was and before is None:
        raise _not_ours(catalogue, kind, was)
    if not was and len(own) >= MOST_OWN:
        raise VariableError(
            Sentence("a mission has at most {most} variables of its own", MOST_OWN),
            Sentence("remove one that nobody uses"),
        )
    name = unicodedata.normalize("NFC", wanted.name).strip()
    others = [one.variable.name for one in own if one.robot == robot and one.variable.name != was]
    _check_name(kind, others, name)
    is_number = wanted.type is ValueType.INTEGER
    if is_number:
        _check_numbers(wanted)
    variable = RobotObject(
        name,
        Category.VARIABLE,
        (),
        type=wanted.type,
        minimum=wanted.minimum if is_number else 0,
        maximum=wanted.maximum if is_number else 1,
        initial=wanted.initial if is_number else int(wanted.initial != 0),
        shared=wanted.shared,
        icon=before.icon if before is not None else "",
        # A label says what the variable was called.
        label=before.label if before is not None and before.name == name else {},
        help=before.help if before is not None else {},
    )
    made, problems = read_own(write_variable(OwnVariable(robot, variable)), "variable")
    if not isinstance(made, OwnVariable):
        raise VariableError(problems[0].message, problems[0].help)
    return made


def _not_ours(catalogue: Catalogue, robot: Robot, name: str) -> VariableError:
    file = catalogue.robot_files.get(robot.name)
    if file is None or not any(part.name == name for part in robot.objects):
        return VariableError(
            Sentence("`{name}` is no variable of this mission", name), Sentence("it may have been removed meanwhile")
        )
    return VariableError(
        Sentence("`{name}` belongs to the robot {robot} itself", name, robot.name),
        Sentence("it is in the file `{file}` and can be changed there", file.name),
    )


def _check_name(robot: Robot, others: Sequence[str], name: str) -> None:
    if not name:
        raise VariableError(Sentence("the variable has no name yet"), Sentence("type one, such as Trips"))
    if not is_name(name) or len(name) > LONGEST_NAME:
        raise VariableError(
            Sentence("a variable cannot be called `{name}`", name[:40]),
            Sentence(
                "a name is one word of letters, digits and _ that begins with a letter, with at most {longest} "
                "signs; WAIT and BREAK are taken",
                LONGEST_NAME,
            ),
        )
    part = next((part for part in robot.objects if part.name == name), None)
    if part is not None:
        what = _KINDS[part.category]
        raise VariableError(
            Sentence("`{name}` is {what} of the robot {robot} already", name, what, robot.name),
            Sentence("choose another name"),
        )
    if name in others:
        raise VariableError(Sentence("there is a variable `{name}` already", name), Sentence("choose another name"))


def _check_numbers(wanted: WantedVariable) -> None:
    low, high, initial = wanted.minimum, wanted.maximum, wanted.initial
    for number in (low, high, initial):
        if abs(number) > LARGEST_VALUE:
            raise VariableError(
                Sentence("{number} is too large for a robot", number),
                Sentence("numbers go from {smallest} to {largest}", -LARGEST_VALUE, LARGEST_VALUE),
            )
    if low > high:
        raise VariableError(
            Sentence("a range from {low} to {high} holds no number", low, high),
            Sentence("put the smaller number first"),
        )
    if not low <= initial <= high:
        raise VariableError(
            Sentence("the variable cannot begin at {initial}", initial),
            Sentence("its numbers go from {low} to {high}; choose one of them", low, high),
        )
