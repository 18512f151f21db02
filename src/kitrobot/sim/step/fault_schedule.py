"""Failures as missions and people speak of them, for `fault_injection`: names, seconds, chances a minute."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.step.fault_injection import (
    APART,
    AWAY,
    BY_HAND,
    FAIL,
    HELD,
    MUTE,
    PLAN_ROWS,
    REVIVE,
    STALL,
    inject_fault,
)
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Recorded

KINDS = tuple(FailureKind)
"""The kinds in the order of their numbers in `fault_injection`."""

CAUSES = (
    Recorded("by hand"),
    Recorded("on schedule"),
    Recorded("by chance"),
    Recorded("its agent is away"),
    Recorded("it hears too few of its team"),
)
"""How it comes about, in the order of their numbers in `fault_injection`."""

MINUTE_MS = 60_000
MORE_PLANNED = 2
"""So many failures can be put on the schedule of a run that is set up."""
TURN_MS = 1000
"""How often each robot may fail by chance, in simulated time."""


@dataclass
class FaultPlan:
    """The faults that a run injects.

    Attributes:
        plan: the schedule, as rows of numbers (see faults).
        keys: room for the two keys of the chance of each robot.
        every: steps between two turns of a robot to fail by chance.
        probability: of failing in one turn, 0…1.
    """

    plan: list[list[int]] = field(default_factory=lambda: [[] for _ in range(PLAN_ROWS)])
    keys: list[list[int]] = field(default_factory=lambda: [[], []])
    every: int = 1
    probability: float = 0.0

    @property
    def revivals(self) -> int:
        """How many revivals are on the schedule."""
        return self.plan[2].count(REVIVE)

    def with_room(self) -> list[list[int]]:
        """The rows of the schedule, longer than it is."""
        return [row + [0] * MORE_PLANNED for row in self.plan]

    def most_events(self, robots: int, variables: int) -> int:
        """The most that can be told of failures in one step: who comes back tells its shared variables too."""
        at_once = max(Counter(self.plan[0]).values(), default=0) + MORE_PLANNED
        return at_once * (1 + variables) + (robots if self.probability else 0)


def fault_plan(failures: Sequence[Failure], names: Sequence[str], step_ms: int, fail_rate: float) -> FaultPlan:
    """What a mission's schedule and a failure rate come to in a run.

    Args:
        failures: the schedule; what happens to somebody who takes no part is passed over.
        names: the agents, in team order.
        step_ms: a step of the run.
        fail_rate: the probability (0…1) that an agent fails in a minute.
    """
    numbers = {name: number for number, name in enumerate(names)}
    rows = sorted(
        (
            (math.ceil(failure.at_s * 1000 / step_ms - 1e-9), numbers[failure.agent], KINDS.index(failure.kind))
            for failure in failures
            if failure.agent in numbers
        ),
        key=lambda row: row[0],
    )
    made = FaultPlan([list(row) for row in zip(*rows, strict=True)] if rows else [[] for _ in range(PLAN_ROWS)])
    if fail_rate > 0:
        made.every = max(1, round(TURN_MS / step_ms))
        made.probability = 1.0 - (1.0 - fail_rate) ** (made.every * step_ms / MINUTE_MS)
        made.keys = [[0] * len(names), [0] * len(names)]
    return made


def schedule_faults(plan: FaultPlan, more: Sequence[tuple[int, int]], state: State) -> None:
    """Puts these failures, (step, robot), behind what a run's schedule says of their steps, in the place of those that
    were put there before; they must not be before now.
    """
    assert len(more) <= MORE_PLANNED, "there is room for them"
    rows = [*zip(*plan.plan, strict=True), *((step, robot, FAIL) for step, robot in more)]
    rows.sort(key=lambda row: row[0])
    for column, table in enumerate(state.faults.plan):
        for number, row in enumerate(rows):
            table[number] = row[column]
    state.clock[c.PLANS] = len(rows)


def describe_fault(kind: int, cause: int) -> str:
    """A fault and its cause, as a sentence's predicate."""
    why = CAUSES[cause]
    if cause == HELD:
        return (
            Recorded("stands still ({why})", why) if kind == FAIL else Recorded("goes on, as it hears its team again")
        )
    if cause == AWAY and kind != FAIL:
        return Recorded("goes on, as its agent is back")
    if kind == FAIL:
        return Recorded("fails ({why})", why)
    if kind == STALL:
        return Recorded("stalls ({why})", why)
    if kind == APART:
        return Recorded("is cut off from the others ({why})", why)
    return Recorded("loses its radio ({why})", why) if kind == MUTE else Recorded("is well again ({why})", why)


def has_event_room(state: State, most: int) -> bool:
    """Whether there is room for so many more events, and for those of one step after them."""
    return c.EVENT * (state.clock[c.EVENTS] + most + state.fixed[c.MOST_EVENTS]) <= len(state.events)


def discard_reported_events(state: State) -> None:
    """Drops the events of past steps; those injected by hand since the last step are not yet reported and stay."""
    clock, events = state.clock, state.events
    tick, end = clock[c.TICK], c.EVENT * clock[c.EVENTS]
    first = next((at for at in range(0, end, c.EVENT) if events[at + c.EVENT - 1] == tick), end)
    for at in range(first, end):
        events[at - first] = events[at]
    clock[c.EVENTS] = (end - first) // c.EVENT


def inject_fault_by_hand(state: State, robot: int, kind: FailureKind, cause: int = BY_HAND) -> None:
    """Injects a fault between two steps, by hand or because of its agent; there must be room for its event."""
    inject_fault(robot, KINDS.index(kind), cause, state)
