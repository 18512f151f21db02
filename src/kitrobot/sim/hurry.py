"""When a run takes the compiled step: after enough work to be worth it, and only once it is there.

Compiling, or loading what was compiled, goes on beside the run, which takes its steps plain until then; both give the
same numbers, so nobody sees the change but by the clock.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kitrobot.sim import compiling

WORTH = 100_000
"""Steps of one robot in a run after which it asks for the compiled step: two or three seconds of plain work."""


class Hurry:
    """Counts the work of one run. `taken` says that its state is in arrays already."""

    def __init__(self, robots: int) -> None:
        self._robots = max(1, robots)
        self._work = 0
        self._asked = False
        self._advance: Callable[[Any, int], int] | None = None
        self.taken = False

    def advance_for(self, steps: int) -> Callable[[Any, int], int] | None:
        """The compiled step, if it is there; None: go on plain."""
        if self._advance is not None:
            return self._advance
        self._work += steps * self._robots
        if self._work >= WORTH:
            if not self._asked:
                self._asked = True
                compiling.ask()
            self._advance = compiling.compiled()
        return self._advance

    def wait(self) -> bool:
        """Takes the compiled step, waiting for it; False where there is none."""
        self._asked = True
        self._advance = compiling.wait()
        return self._advance is not None
