"""Measures of a run: what it tells at its end, and what is added up from tick to tick.

| text | measures |
|---|---|
| `seconds`, `ticks` | simulated time |
| `delivered`, `total`, `collisions` | boxes brought, boxes there are, beginnings of touches |
| `done` | 1 when the outcome is done, else 0 |
| `distance` | mm that the robots went, from middle to middle, tick by tick |
| `energy` | sizes of the numbers in the commands in force, times seconds; of robots that failed nothing |
| `time COND`, `first COND`, `count COND` | seconds in which a condition held, its first second, how often it began to |

`delivered.AGENT`, `distance.AGENT` and `energy.AGENT` are those of one agent. Conditions are those of properties
(docs/check.md), on what the agents read in their last tick. A name may stand before: `waited=time all carrier (…)`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import A_ROBOT, A_TAKEN, DOWN, FAILED, PROGRAM, X, Y
from kitrobot.sim.tables.state import numbers
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.verifier.properties.conditions import AgentCondition, PropertyError, parse_condition
from kitrobot.verifier.properties.run_conditions import declared_of, simulated_conditions, team_of

Number = int | float | None
"""What is measured; None: nothing, as of a condition that never held."""

USUAL = ("seconds", "done", "delivered", "collisions")
"""What is measured when nothing is said."""

_AT_END: dict[str, Callable[[Simulation], Number]] = {
    "seconds": lambda run: run.seconds,
    "ticks": lambda run: run.tick,
    "delivered": lambda run: sum(run.delivered.values()),
    "total": lambda run: run.total,
    "collisions": lambda run: run.collisions,
    "done": lambda run: int(run.outcome == "done"),
}
_NAMED = re.compile(r"\s*([^\W\d][\w.-]*)\s*=\s*(.+)", re.DOTALL)
_CONDITION = re.compile(r"(time|first|count)\s+(.+)", re.DOTALL)
_OF_AGENTS = ("delivered", "distance", "energy")


@dataclass(frozen=True)
class Measure:
    """A measure by its name, which is its text unless another one was given."""

    name: str
    text: str


def offered_measures(run: Simulation) -> list[str]:
    """What a page offers to measure in a run, the usual first; boxes only where there are some."""
    names = ["seconds", "done", "delivered", "collisions", "distance", "energy"]
    return [name for name in names if name != "delivered" or run.total > 0]


class Meter(Protocol):
    """Measures one run: told of its beginning and of each step, unless it only looks at the end."""

    each_step: bool

    def begin(self) -> None: ...

    def after_step(self) -> None: ...

    def value(self) -> Number: ...


def read_measures(texts: Sequence[str]) -> list[Measure]:
    """The measures of a study. A text may hold several, with commas between them, where none has brackets.

    Raises:
        ExperimentError: two have one name.
    """
    found: list[Measure] = []
    for text in texts:
        for part in _parts(text):
            named = _NAMED.fullmatch(part)
            measure = Measure(named[1], named[2].strip()) if named else Measure(part.strip(), part.strip())
            if any(measure.name == one.name for one in found):
                raise ExperimentError(Sentence("two measures are called `{name}`", measure.name))
            found.append(measure)
    return found


def _parts(text: str) -> list[str]:
    """At the commas outside brackets."""
    parts, depth = [""], 0
    for sign in text:
        depth += (sign in "({[") - (sign in ")}]")
        if sign == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return [part for part in parts if part.strip()]


def make_meter(measure: Measure, run: Simulation) -> Meter:
    """What measures that in a run, and in all that begin again with another seed.

    Raises:
        ExperimentError: the measure cannot be understood, or names what is not in this run.
    """
    text = measure.text
    if text in _AT_END:
        return _EndMeter(_AT_END[text], run)
    found = _CONDITION.fullmatch(text)
    if found is not None:
        try:
            condition = parse_condition(found[2], team_of(run), declared_of(run))
        except PropertyError as error:
            message = Sentence("the measure `{name}`: {reason}", measure.name, error.message)
            raise ExperimentError(message, error.help) from None
        return _ConditionMeter(found[1], condition, run)
    what, dot, agent = text.partition(".")
    if what in _OF_AGENTS:
        names = [one.name for one in run.members]
        if dot and agent not in names:
            message = Sentence("no agent {agent} takes part in this run", agent)
            help: Help = did_you_mean(agent, names)
            raise ExperimentError(message, help or Sentence("those who do are {known}", one_of(sorted(names)[:20])))
        chosen = [names.index(agent)] if dot else range(len(names))
        if what == "delivered":
            return _EndMeter(lambda run: run.delivered.get(agent, 0), run)
        return (_DistanceMeter if what == "distance" else _EnergyMeter)(chosen, run)
    known = [*_AT_END, "distance", "energy", "time", "first", "count"]
    raise ExperimentError(
        Sentence("`{measure}` is no measure", text),
        did_you_mean(text.partition(" ")[0], known) or Sentence("there are {known}", one_of(known)),
    )


class _EndMeter:
    each_step = False

    def __init__(self, read: Callable[[Simulation], Number], run: Simulation) -> None:
        self._read, self._run = read, run

    def begin(self) -> None: ...

    def after_step(self) -> None: ...

    def value(self) -> Number:
        return self._read(self._run)


class _ConditionMeter:
    each_step = True

    def __init__(self, kind: str, condition: AgentCondition, run: Simulation) -> None:
        self._kind, self._condition, self._run = kind, condition, run
        self._decided = simulated_conditions([condition], run)
        self.begin()

    def begin(self) -> None:
        self._held, self._ticks, self._times = False, 0, 0
        self._first: int | None = None

    def after_step(self) -> None:
        holds = self._decided.holds(self._condition)
        if holds:
            self._ticks += 1
            self._times += not self._held
            if self._first is None:
                self._first = self._run.tick
        self._held = holds

    def value(self) -> Number:
        if self._kind == "count":
            return self._times
        ticks = self._ticks if self._kind == "time" else self._first
        return None if ticks is None else ticks * self._run.tick_ms / 1000


class _DistanceMeter:
    each_step = True

    def __init__(self, agents: Sequence[int], run: Simulation) -> None:
        self._agents, self._run = agents, run
        self.begin()

    def begin(self) -> None:
        self._sum = 0.0
        self._places = self._now()

    def _now(self) -> list[tuple[float, float]]:
        xs, ys = (numbers(self._run.state.robots.floats[column]) for column in (X, Y))
        return [(xs[i], ys[i]) for i in self._agents]

    def after_step(self) -> None:
        now = self._now()
        self._sum += sum(
            math.hypot(x - was_x, y - was_y) for (x, y), (was_x, was_y) in zip(now, self._places, strict=True)
        )
        self._places = now

    def value(self) -> Number:
        return round(self._sum, 3)


class _EnergyMeter:
    each_step = True

    def __init__(self, agents: Sequence[int], run: Simulation) -> None:
        self._run = run
        wanted = set(agents)
        self._actuators = [(k, i) for k, i in enumerate(numbers(run.state.actuators.ints[A_ROBOT])) if i in wanted]
        programs, commands = numbers(run.state.robots.ints[PROGRAM]), run.state.machines.commands
        self._counts = {i: [int(one) for one in commands[programs[i]][1::3]] for i in wanted}
        self.begin()

    def begin(self) -> None:
        self._sum = 0

    def after_step(self) -> None:
        state = self._run.state
        taken, down, takens = (
            numbers(state.actuators.ints[A_TAKEN]),
            numbers(state.robots.ints[DOWN]),
            state.actuators.takens,
        )
        for k, i in self._actuators:
            if taken[k] >= 0 and down[i] != FAILED:
                arguments: Any = takens[k]
                self._sum += sum(abs(int(one)) for one in arguments[: self._counts[i][taken[k]]])

    def value(self) -> Number:
        return round(self._sum * self._run.tick_ms / 1000, 3)
