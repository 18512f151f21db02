"""A fact: a small program, what happens around it, and what must come of it, tick by tick."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache

import pytest

from kitrobot.lll.parse_results import parse
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from tests.oracle import Outcome
from tests.semantics.engines import start


@dataclass(frozen=True)
class Fact:
    """One sentence of the language's definition on one program.

    Attributes:
        name: The fact.
        program: LLL text for `mini-robot` (tick 20 ms, wait unit 100 ms: five ticks a unit), if `robot` says no other.
        commands: Tick → the commands handed out in it, separated by spaces; in all other ticks there are none.
        ended: The tick in which the program's thread ends; None when it runs on.
        given: Tick → what changes before it: sensors, and `done:ACTUATOR`.
        variables: Tick → variables after it (only those that matter here).
        faults: The ticks after which the fault flag is up.
        ticks: How many ticks are looked at.
    """

    name: str
    program: str
    commands: Mapping[int, str] = field(default_factory=dict)
    ended: int | None = None
    given: Mapping[int, Mapping[str, int]] = field(default_factory=dict)
    variables: Mapping[int, Mapping[str, int]] = field(default_factory=dict)
    faults: range = range(0)
    ticks: int = 30
    robot: Robot | None = None


@cache
def mini_robot() -> Robot:
    """The shipped robot of the paper."""
    return load_catalogue().robots["mini-robot"]


def every_fact(facts: list[Fact]) -> pytest.MarkDecorator:
    """Parametrises a test over facts and engines; a fact's name is its test's name."""
    assert len({fact.name for fact in facts}) == len(facts)
    params = [
        pytest.param(fact, engine, id=f"{fact.name} ({engine})") for fact in facts for engine in ("oracle", "machine")
    ]
    return pytest.mark.parametrize(("fact", "engine"), params)


def holds(fact: Fact, engine: str) -> None:
    """Runs the program and compares every tick."""
    robot = fact.robot or mini_robot()
    parsed = parse(fact.program)
    assert parsed.ok, [item.message for item in parsed.diagnostics]
    machine = start(engine, parsed.program, robot)
    seen: dict[int, str] = {}
    ended: int | None = None
    faults = []
    for tick in range(fact.ticks):
        given = fact.given.get(tick, {})
        outcome = machine.tick(
            {name: value for name, value in given.items() if not name.startswith("done:")},
            {name.removeprefix("done:"): bool(value) for name, value in given.items() if name.startswith("done:")},
        )
        if outcome.commands:
            seen[tick] = written(outcome)
        if outcome.ended and ended is None:
            ended = tick
        assert outcome.ended == (ended is not None)
        if outcome.fault:
            faults.append(tick)
        for name, value in fact.variables.get(tick, {}).items():
            assert (tick, name, outcome.variables[name]) == (tick, name, value)
    assert seen == dict(fact.commands)
    assert ended == fact.ended
    assert faults == list(fact.faults)


def written(outcome: Outcome) -> str:
    """Commands as a line of text."""
    return " ".join(f"{procedure}({','.join(map(str, arguments))})" for procedure, arguments in outcome.commands)


def every(ticks: range, commands: str) -> dict[int, str]:
    """The same commands in each of these ticks."""
    return dict.fromkeys(ticks, commands)
