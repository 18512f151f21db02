"""A run of the simulator that keeps a property, the same as one that breaks it up to a moment.

It is that run without its last failures, or one in which a robot waits at the moment that decided: it misses its ticks
for a while, so that what it did there comes later. Where that is too late, because an arm swings already, it waits a
little earlier. Each such run is judged like the one that breaks the property (`replay.judge_run`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.report.replay import ConfirmedRun, InjectedFault, judge_run

_DELAYS_MS = (500, 2_000, 8_000, 32_000)
"""How long a robot waits."""
_EARLIER_MS = (0, 160, 640, 2_560, 10_240)
"""How long before the moment it begins to."""
_MOST_AGENTS = 2
_MOST_RUNS = 40


@dataclass(frozen=True)
class KeptRun(ConfirmedRun):
    """A run of the simulator that keeps a property; its `tick` is the step in which it parts from the broken one.

    Attributes:
        delayed: the agent that waits there; "" where the run lacks failures of the broken one instead.
        delay: how many steps of the simulator it waits.
        ends_well: whether the run ends as *done*.
    """

    delayed: str = ""
    delay: int = 0
    ends_well: bool = False

    def to_json(self, tick_ms: int) -> dict[str, Any]:
        """As plain values; `tick_ms`: a step of the simulator."""
        return {
            **super().to_json(tick_ms),
            "delayed": self.delayed,
            "delay_seconds": self.delay * tick_ms / 1000,
            "ends_well": self.ends_well,
        }


def find_kept_run(
    one: Property,
    confirmed: ConfirmedRun,
    moment: int,
    agents: Sequence[str],
    fresh: Callable[[int], Simulation],
    stop: Callable[[], bool],
) -> KeptRun | None:
    """The first of these runs that keeps the property, best one that ends as *done*; None where none does.

    Args:
        one: the property.
        confirmed: the run that breaks it.
        moment: the step of it that decided; the one that broke it where that is not known.
        agents: whose events decided, those first whose events matter most.
        fresh: makes the run of a seed, before its first step; it needs a time limit.
        stop: polled now and then; True stops the search.
    """
    kept: KeptRun | None = None
    tries = (*_fewer_failures(confirmed), *_delays(confirmed, moment, agents, fresh(confirmed.seed).tick_ms))
    for candidate in islice(tries, _MOST_RUNS):
        if stop():
            break
        run = fresh(confirmed.seed)
        if judge_run(one, run, candidate.faults, stop).is_broken is not False:
            continue
        ends_well = run.outcome == "done"
        if kept is None or ends_well:
            kept = KeptRun(*_values(candidate), ends_well)
        if ends_well or run.outcome is None or not candidate.delayed:
            break
    return kept


def _values(run: KeptRun) -> tuple[int, tuple[InjectedFault, ...], int, str, int]:
    return run.seed, run.faults, run.tick, run.delayed, run.delay


def _fewer_failures(confirmed: ConfirmedRun) -> Iterator[KeptRun]:
    """The run without its last failures, as few of them missing as may do."""
    for kept in range(len(confirmed.faults) - 1, -1, -1):
        yield KeptRun(confirmed.seed, confirmed.faults[:kept], confirmed.faults[kept].tick)


def _delays(confirmed: ConfirmedRun, moment: int, agents: Sequence[str], tick_ms: int) -> Iterator[KeptRun]:
    """The run in which an agent waits, at the moment first, then ever earlier."""
    moments = dict.fromkeys(max(0, moment - earlier // tick_ms) for earlier in _EARLIER_MS)
    for tick in moments:
        for agent in agents[:_MOST_AGENTS]:
            for delay in (max(1, length // tick_ms) for length in _DELAYS_MS):
                wait = (
                    InjectedFault(tick, agent, FailureKind.STALL),
                    InjectedFault(tick + delay, agent, FailureKind.REVIVE),
                )
                faults = sorted((*confirmed.faults, *wait), key=lambda fault: fault.tick)
                yield KeptRun(confirmed.seed, tuple(faults), tick, agent, delay)
