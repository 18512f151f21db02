"""When a run uses the compiled step: after enough work to be worth it, and once it is there.

The step is compiled, or loaded from the cache, on another thread; until then the run takes plain steps, which give the
same numbers. For a large team it is worth it from the first steps, and `expect_run` starts before such a run begins.
"""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.sim.jit.cache import is_missed
from kitrobot.sim.jit.compiler import Advance, step

WORTH = 100_000
"""Steps of one robot after which a run asks for the compiled step, its own and those of the runs before it in this
process together: a second or two of plain work."""

CROWD = 100
"""Robots of a run that is worth it nearly at once: plain, some hundreds are slower than real time."""

CROWD_WORTH = 2000
"""As `WORTH`, of a crowd."""

MANY = 30_000_000
"""Steps of one robot in many runs together for which it is worth waiting until the step is compiled: minutes."""

GAIN = 1_000_000
"""Steps of one robot, run plain, after which a run says that it would have gained by Numba: some ten seconds."""

AT_ONCE = 10_000
"""Steps of one robot that are run plain before it is asked again whether the compiled one is there."""


def expect_run(robots: int) -> None:
    """A run of so many robots may begin soon: has the compiled step made or loaded, if it is worth it for them."""
    if robots >= CROWD:
        step.ask()


def expect_many_runs(work: int) -> bool:
    """Whether runs in other processes, of so many steps of one robot together, are to use the compiled step.

    Where it is not kept and worth it, it is made here first, or each of them would make its own.
    """
    return step.is_kept() or (work >= MANY and step.wait() is not None)


def would_gain(work: int) -> bool:
    """Whether so many steps of one robot would have been much quicker if Numba were installed."""
    return work >= GAIN and is_missed()


@dataclass
class Work:
    """Plain steps of one robot."""

    steps: int = 0


done = Work()
"""Those of all runs of this process."""


class JitPolicy:
    """Counts the work of one run, and of all. `most` is how many steps to run plain at once."""

    def __init__(self, robots: int) -> None:
        self._robots = max(1, robots)
        self._work = 0
        self._asks_at = 0
        self._advance: Advance | None = None
        self.most = max(1, AT_ONCE // self._robots)

    def worked(self, steps: int) -> None:
        """So many steps were run plain."""
        self._work += steps * self._robots
        done.steps += steps * self._robots

    def compiled(self) -> Advance | None:
        """The compiled step, if it is worth it and there; None: go on plain."""
        if self._advance is None and (done.steps >= WORTH or (self._robots >= CROWD and self._work >= CROWD_WORTH)):
            # To ask looks at files: not before each step of a run that is watched step by step.
            if self._work >= self._asks_at:
                self._asks_at = self._work + AT_ONCE
                step.ask()
            self._advance = step.made
        return self._advance

    @property
    def would_gain(self) -> bool:
        """As the function of this name, for the steps that were run plain."""
        return would_gain(self._work)

    def wait(self) -> bool:
        """Takes the compiled step, waiting for it; False where there is none."""
        self._advance = step.wait()
        return self._advance is not None
