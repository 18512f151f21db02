"""Confirms a counterexample in the simulator: tries seeds, and times for faults, until a run breaks the property.

The faults come from the counterexample of the model: which agents fail, stall or recover, in which order. The model has
no times, so several are tried, spread evenly over the run without faults.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, combinations

from kitrobot.sim import Simulation
from kitrobot.sim import columns as c
from kitrobot.verifier.absence import gave_up
from kitrobot.verifier.events import What
from kitrobot.verifier.model import Model
from kitrobot.verifier.properties import Property
from kitrobot.verifier.verdicts import Way

SEEDS = 8
"""Seeds that are tried where nothing befalls anybody."""
MOMENTS = 24
"""Moments that are tried where something does."""
MOST_RUNS = 300
_CHUNK = 50
_KINDS: dict[int, str] = {What.FAIL: "fail", What.STALL: "stall", What.RESUME: "revive", What.MUTE: "mute"}


@dataclass(frozen=True)
class Harm:
    """Something that befalls an agent in the simulator: the step before which it does, the agent's name, and what."""

    tick: int
    agent: str
    kind: str


@dataclass(frozen=True)
class Confirmed:
    """A run of the simulator that breaks a property: its seed, what befell agents, and the step in which it broke."""

    seed: int
    harms: tuple[Harm, ...]
    tick: int


def confirm(
    one: Property, way: Way, model: Model, fresh: Callable[[int], Simulation], stop: Callable[[], bool]
) -> Confirmed | None:
    """A run of the simulator that breaks the property, or None where none was found.

    Args:
        one: the property.
        way: how the model breaks it.
        model: the model.
        fresh: gives the run of a seed before its first step; it needs a time limit.
        stop: asked now and then whether to give up.
    """
    wanted = befell(way, model)
    if not wanted:
        tries: Iterator[tuple[int, tuple[Harm, ...]]] = ((seed, ()) for seed in range(1, SEEDS + 1))
    else:
        tries = _moments(wanted, fresh(1), stop)
    for number, (seed, harms) in enumerate(tries):
        if number >= MOST_RUNS or stop():
            return None
        tick = _broken_at(one, fresh(seed), harms, stop)
        if tick >= 0:
            return Confirmed(seed, harms, tick)
    return None


def befell(way: Way, model: Model) -> tuple[tuple[str, str], ...]:
    """What befalls agents in a run of the model, in order: the agent's name, and what. `confirm` looks for no more."""
    return tuple(
        (model.parts[event.agent].agent.name, _KINDS[event.what])
        for step in way.steps
        for event in step.events
        if event.what in _KINDS
    )


def _moments(
    befell: Sequence[tuple[str, str]], run: Simulation, stop: Callable[[], bool]
) -> Iterator[tuple[int, tuple[Harm, ...]]]:
    """What befell agents, at moments in order, spread over the run in which nothing does."""
    while run.outcome is None:
        if stop():
            return
        run.advance(1000)
    moments = dict.fromkeys(max(1, run.tick * number // MOMENTS) for number in range(MOMENTS))
    # Before the first step at last: what befalls then is seldom what people mean.
    at_first = ((0, *later) for later in combinations(moments, len(befell) - 1))
    for chosen in chain(combinations(moments, len(befell)), at_first):
        yield 1, tuple(Harm(tick, agent, kind) for tick, (agent, kind) in zip(chosen, befell, strict=True))


def _broken_at(one: Property, run: Simulation, harms: Sequence[Harm], stop: Callable[[], bool]) -> int:
    """The step in which a run broke the property; -1 if it did not, or was given up."""
    left = list(harms)
    watch = one.watch(run) if one.watch is not None else None
    chunk = _CHUNK if watch is None else 1
    asked = 0
    while run.outcome is None or left:
        if run.tick >= asked:
            asked = run.tick + _CHUNK
            if stop():
                return -1
        if left and run.tick >= left[0].tick:
            harm = left.pop(0)
            run.harm(harm.agent, harm.kind)
            continue
        if run.outcome is not None:
            break
        run.advance(min(chunk, left[0].tick - run.tick) if left else chunk)
        found = _seen(one, run) if watch is None else run.tick if watch.after_step() else -1
        if found >= 0:
            return found
    if watch is not None:
        return run.tick if watch.at_end() else -1
    has_said_why = one.spares_teams and gave_up(run.state.team)
    return run.tick if run.outcome in one.ends_as and not has_said_why else -1


def _seen(one: Property, run: Simulation) -> int:
    """The step of the first event of the last steps that breaks the property; -1 for none."""
    state = run.state
    for at in range(0, c.EVENT * int(state.clock[c.EVENTS]), c.EVENT):
        kind, _, what, _, tick = state.events[at : at + c.EVENT]
        if kind in one.seen_as and not (kind == c.COLLISION and what < 0):
            return int(tick)
    return -1
