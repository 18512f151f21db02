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
        outcome: how the run ends; None where it was judged before its end, so that nobody knows.
    """

    delayed: str = ""
    delay: int = 0
    outcome: str | None = None

    @property
    def ends_well(self) -> bool:
        """Whether the run ends as *done*."""
        return self.outcome == "done"

    @property
    def rank(self) -> int:
        """2 if the run ends well, 1 if nobody knows, else 0."""
        return 2 if self.ends_well else 1 if self.outcome is None else 0

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
    """A run that keeps the property: one with fewer failures, else one with a wait, best one that ends as *done*.

    Args:
        one: the property.
        confirmed: the run that breaks it.
        moment: the step of it that decided; the one that broke it where that is not known.
        agents: whose events decided, those first whose events matter most.
        fresh: makes the run of a seed, before its first step; it needs a time limit.
        stop: polled now and then; True stops the search.
    """
    trials = _Trials(one, confirmed, fresh, stop)
    for candidate in _fewer_failures(confirmed):
        if trials.judge(candidate) is not None:
            return trials.kept
    for waits in _waits(confirmed, moment, agents[:_MOST_AGENTS], fresh(confirmed.seed).tick_ms):
        trials.judge_waits(waits)
        if trials.kept is not None and trials.kept.rank > 0:
            break
    return trials.kept


class _Trials:
    """Judges candidates, at most `_MOST_RUNS`.

    Attributes:
        kept: the best one that keeps the property: of those that end equally well the first, with its shortest wait.
        broken_at: the step in which the last one that was judged breaks it; None where it does not.
    """

    def __init__(
        self, one: Property, confirmed: ConfirmedRun, fresh: Callable[[int], Simulation], stop: Callable[[], bool]
    ) -> None:
        self.kept: KeptRun | None = None
        self.broken_at: int | None = None
        self._one, self._confirmed, self._fresh, self._stop = one, confirmed, fresh, stop
        self._left = _MOST_RUNS

    def judge(self, candidate: KeptRun) -> KeptRun | None:
        """The run with its outcome if it keeps the property, else None."""
        if self._left == 0 or self._stop():
            return None
        self._left -= 1
        run = self._fresh(candidate.seed)
        judged = judge_run(self._one, run, candidate.faults, self._stop)
        self.broken_at = judged.tick if judged.is_broken else None
        if judged.is_broken is not False:
            return None
        found, best = replace(candidate, outcome=run.outcome), self.kept
        if best is None or found.rank > best.rank or (found.rank == best.rank and _is_shorter(found, best)):
            self.kept = found
        return found

    def judge_waits(self, waits: Sequence[KeptRun]) -> None:
        """Judges the waits of an agent from one moment on, the longest first, until a shorter one is good enough."""
        longest, *shorter = waits
        if self.judge(longest) is None and self.broken_at == self._confirmed.tick:
            # Not even the longest wait changes anything, as where an arm swings on.
            return
        for wait in shorter:
            found = self.judge(wait)
            if found is not None and found is self.kept and found.rank > 0:
                return


def _is_shorter(one: KeptRun, other: KeptRun) -> bool:
    """Whether it is the same wait, but shorter."""
    return (one.tick, one.delayed) == (other.tick, other.delayed) and one.delay < other.delay


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
