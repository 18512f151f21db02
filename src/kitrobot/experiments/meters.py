"""What measures a run: at its end, or from the numbers that are read after each step (`sim.step.probes`).

A stretch of steps runs in one call, and its numbers come column by column. What a condition or a sum says of the same
numbers is worked out once and remembered.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from operator import gt, sub
from typing import Any, Protocol

from kitrobot.primitives.robot import Robot
from kitrobot.sim.breakpoints import Condition as Test
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.probes import (
    OF_ACTUATORS,
    OF_CELLS,
    OF_ROBOTS,
    OF_TAKENS,
    OF_TEAM_GROUPS,
    OF_TEAM_ROBOTS,
    FloatPlace,
    IntPlace,
    begin_probes,
    take_probed,
)
from kitrobot.sim.tables.columns import A_ROBOT, A_TAKEN, DOWN, FAILED, PROGRAM, X, Y
from kitrobot.sim.tables.state import numbers
from kitrobot.sim.tables.team_columns import T_ROLE
from kitrobot.verifier.properties.conditions import AgentCondition
from kitrobot.verifier.properties.run_conditions import AgentValuation, members_in_set

Number = int | float | None
"""What is measured; None: nothing, as of a condition that never held."""

_MOST_KNOWN = 100_000
"""Answers that are remembered at most; then they are forgotten, all at once."""


class Meter(Protocol):
    """Measures one run after another: told of the beginning of each, and of the numbers at `ints` and `floats` after
    each step, a column for each place.
    """

    @property
    def ints(self) -> Sequence[IntPlace]: ...

    @property
    def floats(self) -> Sequence[FloatPlace]: ...

    def begin(self) -> None: ...

    def after_steps(self, ints: Sequence[Sequence[int]], floats: Sequence[Sequence[float]]) -> None: ...

    def value(self) -> Number: ...


class MeterBank:
    """The meters of a run by name, and the probes that they need; make it before the first step."""

    def __init__(self, meters: Mapping[str, Meter], run: Simulation) -> None:
        self._meters, self._run = meters, run
        ints = {place: at for at, place in enumerate(dict.fromkeys(chain(*(one.ints for one in meters.values()))))}
        floats = {place: at for at, place in enumerate(dict.fromkeys(chain(*(one.floats for one in meters.values()))))}
        self._reading = [
            (meter, [ints[place] for place in meter.ints], [floats[place] for place in meter.floats])
            for meter in meters.values()
            if meter.ints or meter.floats
        ]
        if self._reading:
            run.probe(list(ints), list(floats))

    def begin(self) -> None:
        """A run begins, with the next step."""
        for meter in self._meters.values():
            meter.begin()
        if self._reading:
            begin_probes(self._run.state)

    def after_steps(self) -> None:
        """Some steps were run."""
        if not self._reading:
            return
        ints, floats = take_probed(self._run.state)
        if ints or floats:
            for meter, whole, real in self._reading:
                meter.after_steps([ints[at] for at in whole], [floats[at] for at in real])

    def values(self) -> dict[str, Any]:
        """What was measured, by name."""
        return {name: meter.value() for name, meter in self._meters.items()}


class EndMeter:
    """Reads a number at the end."""

    ints: Sequence[IntPlace] = ()
    floats: Sequence[FloatPlace] = ()

    def __init__(self, read: Callable[[Simulation], Number], run: Simulation) -> None:
        self._read, self._run = read, run

    def begin(self) -> None: ...

    def after_steps(self, ints: Sequence[Sequence[int]], floats: Sequence[Sequence[float]]) -> None: ...

    def value(self) -> Number:
        return self._read(self._run)


class _Answers(dict[tuple[int, ...], Any]):
    """What a function says of numbers, remembered."""

    def __init__(self, answer: Callable[[tuple[int, ...]], Any]) -> None:
        self._answer = answer

    def __missing__(self, key: tuple[int, ...]) -> Any:
        if len(self) >= _MOST_KNOWN:
            self.clear()
        found = self[key] = self._answer(key)
        return found

    def each(self, columns: Sequence[Sequence[int]]) -> list[Any]:
        """What it says of each row of the columns."""
        return list(map(self.__getitem__, zip(*columns, strict=True)))


class ConditionMeter:
    """The seconds in which a condition held (`time`), its first second (`first`), how often it began to (`count`).

    A test is tried on what it names of an agent; which tests hold for whom decides the condition.
    """

    floats: Sequence[FloatPlace] = ()

    def __init__(self, kind: str, condition: AgentCondition, run: Simulation) -> None:
        self._kind, self._condition, self._run = kind, condition, run
        self.ints: list[IntPlace] = []
        known: dict[tuple[int, str], _Answers] = {}
        self._tests: list[tuple[_Answers, slice]] = []
        self._pairs = [(agent, test) for test, agents in condition.tests.items() for agent in agents]
        for agent, test in self._pairs:
            robot, cells = run.members[agent].robot, _cells(run, agent, condition.names[test])
            if (id(robot), test) not in known:
                known[id(robot), test] = _Answers(_try(test, robot, cells, run.members[agent].machine.layout.cells))
            self._tests.append((known[id(robot), test], slice(len(self.ints), len(self.ints) + len(cells))))
            self.ints += [(OF_CELLS, agent, cell) for cell in cells]
        self._sets_from = len(self.ints)
        if condition.sets:
            robots, groups = range(len(run.members)), range(len(run.state.team.groups))
            self.ints += [(OF_TEAM_ROBOTS, T_ROLE, i) for i in robots]
            self.ints += [(OF_TEAM_GROUPS, group, i) for group in groups for i in robots]
        self._verdicts = _Answers(self._decide)
        self.begin()

    def begin(self) -> None:
        self._held, self._steps, self._ticks, self._times = False, 0, 0, 0
        self._first: int | None = None

    def after_steps(self, ints: Sequence[Sequence[int]], floats: Sequence[Sequence[float]]) -> None:
        truths = [answers.each(ints[cells]) for answers, cells in self._tests]
        holds = self._verdicts.each([*truths, *ints[self._sets_from :]])
        if any(holds):
            self._ticks += sum(holds)
            self._times += sum(map(gt, holds, [self._held, *holds]))
            if self._first is None:
                self._first = self._steps + holds.index(True) + 1
        self._held = holds[-1]
        self._steps += len(holds)

    def value(self) -> Number:
        if self._kind == "count":
            return self._times
        ticks = self._ticks if self._kind == "time" else self._first
        return None if ticks is None else ticks * self._run.tick_ms / 1000

    def _decide(self, key: tuple[int, ...]) -> bool:
        """Whether the condition holds where the tests hold so, and robots are in these roles and groups."""
        count = len(self._pairs)
        truths = dict(zip(self._pairs, key, strict=False))
        team = self._run.state.team
        if self._condition.sets:
            rows = [
                list(key[at : at + len(self._run.members)]) for at in range(count, len(key), len(self._run.members))
            ]
            robots: list[list[int]] = [[] for _ in team.robots]
            robots[T_ROLE] = rows[0]
            team = replace(team, robots=robots, groups=rows[1:])
        return self._condition.holds(
            lambda agent, test: bool(truths.get((agent, test))), lambda name: members_in_set(self._run, team, name)
        )


def _cells(run: Simulation, agent: int, names: frozenset[str]) -> list[int]:
    """The cells of an agent's machine that a test which names these parts reads: at least one, so that it is asked."""
    layout = run.members[agent].machine.layout
    places = layout.sensors | layout.variables
    if not names <= places.keys():
        return list(range(layout.cells))
    return sorted(places[name] for name in names) or [0]


def _try(test: str, robot: Robot, cells: Sequence[int], count: int) -> Callable[[tuple[int, ...]], bool]:
    """What tries a test on the numbers in some of so many cells."""
    tried, row = Test(test, robot), [0] * count

    def holds(key: tuple[int, ...]) -> bool:
        for cell, number in zip(cells, key, strict=True):
            row[cell] = number
        return tried.holds(AgentValuation(row))

    return holds


class DistanceMeter:
    """How far agents went, from middle to middle, step by step."""

    ints: Sequence[IntPlace] = ()

    def __init__(self, agents: Sequence[int], run: Simulation) -> None:
        self._run = run
        self.floats = [(column, i) for i in agents for column in (X, Y)]
        self.begin()

    def begin(self) -> None:
        self._sum = 0.0
        table = self._run.state.robots.floats
        self._last = [float(table[column][i]) for column, i in self.floats]

    def after_steps(self, ints: Sequence[Sequence[int]], floats: Sequence[Sequence[float]]) -> None:
        changes = [list(map(sub, column, [last, *column])) for column, last in zip(floats, self._last, strict=True)]
        ways = [map(math.hypot, dx, dy) for dx, dy in zip(changes[::2], changes[1::2], strict=True)]
        for way in map(sum, zip(*ways, strict=True)):
            self._sum += way
        self._last = [column[-1] for column in floats]

    def value(self) -> Number:
        return round(self._sum, 3)


class EnergyMeter:
    """Sizes of the numbers in the commands in force, times seconds; of robots that failed nothing."""

    floats: Sequence[FloatPlace] = ()

    def __init__(self, agents: Sequence[int], run: Simulation) -> None:
        self._tick_ms = run.tick_ms
        actuators, machines = run.state.actuators, run.state.machines
        wanted, programs = set(agents), numbers(run.state.robots.ints[PROGRAM])
        self.ints: list[IntPlace] = []
        self._actuators: list[tuple[_Answers, slice]] = []
        known: dict[int, _Answers] = {}
        for k, i in enumerate(numbers(actuators.ints[A_ROBOT])):
            if i in wanted:
                counts = [int(one) for one in machines.commands[programs[i]][1::3]]
                answers = known.setdefault(programs[i], _Answers(_size(counts)))
                places = [(OF_ROBOTS, DOWN, i), (OF_ACTUATORS, A_TAKEN, k)]
                places += [(OF_TAKENS, k, column) for column in range(len(actuators.takens[k]))]
                self._actuators.append((answers, slice(len(self.ints), len(self.ints) + len(places))))
                self.ints += places
        self.begin()

    def begin(self) -> None:
        self._sum = 0

    def after_steps(self, ints: Sequence[Sequence[int]], floats: Sequence[Sequence[float]]) -> None:
        self._sum += sum(sum(answers.each(ints[columns])) for answers, columns in self._actuators)

    def value(self) -> Number:
        return round(self._sum * self._tick_ms / 1000, 3)


def _size(counts: Sequence[int]) -> Callable[[tuple[int, ...]], int]:
    """What adds up the numbers of a command in force; `counts` says how many each command has."""

    def size(key: tuple[int, ...]) -> int:
        down, taken, *arguments = key
        return sum(map(abs, arguments[: counts[taken]])) if taken >= 0 and down != FAILED else 0

    return size
