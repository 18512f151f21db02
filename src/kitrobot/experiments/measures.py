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

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.meters import ConditionMeter, DistanceMeter, EndMeter, EnergyMeter, Meter, Number
from kitrobot.sim.simulation import Simulation
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.verifier.properties.conditions import PropertyError, parse_condition
from kitrobot.verifier.properties.run_conditions import declared_of, team_of

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
        return EndMeter(_AT_END[text], run)
    found = _CONDITION.fullmatch(text)
    if found is not None:
        try:
            condition = parse_condition(found[2], team_of(run), declared_of(run))
        except PropertyError as error:
            message = Sentence("the measure `{name}`: {reason}", measure.name, error.message)
            raise ExperimentError(message, error.help) from None
        return ConditionMeter(found[1], condition, run)
    what, dot, agent = text.partition(".")
    if what in _OF_AGENTS:
        names = [one.name for one in run.members]
        if dot and agent not in names:
            message = Sentence("no agent {agent} takes part in this run", agent)
            help: Help = did_you_mean(agent, names)
            raise ExperimentError(message, help or Sentence("those who do are {known}", one_of(sorted(names)[:20])))
        chosen = [names.index(agent)] if dot else range(len(names))
        if what == "delivered":
            return EndMeter(lambda run: run.delivered.get(agent, 0), run)
        return (DistanceMeter if what == "distance" else EnergyMeter)(chosen, run)
    known = [*_AT_END, "distance", "energy", "time", "first", "count"]
    raise ExperimentError(
        Sentence("`{measure}` is no measure", text),
        did_you_mean(text.partition(" ")[0], known) or Sentence("there are {known}", one_of(known)),
    )
