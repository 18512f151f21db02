"""`Recurrence`: whether a program only looks again and again at what does not change.

A machine whose state comes back as it was, while it commanded and wrote nothing, does the same again for as long as its
inputs stay. The state is compared with one that is stored and replaced at ever longer distances (Brent's way to find a
cycle), so loops that wait a while between two looks are found too, whatever their period.
"""

from __future__ import annotations

Snapshot = tuple[list[int], list[int], list[int]]
"""As `Machine.snapshot` gives it."""


class Recurrence:
    """The states of one machine, tick by tick. `period`: of the cycle that it is in, in ticks; 0: none is known."""

    def __init__(self) -> None:
        self._sample: Snapshot | None = None
        self.reset()

    def reset(self) -> None:
        """The program did something."""
        self._sample = None
        self.period = self._distance = 0
        self._until = 1

    def repeats(self, state: Snapshot) -> bool:
        """Takes the state after a tick; whether the machine is in a cycle."""
        self._distance += 1
        if state == self._sample:
            self.period, self._distance = self._distance, 0
        elif self._distance > self.period > 0:
            self.period = 0
        if self._sample is None or (self.period == 0 and self._distance >= self._until):
            self._until = 1 if self._sample is None else 2 * self._until
            self._sample, self._distance = state, 0
        return self.period > 0
