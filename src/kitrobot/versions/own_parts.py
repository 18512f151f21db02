"""What is different between the parts that two missions bring along, and how they are tried out, in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields
from typing import Any

from kitrobot.mission.model import Mission
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.mission.trial import Breakpoint, Failure
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import OwnVariable
from kitrobot.primitives.robot import RobotObject
from kitrobot.text.sentences import COMMA, Sentence, Series, Word

TOLD_HERE = ("constructors", "variables", "breakpoints", "failures", "breakdown", "properties")
"""The fields of a mission whose differences are told here."""

_TOLD_BY_OTHERS = ("name", "group", "role", "template", "methods")
"""What follows from the rest, or is told in words of its own."""


def own_part_differences(before: Mission, after: Mission) -> Iterator[tuple[str, str]]:
    """The kind of each difference, and its words."""
    yield from _between("own-part", _constructors(before.constructors), _constructors(after.constructors))
    yield from _between("variable", _variables(before.variables), _variables(after.variables))
    yield from _between("breakpoint", _breakpoints(before), _breakpoints(after))
    yield from _between("failure", _failures(before), _failures(after))
    yield from _between("property", _properties(before), _properties(after))
    if before.breakdown != after.breakdown:
        words = (before.breakdown.words, after.breakdown.words)
        yield "mission", Sentence("robots that fail on a road: {before} → {after}", *words)
    for list_ in ("constructors", "variables", "breakpoints", "failures", "properties"):
        old, new = getattr(before, list_), getattr(after, list_)
        if old != new and sorted(map(repr, old)) == sorted(map(repr, new)):
            yield "order", Sentence("the mission's {what} stand in another order", Word(list_))


def _constructors(own: Sequence[Constructor]) -> dict[str, Constructor]:
    return {Sentence("the own part {constructor}", constructor.name): constructor for constructor in own}


def _variables(own: Sequence[OwnVariable]) -> dict[str, RobotObject]:
    return {Sentence("the variable {variable} of {robot}", one.variable.name, one.robot): one.variable for one in own}


def _breakpoints(mission: Mission) -> dict[str, Breakpoint]:
    return {breakpoint_title(one): one for one in mission.breakpoints}


def breakpoint_title(one: Breakpoint) -> Sentence:
    """A breakpoint as sentences call it."""
    if not one.agents:
        return Sentence("the breakpoint at {vertex} of {program}", one.vertex, one.program)
    agents = Series(COMMA, one.agents)
    return Sentence("the breakpoint at {vertex} of {program} for {agents}", one.vertex, one.program, agents)


def failure_title(one: Failure) -> Sentence:
    """A failure as sentences call it."""
    return Sentence("the failure of {agent} at {seconds} s", one.agent, f"{one.at_s:g}")


def _failures(mission: Mission) -> dict[str, Failure]:
    return {failure_title(one): one for one in mission.failures}


def _properties(mission: Mission) -> dict[str, AskedProperty]:
    return {Sentence("the property {name}", one.name): one for one in mission.properties}


def _between(kind: str, old: dict[str, Any], new: dict[str, Any]) -> Iterator[tuple[str, str]]:
    for what in old:
        if what not in new:
            yield f"{kind}-removed", Sentence("{what} removed", what)
    for what, part in new.items():
        if what not in old:
            yield f"{kind}-added", Sentence("{what} added", what)
            continue
        changed = [
            Word(field.name)
            for field in fields(part)
            if field.name not in _TOLD_BY_OTHERS and getattr(part, field.name) != getattr(old[what], field.name)
        ]
        if changed:
            yield kind, Sentence("{what}: {changed} changed", what, Series(COMMA, changed))
