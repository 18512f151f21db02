"""A run of the simulator that keeps a property, the same as one that breaks it up to a moment.

It is that run without its last failures, or one in which a robot waits at the moment that decided: it misses its ticks
for a while, so that what it did there comes later. Where that is too late, because an arm swings already, it waits a
little earlier. Each such run is judged like the one that breaks the property (`replay.judge_run`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.report.replay import ConfirmedRun, InjectedFault, judge_run

_DELAYS_MS = (32_000, 500, 2_000, 8_000)
"""How long a robot waits: the longest first, which shows whether waiting changes anything."""
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
    left = _MOST_RUNS
    waits = _waits(confirmed, moment, agents[:_MOST_AGENTS], fresh(confirmed.seed).tick_ms)
    for group in (*([each] for each in _fewer_failures(confirmed)), *waits):
        is_settled = False
        for number, candidate in enumerate(group):
            if left == 0 or stop():
                return kept
            left -= 1
            run = fresh(confirmed.seed)
            judged = judge_run(one, run, candidate.faults, stop)
            if judged.is_broken is False:
                candidate = replace(candidate, ends_well=run.outcome == "done")
                kept = _better(kept, candidate)
                # Where it was kept before the run ended nobody knows how it ends.
                is_settled = candidate.ends_well or run.outcome is None or not candidate.delayed
                if is_settled and number > 0:
                    return kept
            elif number == 0 and judged.tick == confirmed.tick:
                # Not even the longest wait changes anything, as where an arm swings on.
                break
        if is_settled or (kept is not None and kept.ends_well):
            return kept
    return kept


def _better(kept: KeptRun | None, other: KeptRun) -> KeptRun:
    """Of two the one that ends well, then the one that parts later, then the one that waits less."""
    if kept is None or other.ends_well > kept.ends_well:
        return other
    is_shorter = (other.tick, other.delayed) == (kept.tick, kept.delayed) and other.delay < kept.delay
    return other if is_shorter and other.ends_well == kept.ends_well else kept


def _fewer_failures(confirmed: ConfirmedRun) -> Iterator[KeptRun]:
    """The run without its last failures, as few of them missing as may do."""
    for kept in range(len(confirmed.faults) - 1, -1, -1):
        yield KeptRun(confirmed.seed, confirmed.faults[:kept], confirmed.faults[kept].tick)


def _waits(confirmed: ConfirmedRun, moment: int, agents: Sequence[str], tick_ms: int) -> Iterator[list[KeptRun]]:
    """The runs in which an agent waits, at the moment first, then ever earlier; of each the longest first."""
    moments = dict.fromkeys(max(0, moment - earlier // tick_ms) for earlier in _EARLIER_MS)
    for tick, agent in product(moments, agents):
        group = []
        for delay in (max(1, length // tick_ms) for length in _DELAYS_MS):
            wait = (
                InjectedFault(tick, agent, FailureKind.STALL),
                InjectedFault(tick + delay, agent, FailureKind.REVIVE),
            )
            faults = sorted((*confirmed.faults, *wait), key=lambda fault: fault.tick)
            group.append(KeptRun(confirmed.seed, tuple(faults), tick, agent, delay))
        yield group
