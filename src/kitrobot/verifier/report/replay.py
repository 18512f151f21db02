"""Confirms a counterexample in the simulator: tries seeds, and times for faults, until a run breaks the property.

The faults come from the counterexample of the model: which agents fail, stall or recover, in which order. The model has
no times, so several are tried, spread evenly over the run without faults.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, combinations
from typing import Any, NamedTuple

from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model.absence import gave_up
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Counterexample
from kitrobot.verifier.tables.events import EventKind

SEEDS = 8
"""Seeds that are tried without faults."""
MOMENTS = 24
"""Times that are tried for each fault."""
MOST_RUNS = 300
_CHUNK = 50
_LONG_CHUNK = 2000
"""Steps that are run at once where events are looked through for a violation, and where only the end counts."""
FAULT_KINDS: dict[int, str] = {
    EventKind.FAIL: "fail",
    EventKind.STALL: "stall",
    EventKind.RESUME: "revive",
    EventKind.MUTE: "mute",
}


@dataclass(frozen=True)
class InjectedFault:
    """A fault injected into the simulator: the step before which it occurs, the agent's name, and its kind."""

    tick: int
    agent: str
    kind: str


@dataclass(frozen=True)
class ConfirmedRun:
    """A run of the simulator that breaks a property: its seed, its faults, and the step of the violation."""

    seed: int
    faults: tuple[InjectedFault, ...]
    tick: int

    def to_json(self, tick_ms: int) -> dict[str, Any]:
        """As plain values; `tick_ms`: a step of the simulator."""
        return {
            "seed": self.seed,
            "seconds": self.tick * tick_ms / 1000,
            "failures": [
                {"seconds": fault.tick * tick_ms / 1000, "agent": fault.agent, "what": fault.kind}
                for fault in self.faults
            ],
        }


def confirm(
    one: Property,
    counterexample: Counterexample,
    model: Model,
    fresh: Callable[[int], Simulation],
    stop: Callable[[], bool],
) -> ConfirmedRun | None:
    """Finds a run of the simulator that breaks the property; None if it finds none.

    Args:
        one: the property.
        counterexample: the run of the model that breaks it.
        model: the model.
        fresh: makes the run of a seed, before its first step; it needs a time limit.
        stop: polled now and then; True stops the search.
    """
    wanted = injected_faults(counterexample, model)
    if not wanted:
        tries: Iterator[tuple[int, tuple[InjectedFault, ...]]] = ((seed, ()) for seed in range(1, SEEDS + 1))
    else:
        tries = _moments(wanted, fresh(1), stop)
    for number, (seed, faults) in enumerate(tries):
        if number >= MOST_RUNS or stop():
            return None
        tick = violation_tick(one, fresh(seed), faults, stop)
        if tick >= 0:
            return ConfirmedRun(seed, faults, tick)
    return None


def injected_faults(counterexample: Counterexample, model: Model) -> tuple[tuple[str, str], ...]:
    """The faults in a run of the model, in order: the agent's name and the kind. `confirm` injects no others."""
    return tuple(
        (model.parts[event.agent].agent.name, FAULT_KINDS[event.what])
        for step in counterexample.steps
        for event in step.events
        if event.what in FAULT_KINDS
    )


def _moments(
    injected_faults: Sequence[tuple[str, str]], run: Simulation, stop: Callable[[], bool]
) -> Iterator[tuple[int, tuple[InjectedFault, ...]]]:
    """The same faults at ascending times, spread over the run without faults."""
    while run.outcome is None:
        if stop():
            return
        run.advance(1000)
    moments = dict.fromkeys(max(1, run.tick * number // MOMENTS) for number in range(MOMENTS))
    # Faults before the first step are tried last: people seldom mean them.
    at_first = ((0, *later) for later in combinations(moments, len(injected_faults) - 1))
    for chosen in chain(combinations(moments, len(injected_faults)), at_first):
        yield (
            1,
            tuple(
                InjectedFault(tick, agent, kind) for tick, (agent, kind) in zip(chosen, injected_faults, strict=True)
            ),
        )


class RunJudgement(NamedTuple):
    """Whether a run breaks a property, and the step at which that is known; None: the search was stopped there."""

    is_broken: bool | None
    tick: int


class RunObserver:
    """Monitors a run for a property, by its monitor or by the events and the outcome of the run.

    The run is before its first step. Events are kept of the last call of `advance` only, so `breaks` comes after each.
    """

    def __init__(self, one: Property, run: Simulation) -> None:
        self._property, self._run = one, run
        self._monitor = one.monitor(run) if one.monitor is not None else None
        self.steps = 1 if self._monitor is not None else _CHUNK if one.seen_as else _LONG_CHUNK
        """So many steps may be made at once."""

    @property
    def is_kept(self) -> bool:
        """Whether nothing that may come breaks it."""
        return self._monitor is not None and self._monitor.is_kept

    @property
    def is_vacuous(self) -> bool:
        """Whether what the property is about did not come yet."""
        return self._monitor is not None and self._monitor.is_vacuous

    @property
    def decided_at(self) -> int:
        """The step in which that, or a violation, was decided: the last one, or 0 for the beginning of the run."""
        return 0 if self._monitor is not None and self._monitor.is_decided_at_beginning else self._run.tick

    def violation(self) -> int:
        """The step in which the last steps broke it; -1 if they did not."""
        if self._monitor is None:
            return _seen(self._property, self._run)
        return self.decided_at if self._monitor.after_step() else -1

    def is_broken_by_end(self, outcome: str) -> bool:
        """Whether the run broke it if it ends here with this outcome."""
        if self._monitor is not None:
            return self._monitor.at_end(outcome)
        has_said_why = self._property.spares_teams and gave_up(self._run.state.team)
        return outcome in self._property.ends_as and not has_said_why

    def memory(self) -> Any:
        """What its monitor remembers of the run so far."""
        return self._monitor.memory() if self._monitor is not None else None

    def remember(self, memory: Any) -> None:
        """Goes back to what `memory` gave."""
        if self._monitor is not None:
            self._monitor.remember(memory)


def judge_run(
    one: Property, run: Simulation, faults: Sequence[InjectedFault], stop: Callable[[], bool]
) -> RunJudgement:
    """Judges a run by a property; the run goes on until that is known, and no further.

    Args:
        one: the property.
        run: the run before its first step; it needs a time limit.
        faults: what is injected besides, in order.
        stop: polled now and then; True stops the search.
    """
    left = list(faults)
    monitoring = RunObserver(one, run)
    next_poll = 0
    while run.outcome is None or left:
        if run.tick >= next_poll:
            next_poll = run.tick + _CHUNK
            if stop():
                return RunJudgement(None, run.tick)
        if left and run.tick >= left[0].tick:
            fault = left.pop(0)
            run.inject_fault(fault.agent, fault.kind)
            continue
        if run.outcome is not None:
            break
        run.advance(min(monitoring.steps, left[0].tick - run.tick) if left else monitoring.steps)
        found = monitoring.violation()
        if found >= 0:
            return RunJudgement(True, found)
        if monitoring.is_kept:
            return RunJudgement(False, monitoring.decided_at)
    assert run.outcome is not None, "the run has ended"
    return RunJudgement(monitoring.is_broken_by_end(run.outcome), run.tick)


def violation_tick(one: Property, run: Simulation, faults: Sequence[InjectedFault], stop: Callable[[], bool]) -> int:
    """The step in which a run broke the property; -1 if it did not, or the search was stopped. See `judge_run`."""
    judged = judge_run(one, run, faults, stop)
    return judged.tick if judged.is_broken else -1


def _seen(one: Property, run: Simulation) -> int:
    """The step of the first event of the last steps that breaks the property; -1 for none."""
    state = run.state
    for at in range(0, c.EVENT * int(state.clock[c.EVENTS]), c.EVENT):
        kind, _, what, _, tick = state.events[at : at + c.EVENT]
        if kind in one.seen_as and not (kind == c.COLLISION and what < 0):
            return int(tick)
    return -1
