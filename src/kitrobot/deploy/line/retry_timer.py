"""Timeouts of an answer, which distinguish a slow robot from a silent one.

A request is repeated, each time after a longer wait, until the line was silent for `silent_s`. Any complete frame of
the board (an answer to an earlier request, news) restarts that time; a board that sends frames but never the answer is
given up after `longest_s`. The number of attempts is not limited.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

ANSWER_S = 0.4
"""How long an answer is waited for before the first repetition."""

SILENT_S = 8.0
"""Without a sign of life for so long a running robot is silent: a person at the cable waits no longer gladly."""

MOST_SILENT_S = 30.0
"""The same for one that needed long for its answers before, at most."""

STARTING_S = 30.0
"""The same for a board that starts its program, which it cannot do and answer. One that fails says so at once."""

LONGEST_S = 60.0
"""The limit of the wait for a robot that sends other frames but no answer."""

PAUSE_S = 3.0
"""The longest wait between two tries."""


@dataclass
class RetryTimer:
    """Retries and their time limit, on the clock `now` (seconds). `most_s` is the longest wait between two tries."""

    now: Callable[[], float]
    first_s: float = ANSWER_S
    silent_s: float = SILENT_S
    longest_s: float = LONGEST_S
    most_s: float = PAUSE_S

    def __post_init__(self) -> None:
        self.began = self._heard = self.now()
        self._next = self.first_s

    def heard(self) -> None:
        """The board gave a sign of life."""
        self._heard = self.now()

    def left(self) -> float:
        """Seconds until it ends; 0 or less when it has."""
        return min(self._heard + self.silent_s, self.began + max(self.longest_s, self.silent_s)) - self.now()

    def wait(self) -> float:
        """How long to wait for the next try; 0 when the time is over."""
        wait, self._next = min(self._next, self.left()), min(2 * self._next, max(self.most_s, self.first_s))
        return max(wait, 0.0)
