"""What makes the rows of a study: rows by number go in, lines come out, in any order, each once.

An executor is local processes (`local_workers`), this process itself, or a cluster (`cluster`). It loses no row that it
was given: a run whose process dies is made again, and after `MOST_DEATHS` it is a row that says so.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from kitrobot.experiments.plan import Function, Plan
from kitrobot.experiments.point_runner import DIED, Pace, PointRunner, RunStoppedError, Stop, row_bytes
from kitrobot.sim.jit.policy import expect_many_runs
from kitrobot.text.sentences import Sentence

MOST_DEATHS = 3
"""Processes that a run may take along before it is given up."""

STEPS_OF_A_RUN = 1000
"""About how long a run is, at least, in steps."""

WORTH_WAITING = 1_000_000
"""Steps of one robot in many runs for which a process waits some seconds for the compiled step before the first."""


@dataclass(frozen=True)
class Work:
    """Rows of a plan to make; `functions` are its measures in Python, by name."""

    plan: Plan
    rows: Iterable[int]
    count: int
    functions: Mapping[str, Function] = field(default_factory=dict)

    def pace(self) -> Pace:
        """How its runs come to the compiled step; where they wait for it, it is made now."""
        steps = self.count * max(1, self.plan.mission.count("<agent ")) * STEPS_OF_A_RUN
        if not expect_many_runs(steps):
            return Pace.PLAIN
        return Pace.COMPILED if steps >= WORTH_WAITING else Pace.AS_IT_COMES


class Executor(Protocol):
    """Makes the rows of some work; `stop` ends it early. Each piece that it gives is a line of `point_runner`."""

    def run(self, work: Work, stop: Stop) -> Iterator[bytes]: ...


class ThisProcess:
    """Makes the rows here, one after another."""

    def run(self, work: Work, stop: Stop) -> Iterator[bytes]:
        """The lines, in the order of the rows."""
        runner = PointRunner(work.plan, work.functions, work.pace(), stop)
        for row in work.rows:
            try:
                line = runner.run(row)
            except RunStoppedError:
                return
            yield line


def died_row(plan: Plan, row: int) -> bytes:
    """The row of a run that took its process along every time."""
    return row_bytes(plan, row, DIED, Sentence("its process died {count} times", MOST_DEATHS))
