"""Fail sweeps: one run again and again, in each of which other robots fail at other moments.

A *field* is one such run: which agents fail for good, when, and how it ended. Nothing is run twice that is the same: a
field begins at the snapshot of the run without these failures (the *baseline*) at its first moment, and a field with
two failures goes on from the run with the first of them. That gives what a run from the start would give in which the
same failures stand on the mission's schedule; tests hold it against such runs.

Left to others: which fields there are together, and sharing them out over processes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.outcome import Outcome
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence

MOST_MOMENTS = 10_000
"""Moments of a sweep at most."""

STRETCH = 2000
"""Steps between two looks at whether the sweep is to be broken off."""
NOT_YET = 1 << 40
"""A step after every run: a failure is still to come, so nothing is certain yet."""


@dataclass(frozen=True, slots=True)
class Fault:
    """An agent, by its place in the team, fails for good before step `tick`."""

    agent: int
    tick: int


@dataclass(frozen=True, slots=True)
class Field:
    """One run of a sweep: its failures in order, how it ended and why, and its length in steps.

    A failure whose moment comes after the end of the run changed nothing.
    """

    faults: tuple[Fault, ...]
    outcome: Outcome
    sentence: str
    ticks: int


@dataclass(frozen=True, slots=True)
class Task:
    """The fields that begin with one failure: alone, or with each of `partners` failing at each later moment.

    Attributes:
        first: the failure.
        snapshot: the baseline at that moment.
        partners: agents that fail besides; those of the same moment stand behind `first` in the team, so that no pair
            is tried twice.
        moments: when they do, in steps, ascending, none before `first`; none for fields of one failure.
    """

    first: Fault
    snapshot: bytes
    partners: tuple[int, ...] = ()
    moments: tuple[int, ...] = ()

    @property
    def size(self) -> int:
        """How many fields it has."""
        if not self.moments:
            return 1
        others = [one for one in self.partners if one != self.first.agent]
        later = sum(moment > self.first.tick for moment in self.moments)
        at_once = sum(one > self.first.agent for one in others) if self.moments[0] == self.first.tick else 0
        return later * len(others) + at_once


class SweepStoppedError(KitRobotError):
    """A sweep was broken off in the middle of a field."""


def moments_of(ticks: int, count: int) -> tuple[int, ...]:
    """So many moments, or as many as there are steps, spread evenly over a run of so many steps from its first on."""
    return tuple(dict.fromkeys(number * ticks // count for number in range(count)))


def snapshots_at(
    simulation: Simulation, moments: Sequence[int], stop: Callable[[], bool] = lambda: False
) -> dict[int, bytes]:
    """The states of a run, which is at its first step, before these steps; it must not end before the last of them.

    Raises:
        SweepStoppedError: `stop` said so.
    """
    found = {}
    for moment in moments:
        _go_to(simulation, moment, stop)
        found[moment] = simulation.snapshot()
    return found


def run_task(simulation: Simulation, task: Task, stop: Callable[[], bool] = lambda: False) -> Iterator[Field]:
    """The fields of a task, with a simulation of the same run as the baseline, wherever it stands; it needs a limit.

    Raises:
        SweepStoppedError: `stop` said so.
    """
    agent, tick = task.first.agent, task.first.tick
    simulation.restore(task.snapshot)
    if not task.moments:
        simulation.plan_failures([(tick, agent)])
        yield _ended(simulation, (task.first,), stop)
        return
    simulation.plan_failures([(tick, agent), (NOT_YET, agent)])
    for moment in task.moments:
        _go_to(simulation, moment, stop)
        before = simulation.snapshot()
        for other in task.partners:
            if other == agent or (moment == tick and other < agent):
                continue
            simulation.restore(before)
            simulation.plan_failures([(tick, agent), (moment if simulation.outcome is None else NOT_YET, other)])
            yield _ended(simulation, (task.first, Fault(other, moment)), stop)
        simulation.restore(before)
        simulation.plan_failures([(tick, agent), (NOT_YET, agent)])


def _ended(simulation: Simulation, faults: tuple[Fault, ...], stop: Callable[[], bool]) -> Field:
    _go_to(simulation, None, stop)
    assert simulation.outcome is not None, "a run with a limit ends"
    return Field(faults, simulation.outcome, simulation.sentence, simulation.tick)


def _go_to(simulation: Simulation, tick: int | None, stop: Callable[[], bool]) -> None:
    """To before this step, or to the end of the run."""
    while simulation.outcome is None and (tick is None or simulation.tick < tick):
        if stop():
            raise SweepStoppedError(Sentence("the sweep was broken off"))
        simulation.advance(STRETCH if tick is None else min(STRETCH, tick - simulation.tick))
