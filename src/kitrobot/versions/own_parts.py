"""What is different between the parts that two missions bring along, and how they are tried out, in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields
from typing import Any

from kitrobot.mission import Breakpoint, Failure, Mission
from kitrobot.primitives import Constructor, OwnVariable, RobotObject

TOLD_HERE = ("constructors", "variables", "breakpoints", "failures")
"""The fields of a mission whose differences are told here."""

_TOLD_BY_OTHERS = ("name", "group", "role", "template", "methods")
"""What follows from the rest, or is told in words of its own."""


def own_part_differences(before: Mission, after: Mission) -> Iterator[tuple[str, str]]:
    """The kind of each difference, and its words."""
    yield from _between("own-part", _constructors(before.constructors), _constructors(after.constructors))
    yield from _between("variable", _variables(before.variables), _variables(after.variables))
    yield from _between("breakpoint", _breakpoints(before), _breakpoints(after))
    yield from _between("failure", _failures(before), _failures(after))
    for list_ in TOLD_HERE:
        old, new = getattr(before, list_), getattr(after, list_)
        if old != new and sorted(map(repr, old)) == sorted(map(repr, new)):
            yield "order", f"the mission's {list_} stand in another order"


def _constructors(own: Sequence[Constructor]) -> dict[str, Constructor]:
    return {f"the own part {constructor.name}": constructor for constructor in own}


def _variables(own: Sequence[OwnVariable]) -> dict[str, RobotObject]:
    return {f"the variable {one.variable.name} of {one.robot}": one.variable for one in own}


def _breakpoints(mission: Mission) -> dict[str, Breakpoint]:
    return {
        f"the breakpoint at {one.vertex} of {one.program}{' for ' if one.agents else ''}{', '.join(one.agents)}": one
        for one in mission.breakpoints
    }


def _failures(mission: Mission) -> dict[str, Failure]:
    return {f"the failure of {one.agent} at {one.at_s:g} s": one for one in mission.failures}


def _between(kind: str, old: dict[str, Any], new: dict[str, Any]) -> Iterator[tuple[str, str]]:
    for what in old:
        if what not in new:
            yield f"{kind}-removed", f"{what} removed"
    for what, part in new.items():
        if what not in old:
            yield f"{kind}-added", f"{what} added"
            continue
        changed = [
            field.name
            for field in fields(part)
            if field.name not in _TOLD_BY_OTHERS and getattr(part, field.name) != getattr(old[what], field.name)
        ]
        if changed:
            yield kind, f"{what}: {', '.join(changed)} changed"
